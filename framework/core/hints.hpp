#pragma once
// Guesses at what a user meant, for the advice of messages.

#include <string>

namespace ashlar::core {

/// "N/m^3" → "units.N/units.m^3" for the prefix "units.": a unit as scripts write it.
std::string unit_in_script(const std::string& unit, const std::string& prefix);

/// "12 m" or "12m" → "12*units.m"; empty if the text is no number with a known unit.
std::string product_in_script(const std::string& text, const std::string& prefix);

}  // namespace ashlar::core
