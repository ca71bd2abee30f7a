#include "output/pictures/chart.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::output {

using geometry::Point;

namespace {

constexpr double left = 52, right = page_width - 14, legend = 15, foot = 30;
const LineStyle axis_line{{0.13, 0.14, 0.16}, 0.6};
const LineStyle grid_line{{0.86, 0.87, 0.88}, 0.45};
const LineStyle zero_line{{0.6, 0.61, 0.63}, 0.55};
const TextStyle tick_style{7.5};

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

/// A range of shown values, with room at both ends.
struct Range {
  double low = INFINITY, high = -INFINITY;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void open() {
    if (!(high >= low)) low = 0, high = 1;
    const double room = high > low ? 0.05 * (high - low) : std::max(0.5, 0.05 * std::abs(low));
    low -= room;
    high += room;
  }
};

struct Axes {
  const Chart& chart;
  double top;
  Range x, y;
  Axes(const Chart& drawn, double frame_top) : chart(drawn), top(frame_top) {
    for (const ChartCurve& curve : chart.curves)
      for (const Point& p : curve.points) x.add(p.x / chart.x_unit.factor), y.add(p.y / chart.y_unit.factor);
    x.open();
    y.open();
  }
  double across(double shown) const { return left + (shown - x.low) / (x.high - x.low) * (right - left); }
  double down(double shown) const {
    return top + chart.height - (shown - y.low) / (y.high - y.low) * chart.height;
  }
  Point at(Point p) const { return {across(p.x / chart.x_unit.factor), down(p.y / chart.y_unit.factor)}; }
};

double step_of(const std::vector<double>& marks) {
  return marks.size() > 1 ? marks[1] - marks[0] : 1;
}

void draw_grid(Canvas& canvas, const Axes& axes) {
  const double top = axes.top, bottom = axes.top + axes.chart.height;
  const auto xs = ticks(axes.x.low, axes.x.high, 7), ys = ticks(axes.y.low, axes.y.high, 6);
  const auto style = [](double value, double step) {
    return std::abs(value) < 1e-9 * step ? zero_line : grid_line;
  };
  for (const double value : xs) {
    const double x = axes.across(value);
    canvas.line({x, top}, {x, bottom}, style(value, step_of(xs)));
    canvas.line({x, bottom}, {x, bottom + 2.6}, axis_line);
    canvas.text(x, bottom + 11, tick_text(value, step_of(xs)), aligned(tick_style, Align::center));
  }
  for (const double value : ys) {
    const double y = axes.down(value);
    canvas.line({left, y}, {right, y}, style(value, step_of(ys)));
    canvas.line({left - 2.6, y}, {left, y}, axis_line);
    canvas.text(left - 5, y + 2.7, tick_text(value, step_of(ys)), aligned(tick_style, Align::right));
  }
}

std::string with_unit(const std::string& label, const UnitScale& unit) {
  return unit.name.empty() ? label : label + " [" + unit.name + "]";
}

}  // namespace

double page_height(const Chart& chart) {
  return legend + chart.height + foot;
}

void draw_chart(Canvas& canvas, const Chart& chart, double top) {
  const Axes axes(chart, top + legend);
  const double bottom = axes.top + chart.height;
  draw_grid(canvas, axes);
  double x = left;
  const int count = static_cast<int>(chart.curves.size());
  for (int i = 0; i < count; ++i) {
    const ChartCurve& curve = chart.curves[i];
    const Color color = curve_color(i, count);
    std::vector<Point> line;
    for (const Point& p : curve.points) line.push_back(axes.at(p));
    canvas.polyline(line, {color, 1.3});
    if (!line.empty()) canvas.disc(line.back(), 1.6, color, {{1, 1, 1}, 0.3});
    if (curve.name.empty()) continue;
    canvas.line({x, axes.top - 7}, {x + 13, axes.top - 7}, {color, 1.5});
    canvas.text(x + 17, axes.top - 4.4, curve.name, tick_style);
    x += 31 + canvas.text_width(curve.name, tick_style);
  }
  const Point ring[] = {{left, axes.top}, {right, axes.top}, {right, bottom}, {left, bottom}};
  canvas.polyline(ring, axis_line, true);
  canvas.text((left + right) / 2, bottom + 23, with_unit(chart.x_label, chart.x_unit),
              aligned({8.5}, Align::center));
  TextStyle turned = aligned({8.5}, Align::center);
  turned.turn = 1;
  canvas.text(15, (axes.top + bottom) / 2, with_unit(chart.y_label, chart.y_unit), turned);
}

}  // namespace ashlar::output
