#pragma once
// Colours of the pictures, all from formulas in the OKLab space (Ottosson 2020), where equal steps look
// equal.

#include <cstdint>

namespace ashlar::output {

struct Color {
  double r = 0, g = 0, b = 0;  ///< sRGB, 0 to 1
};

/// Lightness (0 to 1), chroma and hue in degrees; chroma is cut back to what sRGB can show.
Color oklch(double lightness, double chroma, double hue);

/// t in [0, 1]: dark violet, blue, teal, green, light yellow; lightness grows evenly.
Color sequential(double t);
/// t in [-1, 1]: dark blue, near white at 0, dark red; equal lightness at ±t.
Color diverging(double t);
/// Pale, for the areas of regions; neighbours in number differ well in hue.
Color region_tint(int region);
/// Strong, for curves; told apart by lightness too, so that they survive grey printing.
Color curve_color(int curve, int count);

/// 0xFFRRGGBB, as cairo's images store it.
std::uint32_t packed(Color color);
Color mixed(Color a, Color b, double share_of_b);

}  // namespace ashlar::output
