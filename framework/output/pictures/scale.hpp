#pragma once
// Round numbers: units with engineering prefixes, ticks, contour bands.

#include <string>
#include <vector>

#include "output/pictures/colors.hpp"

namespace ashlar::output {

/// shown value = value / factor.
struct UnitScale {
  double factor = 1;
  std::string name;  ///< "MPa"
};
/// The prefix in which `greatest` (SI) reads as a number from 1 to 1000: mm, kPa, MN … Numbers without a unit
/// that are small or large take a power of ten: "10⁻³".
UnitScale unit_scale(const std::string& unit, double greatest);
/// The unit for places on a body of this size: mm below 0.05 m, km from 20 km on.
UnitScale place_scale(double size);

/// The least of 1, 2, 2.5 and 5 times a power of ten that is not below x > 0.
double round_up(double x);
/// The greatest of 1, 2 and 5 times a power of ten that is not above x > 0.
double round_down(double x);
/// Multiples of a round step inside [low, high], about `count` of them.
std::vector<double> ticks(double low, double high, int count);
/// Multiples of `step` inside [low, high].
std::vector<double> multiples(double low, double high, double step);
/// Text with as many decimals as a scale of this step needs; a true minus sign.
std::string tick_text(double value, double step);
/// Four significant digits; a true minus sign.
std::string value_text(double value);
/// "12.3 MPa": in `near`, or in a unit of its own where that would take many zeros.
std::string value_text(double value, const UnitScale& near, const std::string& unit);
/// The least multiple 1, 2, 5, 10 … of `step` that is at least `least`.
double step_of_at_least(double step, double least);

/// Contour bands between multiples of a round step. Values outside take the end bands' colours.
struct Bands {
  double first = 0, step = 1;                   ///< SI
  std::vector<Color> colors;                    ///< one a band
  bool open_below = false, open_above = false;  ///< some values lie outside
  double edge(int i) const { return first + i * step; }
  int count() const { return static_cast<int>(colors.size()); }
};

/// Six to fourteen bands over [low, high], the range to be told apart; [least, greatest] is what the field
/// holds. A range well on both sides of zero takes the diverging colours, white at zero.
Bands make_bands(double low, double high, double least, double greatest);

}  // namespace ashlar::output
