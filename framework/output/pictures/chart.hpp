#pragma once
// Curves over common axes with a frame, round ticks and a legend. Included by pictures/*.cpp only.

#include <string>
#include <vector>

#include "output/pictures/canvas.hpp"
#include "output/pictures/scale.hpp"

namespace ashlar::output {

struct ChartCurve {
  std::string name;  ///< in the legend; markup as of Canvas::text
  std::vector<geometry::Point> points;
};

struct Chart {
  std::string x_label, y_label;  ///< markup, without unit
  UnitScale x_unit, y_unit;
  std::vector<ChartCurve> curves;
  double height = 150;  ///< of the frame, in units of the page
};

/// Height of all that draw_chart draws: legend, frame, ticks and label.
double page_height(const Chart& chart);
/// With its upper edge at `top`, over the whole page width.
void draw_chart(Canvas& canvas, const Chart& chart, double top);

}  // namespace ashlar::output
