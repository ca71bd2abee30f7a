#pragma once
// Curves over common axes with a frame, round ticks and a legend. Included by pictures/*.cpp only.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "output/pictures/canvas.hpp"
#include "output/pictures/scale.hpp"

namespace ashlar::output {

struct ChartCurve {
  std::string name;  ///< in the legend; markup as of Canvas::text
  std::vector<geometry::Point> points;
  /// A thick line that ends in a dot, a dashed one, or a thin one through marks at all points.
  enum class Look { line, dashes, discs, rings } look = Look::line;
  std::optional<Color> color = {};  ///< else one of its place among the curves
};

struct Chart {
  std::string x_label, y_label;  ///< markup, without unit; no room is kept for a label that is empty
  UnitScale x_unit, y_unit;
  std::vector<ChartCurve> curves;
  double height = 150;  ///< of the frame, in units of the page
  /// Of the axes in SI units; what lies outside is cut off. Else they hold all points.
  std::optional<std::array<double, 2>> x_range = {}, y_range = {};
};

/// Height of all that draw_chart draws: legend, frame, ticks and label.
double page_height(const Chart& chart);
/// With its upper edge at `top`, over the whole page width.
void draw_chart(Canvas& canvas, const Chart& chart, double top);

}  // namespace ashlar::output
