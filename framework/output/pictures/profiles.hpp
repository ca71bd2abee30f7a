#pragma once
// Profiles over an arc length: one panel a quantity, one curve a stage. Included by pictures/*.cpp only.

#include <string>
#include <vector>

#include "output/pictures/canvas.hpp"
#include "output/pictures/scale.hpp"

namespace ashlar::output {

struct ProfileRow {
  double s = 0;
  int piece = 0;  ///< changes where the curve is interrupted
  bool dashed = false;
  std::vector<double> values;  ///< by quantity; NaN: none
};

/// One stage's profile.
struct ProfileCurve {
  std::string stage;
  std::vector<ProfileRow> rows;
  Color color;
  /// Straight lines beside the curve: for each quantity none, or the values at the ends of the rows.
  std::vector<std::vector<geometry::Point>> lines;
};

struct ProfileQuantity {
  std::string symbol, unit;
};

struct Profiles {
  std::vector<ProfileCurve> curves;
  std::vector<ProfileQuantity> quantities;
  std::string s_label;
};

/// Gives the curves their colours, the last stage the strongest.
void color_curves(std::vector<ProfileCurve>& curves);
/// Height of title, legend, panels and labels.
double page_height(const Profiles& profiles);
/// All of it but the title.
void draw_profiles(Canvas& canvas, const Profiles& profiles);

}  // namespace ashlar::output
