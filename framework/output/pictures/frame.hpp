#pragma once
// Where things stand on a page: the plot with its axes in metres, title, colour bar. Included by
// pictures/*.cpp only.

#include <optional>

#include "output/pictures/canvas.hpp"

namespace ashlar::output {

struct Bounds {
  double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
  void add(geometry::Point p);
};

struct Frame {
  enum class Bar { none, right, below };
  geometry::Point corner;        ///< upper left, in units
  double width = 0, height = 0;  ///< of the plot
  double left = 0, top = 0;      ///< metres at the corner
  double scale = 1;              ///< units per metre
  double page_height = 0;
  Bar bar = Bar::none;
  UnitScale unit{1, "m"};         ///< of the axes
  double x_step = 1, y_step = 1;  ///< between ticks [m]
  geometry::Point at(geometry::Point p) const {
    return {corner.x + (p.x - left) * scale, corner.y + (top - p.y) * scale};
  }
  View view() const { return {left, top, scale * pixels_per_unit}; }
  Image image() const;
};

/// One scale for both axes. A narrow or low body gets room beside it, so that ticks and labels find place.
/// The colour bar stands right of the plot, or lies below one that is wide and low; `bar_labels` is the width
/// of its widest number, nothing without a bar.
Frame make_frame(const Bounds& bounds, std::optional<double> bar_labels);
double bar_label_width(const Bands& bands, const UnitScale& unit);

void draw_title(Canvas& canvas, const std::string& title, const std::string& subtitle);
void draw_axes(Canvas& canvas, const Frame& frame);
void draw_bar(Canvas& canvas, const Frame& frame, const Bands& bands, const UnitScale& unit);

}  // namespace ashlar::output
