#pragma once
// What runs of rising size tell about the true value, and what accuracy costs.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ashlar::study {

/// One run of a refined sequence.
struct Refined {
  double h = 0;  ///< size of cells, or anything that errors shrink with
  double value = 0;
};

/// The value for h → 0 by Richardson's extrapolation: value(h) = limit + c h^order, fitted to three or more
/// runs with least squares weighted by 1/h. Grid-convergence index after Roache (1994), Eça and Hoekstra
/// (2014): uncertainty = safety · |limit − finest| + scatter of the fit. Safety is 1.25 for monotone runs of
/// an order from 0.5 to 4.5, else 3.
struct Extrapolation {
  double limit = 0;
  double order = 0;        ///< NaN if none was observed
  double uncertainty = 0;  ///< half width of the bracket around limit
  bool sound = false;      ///< false: the bracket is wide, and `why` says why
  std::string why;
};

/// Needs at least three different h; order of the runs does not matter. Runs that do not approach a limit
/// monotonically give the finest value with a bracket of three times the spread of the last three.
Extrapolation extrapolate(std::span<const Refined> runs);

/// Slope of log(y) over log(x) by least squares; NaN for fewer than two different x. Needs positive numbers.
double slope(std::span<const std::pair<double, double>> points);

/// A run as a bargain.
struct Bargain {
  double cost = 0, error = 0;
};

/// Runs that no other one beats in both, by rising cost and falling error; of equal ones the first.
std::vector<std::size_t> pareto_front(std::span<const Bargain> runs);

/// What an error costs on a front, by rising cost and falling error.
struct Price {
  enum class Known { at_most, between, beyond, unknown };
  double cost = 0;
  Known known = Known::unknown;     ///< beyond: extrapolated with the slope of the front's last three runs
  std::size_t left = 0, right = 0;  ///< the runs between which it lies (at_most: the first; beyond: the last)
};
/// Log-log interpolation. `unknown` where the front does not fall, or has one run only and does not reach it.
Price price_of(std::span<const Bargain> front, double error);

/// The least power of ten that is no less than x > 0; 0.1 for 0.1.
double ten_above(double x);

}  // namespace ashlar::study
