#include "core/readings.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

namespace ashlar::core {

std::optional<double> read_angle(const Settings& settings, const char* key, AngleRange range,
                                 Mistakes& mistakes) {
  constexpr double degree = std::numbers::pi / 180;
  const double angle = settings.number(key);
  // 90*u.deg may come out a rounding error beside the limit.
  const double slack = 1e-12;
  const double degrees = angle / degree;
  const bool above = range.high_open ? degrees >= range.high - slack : degrees > range.high + slack;
  if (degrees >= range.low - slack && !above) return angle;
  std::ostringstream what, advice;
  what << "must be " << (range.high_open ? "from " : "between ") << range.low << "° "
       << (range.high_open ? "to below " : "and ") << range.high << "°, got " << degrees << "°";
  if (angle > range.low && angle <= range.high)
    advice << "a bare number is in radians: for " << angle << "° write " << angle << "*units.deg";
  mistakes.add(settings.place_of(key), what.str(), advice.str());
  return {};
}

NumberTable read_numbers(const Settings& settings, const char* key, Mistakes& mistakes) {
  NumberTable numbers;
  const Table* table = settings.has(key) ? settings.value(key).table() : nullptr;
  if (!table) return numbers;
  for (const auto& [name, value] : table->entries) {
    const Quantity* number = value.quantity();
    if (!number) {
      mistakes.add(value.place, "must be a number, got " + value.type_name());
      continue;
    }
    numbers.names.push_back(name);
    numbers.values.push_back(number->value);
  }
  return numbers;
}

}  // namespace ashlar::core
