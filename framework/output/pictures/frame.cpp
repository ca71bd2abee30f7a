#include "output/pictures/frame.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::output {

using geometry::Point;

namespace {

constexpr double title_height = 34, axis_height = 31, axis_width = 41;
constexpr double bar_right = 66, bar_below = 34, bar_thickness = 9;
constexpr double tallest_plot = 330;
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

// Labels at every border of bands, or at every second or fifth if there are many.
bool labelled(const Bands& bands, int i, int most) {
  int stride = 1;
  for (const int each : {1, 2, 5, 10})
    if ((stride = each, bands.count() / each <= most)) break;
  return std::lround(bands.edge(i) / bands.step) % stride == 0;
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

Frame make_frame(const Bounds& bounds, bool with_bar) {
  const double x = std::max(bounds.right - bounds.left, 1e-30),
               y = std::max(bounds.top - bounds.bottom, 1e-30);
  const double margin = 0.025 * std::max(x, y);
  const double wide = x + 2 * margin, high = y + 2 * margin;
  Frame frame;
  if (with_bar) frame.bar = wide > 2.3 * high ? Frame::Bar::below : Frame::Bar::right;
  const double right = frame.bar == Frame::Bar::right ? bar_right : 12;
  const double room = page_width - axis_width - right;
  frame.scale = std::min(room / wide, tallest_plot / high);
  frame.width = snapped(wide * frame.scale);
  frame.height = snapped(high * frame.scale);
  frame.left = bounds.left - margin;
  frame.top = bounds.top + margin;
  frame.corner = {snapped(axis_width + (room - frame.width) / 2), snapped(title_height)};
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
  const double x_low = frame.left, x_high = frame.left + frame.width / frame.scale;
  const double y_high = frame.top, y_low = frame.top - frame.height / frame.scale;
  const Point ring[] = {frame.corner, {right, frame.corner.y}, {right, bottom}, {frame.corner.x, bottom}};
  canvas.polyline(ring, axis_line, true);
  // Equal steps on both axes, but at least two on the shorter one.
  const double longer = std::max(x_high - x_low, y_high - y_low);
  const double step = round_down(longer / 4);
  const double x_step = std::min(step, round_down((x_high - x_low) / 3));
  const double y_step = std::min(step, round_down((y_high - y_low) / 3));
  for (const double x : multiples(x_low, x_high, x_step)) {
    const double at = frame.at({x, 0}).x;
    canvas.line({at, bottom}, {at, bottom + 2.6}, axis_line);
    canvas.text(at, bottom + 11, tick_text(x, x_step), aligned(tick_style, Align::center));
  }
  double widest = 0;
  for (const double y : multiples(y_low, y_high, y_step)) {
    const double at = frame.at({0, y}).y;
    const std::string text = tick_text(y, y_step);
    widest = std::max(widest, canvas.text_width(text, tick_style));
    canvas.line({frame.corner.x - 2.6, at}, {frame.corner.x, at}, axis_line);
    canvas.text(frame.corner.x - 5, at + 2.7, text, aligned(tick_style, Align::right));
  }
  canvas.text((frame.corner.x + right) / 2, bottom + 22.5, "*x* [m]", aligned(label_style, Align::center));
  TextStyle turned = aligned(label_style, Align::center);
  turned.turn = 1;
  canvas.text(frame.corner.x - widest - 10.5, (frame.corner.y + bottom) / 2, "*y* [m]", turned);
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

}  // namespace

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
  const double step = bands.step / unit.factor;
  const int most = place.upright ? static_cast<int>(place.length / 11) : static_cast<int>(place.length / 30);
  for (int i = 0; i <= bands.count(); ++i) {
    if (!labelled(bands, i, most)) continue;
    const Point end = place.at(static_cast<double>(i) / bands.count(), bar_thickness);
    const std::string text = tick_text(bands.edge(i) / unit.factor, step);
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
