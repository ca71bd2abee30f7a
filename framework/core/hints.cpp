#include "core/hints.hpp"

#include <cctype>
#include <cstdlib>
#include <stdexcept>

#include "core/units.hpp"

namespace ashlar::core {

std::string unit_in_script(const std::string& unit, const std::string& prefix) {
  const auto letter = [&](std::size_t i) { return std::isalpha(static_cast<unsigned char>(unit[i])) != 0; };
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (letter(i) && (i == 0 || !letter(i - 1))) text += prefix;
    text += unit[i];
  }
  return text;
}

std::string product_in_script(const std::string& text, const std::string& prefix) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  const std::string number = text.substr(0, static_cast<std::size_t>(end - text.c_str()));
  std::string unit = end;
  std::erase(unit, ' ');
  if (number.empty() || unit.empty()) return {};
  try {
    if (parse_dimension(unit) == Dimension{}) return {};
  } catch (const std::invalid_argument&) {
    return {};
  }
  return number + "*" + unit_in_script(unit, prefix);
}

}  // namespace ashlar::core
