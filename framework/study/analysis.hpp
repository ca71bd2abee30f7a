#pragma once
// From runs to what they say: references, errors, orders, the front of best bargains, and sentences.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "study/numerics.hpp"
#include "study/outcome.hpp"

namespace ashlar::study {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Relative errors below this are round-off: nothing is to be had for more cost.
constexpr double floor_of_errors = 1e-12;

/// Cases that differ in the refined parameter only, from coarse to fine.
struct Series {
  std::string label;               ///< "mesh = voronoi"
  std::string problem;             ///< "level = 12 m"; "" if there is but one
  std::vector<std::size_t> cases;  ///< those that ran
};

/// What the runs of one problem are compared with.
struct Reference {
  double value = unknown;
  double uncertainty = 0;             ///< NaN: unknown
  std::string how;                    ///< "limit of mesh = voronoi, order 1.3"
  std::optional<std::size_t> itself;  ///< the case that serves as reference, and has no error of its own
};

struct Reading {
  std::size_t one = 0;  ///< the case
  double value = 0;
  double error = unknown;     ///< |value − reference|
  double relative = unknown;  ///< to |reference|; absolute if that is 0
  double sure = unknown;      ///< the greatest relative error of this run and all finer ones of its series
  bool on_front = false;      ///< no run is cheaper (wall time) and surer
};

struct Limit {
  std::string series;
  Extrapolation found;
  double observed = unknown;  ///< slope of the errors over h
};

/// One step of the ladder "this accuracy costs that much".
struct Rung {
  double error = 0;  ///< relative
  Price price;
  std::string with;  ///< the series that gives it
  std::string from;  ///< the case, or the two, that it is read from
};

/// A measure in one problem.
struct Finding {
  std::size_t measure = 0;
  std::string problem;
  Reference reference;
  bool absolute = false;  ///< the reference is 0: `relative` and `sure` are absolute
  std::vector<Reading> readings;
  std::vector<std::size_t> front;  ///< into readings, by rising cost
  std::vector<Limit> limits;
  std::vector<Rung> ladder;
  std::vector<std::string> sentences;
};

struct Analysis {
  std::vector<Series> series;
  std::vector<Finding> findings;
  bool sizes_differ = false;  ///< the cases have different numbers of unknowns: cost is worth a plot
};

/// The exact value of a measure whose reference is a function of the case.
using Exact = std::function<double(const Measure&, const Case&)>;

Analysis analyse(const Study& study, const std::vector<Outcome>& outcomes, const Exact& exact);

/// Fills the ladder too. "0.1 % of the settlement of the crest costs 0.40 s with mesh = voronoi; …"
std::vector<std::string> sentences_of(const Study& study, Finding& finding,
                                      const std::vector<Outcome>& outcomes, bool sizes_differ);

/// "0.1 %", "2.3e-05 %"; "1.2e-6 m" for absolute errors.
std::string accuracy_text(double error, bool absolute, const std::string& unit);
/// Rounded to two digits: nobody knows an uncertainty better.
double two_digits(double value);
/// "0.40 s", "12 ms", "3.2 min".
std::string time_text(double seconds);

}  // namespace ashlar::study
