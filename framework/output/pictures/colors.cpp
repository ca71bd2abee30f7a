#include "output/pictures/colors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ashlar::output {

namespace {

double gamma(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

// OKLab to linear sRGB: Ottosson, "A perceptual color space for image processing" (2020).
Color linear_rgb(double L, double a, double b) {
  const double l = std::pow(L + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(L - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(L - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool shown(Color c) {
  auto in = [](double x) { return x >= -1e-6 && x <= 1 + 1e-6; };
  return in(c.r) && in(c.g) && in(c.b);
}

}  // namespace

Color oklch(double lightness, double chroma, double hue) {
  const double angle = hue * std::numbers::pi / 180;
  auto at = [&](double c) { return linear_rgb(lightness, c * std::cos(angle), c * std::sin(angle)); };
  double good = 0, bad = chroma;
  if (shown(at(chroma))) good = chroma;
  for (int i = 0; i < 24 && good < chroma; ++i) {
    const double middle = (good + bad) / 2;
    (shown(at(middle)) ? good : bad) = middle;
  }
  const Color c = at(good);
  auto channel = [](double x) { return gamma(std::clamp(x, 0.0, 1.0)); };
  return {channel(c.r), channel(c.g), channel(c.b)};
}

Color sequential(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return oklch(0.30 + 0.64 * t, 0.125 + 0.055 * t, 300 - 192 * t);
}

Color diverging(double t) {
  t = std::clamp(t, -1.0, 1.0);
  const double strength = std::abs(t);
  return oklch(0.965 - 0.56 * std::pow(strength, 1.15), 0.19 * std::pow(strength, 0.85), t < 0 ? 255 : 29);
}

Color region_tint(int region) {
  // The golden angle keeps any number of hues apart; warm grey first, as most scenes have rock first.
  if (region == 0) return oklch(0.925, 0.018, 85);
  return oklch(0.925, 0.034, 240 + 137.508 * (region - 1));
}

Color curve_color(int curve, int count) {
  return sequential(count < 2 ? 0.25 : 0.06 + 0.62 * curve / (count - 1));
}

std::uint32_t packed(Color c) {
  auto byte = [](double x) { return static_cast<std::uint32_t>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
  return 0xFF000000u | byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
}

Color mixed(Color a, Color b, double share) {
  auto mix = [share](double x, double y) { return x + share * (y - x); };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace ashlar::output
