#include "core/units.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

namespace ashlar::core {

namespace {

constexpr Dimension none{0, 0, 0}, length{1, 0, 0}, mass{0, 1, 0}, duration{0, 0, 1};
constexpr Dimension force{1, 1, -2}, pressure{-1, 1, -2}, energy{2, 1, -2}, work_rate{2, 1, -3};

}  // namespace

Dimension operator*(Dimension a, Dimension b) {
  auto sum = [](int x, int y) { return static_cast<std::int8_t>(x + y); };
  return {sum(a.length, b.length), sum(a.mass, b.mass), sum(a.time, b.time)};
}

Dimension operator/(Dimension a, Dimension b) {
  return a * power(b, -1);
}

Dimension power(Dimension a, int exponent) {
  auto scaled = [exponent](int x) { return static_cast<std::int8_t>(x * exponent); };
  return {scaled(a.length), scaled(a.mass), scaled(a.time)};
}

const std::vector<Unit>& unit_table() {
  static const std::vector<Unit> table = {
      {"m", 1, length, "metre"},
      {"mm", 1e-3, length, "millimetre"},
      {"cm", 1e-2, length, "centimetre"},
      {"km", 1e3, length, "kilometre"},
      {"kg", 1, mass, "kilogram"},
      {"g", 1e-3, mass, "gram"},
      {"t", 1e3, mass, "tonne"},
      {"s", 1, duration, "second"},
      {"min", 60, duration, "minute"},
      {"h", 3600, duration, "hour"},
      {"day", 86400, duration, "day"},
      {"year", 365.25 * 86400, duration, "Julian year, 365.25 days"},
      {"N", 1, force, "newton"},
      {"kN", 1e3, force, "kilonewton"},
      {"MN", 1e6, force, "meganewton"},
      {"GN", 1e9, force, "giganewton"},
      {"Pa", 1, pressure, "pascal"},
      {"kPa", 1e3, pressure, "kilopascal"},
      {"MPa", 1e6, pressure, "megapascal"},
      {"GPa", 1e9, pressure, "gigapascal"},
      {"J", 1, energy, "joule"},
      {"kJ", 1e3, energy, "kilojoule"},
      {"W", 1, work_rate, "watt"},
      {"deg", std::numbers::pi / 180, none, "degree of angle"},
      {"rad", 1, none, "radian"},
      {"percent", 1e-2, none, "one hundredth"},
  };
  return table;
}

namespace {

const Unit* find_unit(const std::string& name) {
  for (const Unit& unit : unit_table())
    if (unit.name == name) return &unit;
  return nullptr;
}

// "m^3" or "1"
Dimension parse_factor(const std::string& text, const std::string& whole) {
  const auto caret = text.find('^');
  const std::string name = text.substr(0, caret);
  int exponent = 1;
  if (caret != std::string::npos) {
    std::size_t used = 0;
    const std::string digits = text.substr(caret + 1);
    try {
      exponent = std::stoi(digits, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used == 0 || used != digits.size() || std::abs(exponent) > 9)
      throw std::invalid_argument("'" + whole + "' has a bad exponent '" + digits + "'");
  }
  if (name == "1") return none;
  const Unit* unit = find_unit(name);
  if (!unit) throw std::invalid_argument("'" + whole + "' names no unit: '" + name + "'");
  return power(unit->dimension, exponent);
}

}  // namespace

Dimension parse_dimension(const std::string& text) {
  std::string packed;
  for (char c : text)
    if (c != ' ') packed += c;
  if (packed.empty()) return none;
  Dimension result;
  char sign = '*';
  for (std::size_t begin = 0;;) {
    const std::size_t end = packed.find_first_of("*/", begin);
    const Dimension factor = parse_factor(packed.substr(begin, end - begin), text);
    result = sign == '*' ? result * factor : result / factor;
    if (end == std::string::npos) return result;
    sign = packed[end];
    begin = end + 1;
  }
}

namespace {

void append(std::string& text, const char* name, int exponent) {
  if (exponent == 0) return;
  if (!text.empty() && text.back() != '/') text += '*';
  text += name;
  if (exponent != 1) text += "^" + std::to_string(exponent);
}

}  // namespace

std::string to_string(Dimension dimension) {
  if (dimension == none) return {};
  if (dimension == pressure) return "Pa";
  if (dimension == pressure * duration) return "Pa*s";
  if (dimension == work_rate) return "W";
  // Force is the engineer's base quantity whenever time enters as in a force.
  const bool forces = dimension.mass != 0 && dimension.time == -2 * dimension.mass;
  const Dimension rest = forces ? dimension / power(force, dimension.mass) : dimension;
  struct Part {
    const char* name;
    int exponent;
  };
  const std::array<Part, 4> parts = {
      {{"N", forces ? dimension.mass : 0}, {"kg", rest.mass}, {"m", rest.length}, {"s", rest.time}}};
  std::string text;
  for (const Part& part : parts)
    if (part.exponent > 0) append(text, part.name, part.exponent);
  if (text.empty()) text = "1";
  for (const Part& part : parts) {
    if (part.exponent >= 0) continue;
    text += '/';
    append(text, part.name, -part.exponent);
  }
  return text;
}

namespace {

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

struct Scale {
  const char* name;
  double factor;
};

template <std::size_t count>
std::string scaled(double value, const std::array<Scale, count>& scales) {
  const Scale* best = scales.data();
  // The margin keeps 1000 m that was computed as 999.9999999999999 m from reading "1000 m".
  for (const Scale& scale : scales)
    if (std::abs(value) >= scale.factor * (1 - 1e-9)) best = &scale;
  return short_number(value / best->factor) + " " + best->name;
}

}  // namespace

std::string format_quantity(double value, Dimension dimension) {
  if (dimension == none) return short_number(value);
  const std::string si = to_string(dimension);
  if (value == 0 || !std::isfinite(value)) return short_number(value) + " " + si;
  if (dimension == length) return scaled(value, std::array<Scale, 3>{{{"mm", 1e-3}, {"m", 1}, {"km", 1e3}}});
  if (dimension == duration)
    return scaled(value, std::array<Scale, 5>{
                             {{"s", 1}, {"min", 60}, {"h", 3600}, {"day", 86400}, {"year", 365.25 * 86400}}});
  if (dimension == mass) return scaled(value, std::array<Scale, 2>{{{"kg", 1}, {"t", 1e3}}});
  const bool takes_prefix = si.starts_with("N/") || si == "N" || si.starts_with("N*") || si.starts_with("Pa");
  if (!takes_prefix) return short_number(value) + " " + si;
  const std::string kilo = "k" + si, mega = "M" + si, giga = "G" + si;
  return scaled(value, std::array<Scale, 4>{
                           {{si.c_str(), 1}, {kilo.c_str(), 1e3}, {mega.c_str(), 1e6}, {giga.c_str(), 1e9}}});
}

}  // namespace ashlar::core
