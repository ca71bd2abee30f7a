#include "output/pictures/frame.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::output {

using geometry::Point;

namespace {

constexpr double title_height = 34, axis_height = 31, axis_width = 41;
constexpr double bar_right = 66, bar_below = 34, bar_thickness = 9;
constexpr double bar_beside = 31;  ///< bar and gaps, without its numbers
constexpr double tallest_plot = 330, least_width = 140, least_height = 66;
const TextStyle tick_style{7.5};
const TextStyle label_style{8.5};
const LineStyle axis_line{{0.13, 0.14, 0.16}, 0.6};
const LineStyle rim{{0.13, 0.14, 0.16}, 0.45};

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

// Whole pixels keep images sharp.
double snapped(double units) {
  return std::round(units * pixels_per_unit) / pixels_per_unit;
}

struct Span {
  double low = 0, high = 0;
  double length() const { return high - low; }
};
Span x_span(const Frame& f) {
  return {f.left, f.left + f.width / f.scale};
}
Span y_span(const Frame& f) {
  return {f.top - f.height / f.scale, f.top};
}

double widest_tick(const Span& span, double step, const UnitScale& unit) {
  double widest = 0;
  for (const double at : multiples(span.low, span.high, step))
    widest = std::max(widest, measured(tick_text(at / unit.factor, step / unit.factor), tick_style));
  return widest;
}

// Equal steps on both axes, but at least two on the shorter one, and no closer than the numbers allow.
void choose_steps(Frame& frame) {
  const Span x = x_span(frame), y = y_span(frame);
  const double step = round_down(std::max(x.length(), y.length()) / 4);
  frame.x_step = std::min(step, round_down(x.length() / 3));
  frame.y_step = std::min(step, round_down(y.length() / 3));
  const double wide = widest_tick(x, frame.x_step, frame.unit) + 8;
  frame.x_step = step_of_at_least(frame.x_step, wide / frame.scale);
  frame.y_step = step_of_at_least(frame.y_step, 11 / frame.scale);
}

// The plot in a page whose axis takes `left` units and whose bar takes `right`.
void place_plot(Frame& frame, const Bounds& bounds, double left, double right) {
  const double x = std::max(bounds.right - bounds.left, 1e-30),
               y = std::max(bounds.top - bounds.bottom, 1e-30);
  const double margin = 0.025 * std::max(x, y);
  const double room = page_width - left - right;
  frame.scale = std::min(room / (x + 2 * margin), tallest_plot / (y + 2 * margin));
  frame.width = snapped(std::max((x + 2 * margin) * frame.scale, least_width));
  frame.height = snapped(std::max((y + 2 * margin) * frame.scale, least_height));
  frame.left = (bounds.left + bounds.right - frame.width / frame.scale) / 2;
  frame.top = (bounds.top + bounds.bottom + frame.height / frame.scale) / 2;
  frame.corner = {snapped(left + (room - frame.width) / 2), snapped(title_height)};
}

}  // namespace

void Bounds::add(Point p) {
  left = std::min(left, p.x);
  right = std::max(right, p.x);
  bottom = std::min(bottom, p.y);
  top = std::max(top, p.y);
}

Image Frame::image() const {
  return {static_cast<int>(std::ceil(width * pixels_per_unit)),
          static_cast<int>(std::ceil(height * pixels_per_unit))};
}

Frame make_frame(const Bounds& bounds, std::optional<double> bar_labels) {
  const double x = bounds.right - bounds.left, y = bounds.top - bounds.bottom;
  Frame frame;
  frame.unit = place_scale(std::max(x, y));
  if (bar_labels) frame.bar = x > 2.3 * y ? Frame::Bar::below : Frame::Bar::right;
  double left = axis_width, right = 14;
  if (frame.bar == Frame::Bar::right) right = std::max(bar_right, bar_beside + *bar_labels);
  // The numbers at the axis follow from the plot, the plot from the room that they leave.
  for (int pass = 0; pass < 2; ++pass) {
    place_plot(frame, bounds, left, right);
    choose_steps(frame);
    left = std::max(axis_width, widest_tick(y_span(frame), frame.y_step, frame.unit) + 24);
  }
  frame.page_height =
      frame.corner.y + frame.height + axis_height + (frame.bar == Frame::Bar::below ? bar_below : 0);
  return frame;
}

void draw_title(Canvas& canvas, const std::string& title, const std::string& subtitle) {
  const TextStyle large{10.5}, small{7.5, {0.38, 0.40, 0.43}};
  canvas.text(12, 14.5, canvas.fitted(title, page_width - 24, large), large);
  canvas.text(12, 26, canvas.fitted(subtitle, page_width - 24, small), small);
}

