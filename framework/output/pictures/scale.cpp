#include "output/pictures/scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ashlar::output {

namespace {

constexpr double margin = 1e-9;  ///< keeps 0.30000000000000004 from being above 0.3

std::string with_minus(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, "\u2212");
  return text;
}

// 10⁻⁶ … 10⁹ where plain digits would be many.
UnitScale power_of_ten(double greatest) {
  if (greatest >= 0.01 && greatest < 1e5) return {1, ""};
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int power = 3 * static_cast<int>(std::floor(std::log10(greatest * (1 + margin)) / 3));
  std::string name = power < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(power))) name += digits[digit - '0'];
  return {std::pow(10, power), name};
}

}  // namespace

UnitScale place_scale(double size) {
  if (size >= 2e4) return {1e3, "km"};
  if (size >= 0.05) return {1, "m"};
  return size >= 5e-5 ? UnitScale{1e-3, "mm"} : UnitScale{1e-6, "µm"};
}

UnitScale unit_scale(const std::string& unit, double greatest) {
  struct Prefix {
    const char* name;
    double factor;
  };
  static constexpr std::array<Prefix, 7> prefixes = {
      {{"n", 1e-9}, {"µ", 1e-6}, {"m", 1e-3}, {"", 1}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}}};
  if (!(greatest > 0) || !std::isfinite(greatest)) return {1, unit};
  if (unit.empty()) return power_of_ten(greatest);
  if (unit == "deg") return {1, "°"};
  const bool large = unit[0] == 'P' || unit[0] == 'N';
  const std::size_t from = large ? 3 : 0, to = large ? 6 : 3;
  std::size_t best = from;
  for (std::size_t i = from; i <= to; ++i)
    if (greatest >= prefixes[i].factor * (1 - margin)) best = i;
  return {prefixes[best].factor, prefixes[best].name + unit};
}

double round_up(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double m : {1.0, 2.0, 2.5, 5.0})
    if (m * power >= x * (1 - margin)) return m * power;
  return 10 * power;
}

double round_down(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double m : {5.0, 2.0})
    if (m * power <= x * (1 + margin)) return m * power;
  return power;
}

std::vector<double> multiples(double low, double high, double step) {
  std::vector<double> values;
  const double first = std::ceil(low / step - 1e-6), last = std::floor(high / step + 1e-6);
  for (double i = first; i <= last; ++i) values.push_back(i * step);
  return values;
}

std::vector<double> ticks(double low, double high, int count) {
  return high > low ? multiples(low, high, round_up((high - low) / count)) : std::vector<double>{low};
}

std::string tick_text(double value, double step) {
  int decimals = 0;
  for (double s = std::abs(step); decimals < 12 && std::abs(s - std::round(s)) > 1e-6 * std::abs(s); s *= 10)
    ++decimals;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string result = text.data();
  if (result.find_first_not_of("-0.") == std::string::npos && result[0] == '-') result.erase(0, 1);
  return with_minus(result);
}

std::string value_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return with_minus(text.data());
}

std::string value_text(double value, const UnitScale& near, const std::string& unit) {
  const double size = std::abs(value) / near.factor;
  const bool readable = size == 0 || (size >= 0.01 && size < 1e4);
  const UnitScale scale = readable ? near : unit_scale(unit, std::abs(value));
  const std::string space = scale.name.empty() || scale.name == "°" ? "" : unit.empty() ? "·" : " ";
  return value_text(value / scale.factor) + (value == 0 && unit.empty() ? "" : space + scale.name);
}

double step_of_at_least(double step, double least) {
  for (double power = 1; power < 1e12; power *= 10)
    for (const double m : {1.0, 2.0, 5.0})
      if (m * power * step >= least * (1 - margin)) return m * power * step;
  return step;
}

Bands make_bands(double low, double high, double least, double greatest) {
  const double largest = std::max(std::abs(low), std::abs(high));
  // A field that is one number but for round-off is one band.
  if (!(high - low > 1e-9 * largest)) {
    const double step = largest > 0 ? round_up(largest) : 1;
    return {low - step / 2, step, {sequential(0.5)}, false, false};
  }
  Bands bands;
  bands.step = round_up((high - low) / 13);
  const double from = std::floor(low / bands.step + 1e-6), to = std::ceil(high / bands.step - 1e-6);
  bands.first = from * bands.step;
  const int count = static_cast<int>(to - from);
  const bool two_sided = std::min(-low, high) > 0.12 * std::max(-low, high);
  const double reach = std::max(-from, to);
  for (int i = 0; i < count; ++i)
    bands.colors.push_back(two_sided ? diverging((from + i + 0.5) / reach)
                                     : sequential(count == 1 ? 0.5 : static_cast<double>(i) / (count - 1)));
  const double slack = 1e-6 * bands.step;
  bands.open_below = least < bands.first - slack;
  bands.open_above = greatest > bands.edge(count) + slack;
  return bands;
}

}  // namespace ashlar::output
