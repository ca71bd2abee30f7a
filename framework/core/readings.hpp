#pragma once
// What laws of several modules read from their settings: angles and tables of named numbers.

#include <optional>

#include "core/schema.hpp"

namespace ashlar::core {

/// An angle [rad] between the limits (themselves allowed or not as `open` says), or nothing and a mistake.
/// Scripts write 30*units.deg; a bare number is in radians, as SI has it.
struct AngleRange {
  double low = 0, high = 0;  ///< degrees
  bool high_open = false;
};
std::optional<double> read_angle(const Settings& settings, const char* key, AngleRange range,
                                 Mistakes& mistakes);

/// The named numbers of a table; none if it was not said. What is no number is a mistake.
NumberTable read_numbers(const Settings& settings, const char* key, Mistakes& mistakes);

}  // namespace ashlar::core