void draw_axes(Canvas& canvas, const Frame& frame) {
  const double right = frame.corner.x + frame.width, bottom = frame.corner.y + frame.height;
  const Point ring[] = {frame.corner, {right, frame.corner.y}, {right, bottom}, {frame.corner.x, bottom}};
  canvas.polyline(ring, axis_line, true);
  const Span along = x_span(frame), up = y_span(frame);
  for (const double x : multiples(along.low, along.high, frame.x_step)) {
    const double at = frame.at({x, 0}).x;
    canvas.line({at, bottom}, {at, bottom + 2.6}, axis_line);
    canvas.text(at, bottom + 11, tick_text(x / frame.unit.factor, frame.x_step / frame.unit.factor),
                aligned(tick_style, Align::center));
  }
  for (const double y : multiples(up.low, up.high, frame.y_step)) {
    const double at = frame.at({0, y}).y;
    canvas.line({frame.corner.x - 2.6, at}, {frame.corner.x, at}, axis_line);
    canvas.text(frame.corner.x - 5, at + 2.7,
                tick_text(y / frame.unit.factor, frame.y_step / frame.unit.factor),
                aligned(tick_style, Align::right));
  }
  const double widest = widest_tick(up, frame.y_step, frame.unit);
  const std::string unit = " [" + frame.unit.name + "]";
  canvas.text((frame.corner.x + right) / 2, bottom + 22.5, "*x*" + unit, aligned(label_style, Align::center));
  TextStyle turned = aligned(label_style, Align::center);
  turned.turn = 1;
  canvas.text(frame.corner.x - widest - 10.5, (frame.corner.y + bottom) / 2, "*y*" + unit, turned);
}

namespace {

// The bar along its own axis: t from 0 to 1 over the bands, `across` over its thickness.
struct BarPlace {
  Point from;
  double length = 0;
  bool upright = true;
  Point at(double t, double across) const {
    return upright ? Point{from.x + across, from.y - t * length}
                   : Point{from.x + t * length, from.y + across};
  }
};

void draw_bar_colors(Canvas& canvas, const BarPlace& place, const Bands& bands) {
  const int n = bands.count();
  const double tip = 6.5 / place.length;
  for (int i = 0; i < n; ++i) {
    const double a = static_cast<double>(i) / n, b = static_cast<double>(i + 1) / n;
    const Point box[] = {place.at(a, 0), place.at(b, 0), place.at(b, bar_thickness),
                         place.at(a, bar_thickness)};
    canvas.fill(box, bands.colors[i]);
    if (i > 0) canvas.line(place.at(a, 0), place.at(a, bar_thickness), {{0, 0, 0}, 0.3, 0, 0.35});
  }
  std::vector<Point> ring = {place.at(0, 0)};
  if (bands.open_below) ring.push_back(place.at(-tip, bar_thickness / 2));
  ring.push_back(place.at(0, bar_thickness));
  ring.push_back(place.at(1, bar_thickness));
  if (bands.open_above) ring.push_back(place.at(1 + tip, bar_thickness / 2));
  ring.push_back(place.at(1, 0));
  if (bands.open_below) {
    const Point low[] = {place.at(0, 0), place.at(-tip, bar_thickness / 2), place.at(0, bar_thickness)};
    canvas.fill(low, bands.colors.front());
  }
  if (bands.open_above) {
    const Point high[] = {place.at(1, 0), place.at(1 + tip, bar_thickness / 2), place.at(1, bar_thickness)};
    canvas.fill(high, bands.colors.back());
  }
  canvas.polyline(ring, rim, true);
}

// Borders of bands that bear a number: all, or multiples of every second, fifth … step where they are close.
double label_step(const BarPlace& place, const Bands& bands, double widest) {
  const double room = place.upright ? 10 : widest + 6;
  return step_of_at_least(bands.step, room * bands.step * bands.count() / place.length);
}

}  // namespace

double bar_label_width(const Bands& bands, const UnitScale& unit) {
  double widest = 0;
  for (int i = 0; i <= bands.count(); ++i)
    widest = std::max(widest,
                      measured(tick_text(bands.edge(i) / unit.factor, bands.step / unit.factor), tick_style));
  return widest;
}

void draw_bar(Canvas& canvas, const Frame& frame, const Bands& bands, const UnitScale& unit) {
  BarPlace place;
  place.upright = frame.bar == Frame::Bar::right;
  if (place.upright) {
    place.length = std::max(60.0, frame.height - 30);
    const double middle = frame.corner.y + frame.height / 2 + 4;
    place.from = {frame.corner.x + frame.width + 12, middle + place.length / 2};
  } else {
    place.length = std::max(160.0, frame.width - 50);
    place.from = {frame.corner.x + (frame.width - place.length) / 2 - 6,
                  frame.corner.y + frame.height + axis_height + 1};
  }
  draw_bar_colors(canvas, place, bands);
  const double step = label_step(place, bands, bar_label_width(bands, unit));
  for (const double value : multiples(bands.first, bands.edge(bands.count()), step)) {
    const double t = (value - bands.first) / (bands.step * bands.count());
    const Point end = place.at(t, bar_thickness);
    const std::string text = tick_text(value / unit.factor, step / unit.factor);
    if (place.upright) {
      canvas.line(end, {end.x + 2, end.y}, rim);
      canvas.text(end.x + 4, end.y + 2.7, text, tick_style);
    } else {
      canvas.line(end, {end.x, end.y + 2}, rim);
      canvas.text(end.x, end.y + 10, text, aligned(tick_style, Align::center));
    }
  }
  if (unit.name.empty()) return;
  const Point end = place.at(1, 0);
  const double beyond = bands.open_above ? 8 : 0;
  if (place.upright)
    canvas.text(end.x, end.y - 6 - beyond, "[" + unit.name + "]", label_style);
  else
    canvas.text(end.x + 6 + beyond, end.y + 7.5, "[" + unit.name + "]", label_style);
}

}  // namespace ashlar::output
