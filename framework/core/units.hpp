#pragma once
// Dimensions of physical quantities as exponents of metre, kilogram and second. Values are always SI.

#include <cstdint>
#include <string>
#include <vector>

namespace ashlar::core {

struct Dimension {
  std::int8_t length = 0;
  std::int8_t mass = 0;
  std::int8_t time = 0;
  bool operator==(const Dimension&) const = default;
};

Dimension operator*(Dimension a, Dimension b);
Dimension operator/(Dimension a, Dimension b);
Dimension power(Dimension a, int exponent);

/// Standard gravity, CGPM 1901 [m/s²].
constexpr double standard_gravity = 9.80665;

/// One unit name that scripts may use: `units.GPa`.
struct Unit {
  std::string name;
  double factor = 1;  ///< in SI
  Dimension dimension;
  std::string doc;
};

/// All unit names (m, mm, km, kg, t, s, h, day, N, kN, MN, Pa, kPa, MPa, GPa, deg, rad, …).
const std::vector<Unit>& unit_table();

/// "Pa/m" → its dimension. Understands the names of `unit_table`, `*`, `/`, `^` and "1" (or "").
/// Throws std::invalid_argument on an unknown name.
Dimension parse_dimension(const std::string& text);

/// "Pa", "N/m^3", "m/s^2": a readable SI name; "" for a pure number.
std::string to_string(Dimension dimension);

/// A value with a readable engineering prefix: "10 GPa", "3.2 mm", "0.3".
std::string format_quantity(double value, Dimension dimension);

}  // namespace ashlar::core
