#include "output/pictures/chart.hpp"

#include <algorithm>
#include <cmath>

#include "output/pictures/legend.hpp"

namespace ashlar::output {

using geometry::Point;
using Look = ChartCurve::Look;

namespace {

constexpr double left = 52, right = page_width - 14, legend = 15, foot = 30, foot_without_label = 16;
const LineStyle axis_line{{0.13, 0.14, 0.16}, 0.6};
const LineStyle grid_line{{0.86, 0.87, 0.88}, 0.45};
const LineStyle zero_line{{0.6, 0.61, 0.63}, 0.55};
const TextStyle tick_style = legend_style;

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

/// A range of shown values: as asked for, or with room at both ends.
struct Range {
  double low = INFINITY, high = -INFINITY;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void open(const std::optional<std::array<double, 2>>& asked, const UnitScale& unit) {
    if (asked) {
      low = (*asked)[0] / unit.factor;
      high = (*asked)[1] / unit.factor;
      return;
    }
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
    x.open(chart.x_range, chart.x_unit);
    y.open(chart.y_range, chart.y_unit);
  }
  double across(double shown) const { return left + (shown - x.low) / (x.high - x.low) * (right - left); }
  double down(double shown) const {
    return top + chart.height - (shown - y.low) / (y.high - y.low) * chart.height;
  }
  std::vector<Point> at(const std::vector<Point>& points) const {
    std::vector<Point> places;
    for (const Point& p : points)
      places.push_back({across(p.x / chart.x_unit.factor), down(p.y / chart.y_unit.factor)});
    return places;
  }
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

Color color_of(const Chart& chart, std::size_t curve) {
  return chart.curves[curve].color.value_or(
      curve_color(static_cast<int>(curve), static_cast<int>(chart.curves.size())));
}

void draw_mark(Canvas& canvas, Point at, Look look, Color color) {
  if (look == Look::rings) canvas.disc(at, 1.7, {1, 1, 1}, {color, 0.8});
  if (look == Look::discs) canvas.disc(at, 1.7, color, {{1, 1, 1}, 0.3});
}

LineStyle line_of(Look look, Color color) {
  if (look == Look::line) return {color, 1.3};
  return look == Look::dashes ? LineStyle{color, 1, 3} : LineStyle{color, 0.5};
}

void draw_marks(Canvas& canvas, const Axes& axes, const ChartCurve& curve, Color color) {
  const std::vector<Point> places = axes.at(curve.points);
  for (const Point& at : places) draw_mark(canvas, at, curve.look, color);
  if (!places.empty() && curve.look == Look::line) canvas.disc(places.back(), 1.6, color, {{1, 1, 1}, 0.3});
}

std::vector<Point> places_of(const Chart& chart, double top) {
  std::vector<std::string> names;
  for (const ChartCurve& curve : chart.curves)
    if (!curve.name.empty()) names.push_back(curve.name);
  return legend_places(names, {left, top + legend - 7}, right);
}

double legend_height(const Chart& chart) {
  const std::vector<Point> places = places_of(chart, 0);
  return legend + (places.empty() ? 0 : places.back().y - places.front().y);
}

void draw_legend(Canvas& canvas, const Chart& chart, double top) {
  const std::vector<Point> places = places_of(chart, top);
  for (std::size_t i = 0, named = 0; i < chart.curves.size(); ++i) {
    const ChartCurve& curve = chart.curves[i];
    if (curve.name.empty()) continue;
    const auto [x, y] = places[named++];
    LineStyle stroke = line_of(curve.look, color_of(chart, i));
    if (curve.look == Look::line) stroke.width = 1.5;
    canvas.line({x, y}, {x + legend_stroke, y}, stroke);
    draw_mark(canvas, {x + legend_stroke / 2, y}, curve.look, color_of(chart, i));
    canvas.text(x + legend_text, y + 2.6, curve.name, tick_style);
  }
}

}  // namespace

double page_height(const Chart& chart) {
  return legend_height(chart) + chart.height + (chart.x_label.empty() ? foot_without_label : foot);
}

void draw_chart(Canvas& canvas, const Chart& chart, double top) {
  const Axes axes(chart, top + legend_height(chart));
  const double bottom = axes.top + chart.height;
  draw_grid(canvas, axes);
  draw_legend(canvas, chart, top);
  // Lines stay inside the frame; marks may stand on it.
  canvas.clipped({left, axes.top}, right - left, chart.height, [&] {
    for (std::size_t i = 0; i < chart.curves.size(); ++i)
      canvas.polyline(axes.at(chart.curves[i].points), line_of(chart.curves[i].look, color_of(chart, i)));
  });
  canvas.clipped({left - 2, axes.top - 2}, right - left + 4, chart.height + 4, [&] {
    for (std::size_t i = 0; i < chart.curves.size(); ++i)
      draw_marks(canvas, axes, chart.curves[i], color_of(chart, i));
  });
  const Point ring[] = {{left, axes.top}, {right, axes.top}, {right, bottom}, {left, bottom}};
  canvas.polyline(ring, axis_line, true);
  if (!chart.x_label.empty())
    canvas.text((left + right) / 2, bottom + 23, with_unit(chart.x_label, chart.x_unit),
                aligned({8.5}, Align::center));
  TextStyle turned = aligned({8.5}, Align::center);
  turned.turn = 1;
  canvas.text(15, (axes.top + bottom) / 2, with_unit(chart.y_label, chart.y_unit), turned);
}

}  // namespace ashlar::output
