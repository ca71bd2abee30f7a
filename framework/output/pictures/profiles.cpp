#include <algorithm>
#include <array>
#include <cmath>

#include "output/pictures/legend.hpp"
#include "output/pictures/profiles.hpp"

namespace ashlar::output {

using geometry::Point;

namespace {

constexpr double left = 52, right = page_width - 14, first_top = 50, panel = 84, gap = 15, foot = 34;
const LineStyle axis_line{{0.13, 0.14, 0.16}, 0.6};
const LineStyle grid_line{{0.86, 0.87, 0.88}, 0.45};
const TextStyle tick_style = legend_style;

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

/// One set of axes: s to the right, a quantity upward.
struct Panel {
  double top = 0;
  double s_low = 0, s_high = 1, low = 0, high = 1;
  Point at(double s, double value) const {
    return {left + (s - s_low) / (s_high - s_low) * (right - left),
            top + panel - (value - low) / (high - low) * panel};
  }
};

struct Range {
  double low = 0, high = 0;
};

// What all but 0.5 % of the joint's length at either end hold.
Range common_range(const std::vector<ProfileRow>& rows, std::size_t quantity) {
  std::vector<std::pair<double, double>> values;  // with the length that each stands for
  double total = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double from = rows[i > 0 ? i - 1 : i].s, to = rows[i + 1 < rows.size() ? i + 1 : i].s;
    if (!std::isfinite(rows[i].values[quantity])) continue;
    values.emplace_back(rows[i].values[quantity], (to - from) / 2);
    total += (to - from) / 2;
  }
  std::sort(values.begin(), values.end());
  if (values.empty()) return {};
  std::size_t first = 0, last = values.size() - 1;
  for (double sum = values[first].second; first < last && sum < 0.005 * total;
       sum += values[++first].second) {
  }
  for (double sum = values[last].second; last > first && sum < 0.005 * total; sum += values[--last].second) {
  }
  return {values[first].first, values[last].first};
}

// The axis holds all values unless a peak at a crossing or a tip would flatten the rest.
Panel make_panel(const std::vector<ProfileCurve>& curves, std::size_t quantity, double top) {
  Panel p{top, 1e300, -1e300, 0, 0};
  Range common;
  for (const ProfileCurve& curve : curves) {
    const Range range = common_range(curve.rows, quantity);
    common = {std::min(common.low, range.low), std::max(common.high, range.high)};
    for (const ProfileRow& row : curve.rows) {
      p.s_low = std::min(p.s_low, row.s);
      p.s_high = std::max(p.s_high, row.s);
      const double value = row.values[quantity];
      if (!std::isfinite(value)) continue;
      p.low = std::min(p.low, value);
      p.high = std::max(p.high, value);
    }
  }
  if (common.high > common.low && common.high - common.low < 0.3 * (p.high - p.low)) {
    p.low = common.low;
    p.high = common.high + 0.15 * (common.high - common.low);  // for the words about the peak
  }
  if (!(p.s_high > p.s_low)) p.s_high = p.s_low + 1;
  if (!(p.high > p.low)) p.high = p.low + 1;
  const double room = 0.07 * (p.high - p.low);
  if (p.low < 0) p.low -= room;
  p.high += room;
  return p;
}

void draw_curve(Canvas& canvas, const Panel& axes, const ProfileCurve& curve, std::size_t quantity) {
  std::vector<Point> line;
  const auto& rows = curve.rows;
  if (quantity < curve.lines.size()) {
    for (const Point& p : curve.lines[quantity]) line.push_back(axes.at(p.x, p.y));
    canvas.polyline(line, {curve.color, 0.6, 5});
    line.clear();
  }
  const auto known = [&](std::size_t i) { return std::isfinite(rows[i].values[quantity]); };
  for (std::size_t i = 0; i <= rows.size(); ++i) {
    const bool ends = i == rows.size() || !known(i) || (i > 0 && rows[i].piece != rows[i - 1].piece);
    if (ends) {
      canvas.polyline(line, {curve.color, 1.25, i > 0 && rows[i - 1].dashed ? 2.0 : 0.0});
      line.clear();
    }
    if (i < rows.size() && known(i)) line.push_back(axes.at(rows[i].s, rows[i].values[quantity]));
  }
  // Few points are points: show where they are.
  if (rows.size() > 40) return;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (known(i))
      canvas.disc(axes.at(rows[i].s, rows[i].values[quantity]), 1.3, curve.color, {{1, 1, 1}, 0.3});
}

// "peak 60 MPa at s = 5.27 m", where the axis does not reach it.
std::string peak_text(const Profiles& profiles, const Panel& axes, std::size_t quantity,
                      const UnitScale& unit) {
  const ProfileRow* peak = nullptr;
  for (const ProfileCurve& curve : profiles.curves)
    for (const ProfileRow& row : curve.rows) {
      const double value = row.values[quantity];
      if (!(value > axes.high || value < axes.low)) continue;
      if (!peak || std::abs(value) > std::abs(peak->values[quantity])) peak = &row;
    }
  if (!peak) return {};
  return "peak " + value_text(peak->values[quantity], unit, profiles.quantities[quantity].unit) +
         " at *s* = " + value_text(peak->s) + " m";
}

void draw_panel(Canvas& canvas, const Profiles& profiles, std::size_t quantity, double top) {
  const bool last = quantity + 1 == profiles.quantities.size();
  const Panel axes = make_panel(profiles.curves, quantity, top);
  const UnitScale unit =
      unit_scale(profiles.quantities[quantity].unit, std::max(std::abs(axes.low), std::abs(axes.high)));
  const auto marks = ticks(axes.low / unit.factor, axes.high / unit.factor, 5);
  const double step = marks.size() > 1 ? marks[1] - marks[0] : 1;
  for (const double value : marks) {
    const Point at = axes.at(axes.s_low, value * unit.factor);
    const bool zero = std::abs(value) < 1e-9 * step;
    canvas.line({left, at.y}, {right, at.y}, zero ? LineStyle{{0.6, 0.61, 0.63}, 0.55} : grid_line);
    canvas.line({left - 2.6, at.y}, {left, at.y}, axis_line);
    canvas.text(left - 5, at.y + 2.7, tick_text(value, step), aligned(tick_style, Align::right));
  }
  canvas.clipped({left - 2, top}, right - left + 4, panel, [&] {
    for (const ProfileCurve& curve : profiles.curves) draw_curve(canvas, axes, curve, quantity);
  });
  const Point ring[] = {{left, top}, {right, top}, {right, top + panel}, {left, top + panel}};
  canvas.polyline(ring, axis_line, true);
  const auto places = ticks(axes.s_low, axes.s_high, 8);
  for (const double s : places) {
    const double x = axes.at(s, axes.low).x;
    canvas.line({x, top + panel}, {x, top + panel + 2.6}, axis_line);
    if (last)
      canvas.text(x, top + panel + 11, tick_text(s, places.size() > 1 ? places[1] - places[0] : 1),
                  aligned(tick_style, Align::center));
  }
  TextStyle note = aligned(tick_style, Align::right);
  note.halo = true;
  canvas.text(right - 4, top + 9, peak_text(profiles, axes, quantity, unit), note);
  TextStyle turned = aligned({8.5}, Align::center);
  turned.turn = 1;
  const std::string in = unit.name.empty() ? "" : " [" + unit.name + "]";
  canvas.text(15, top + panel / 2, profiles.quantities[quantity].symbol + in, turned);
}

std::vector<Point> places_of(const std::vector<ProfileCurve>& curves) {
  std::vector<std::string> names;
  for (const ProfileCurve& curve : curves) names.push_back(curve.stage);
  return legend_places(names, {left, 40}, right);
}

void draw_legend(Canvas& canvas, const std::vector<ProfileCurve>& curves) {
  const std::vector<Point> places = places_of(curves);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto [x, y] = places[i];
    canvas.line({x, y}, {x + legend_stroke, y}, {curves[i].color, 1.5});
    canvas.text(x + legend_text, y + 2.6, canvas.fitted(curves[i].stage, right - x - legend_text, tick_style),
                tick_style);
  }
}

double top_of(const Profiles& profiles) {
  return first_top + places_of(profiles.curves).back().y - 40;
}

double bottom_of(const Profiles& profiles) {
  const auto count = static_cast<double>(profiles.quantities.size());
  return top_of(profiles) + panel * count + gap * (count - 1);
}

}  // namespace

void color_curves(std::vector<ProfileCurve>& curves) {
  for (std::size_t i = 0; i < curves.size(); ++i)
    curves[i].color = curve_color(static_cast<int>(i), static_cast<int>(curves.size()));
}

double page_height(const Profiles& profiles) {
  return bottom_of(profiles) + foot;
}

void draw_profiles(Canvas& canvas, const Profiles& profiles) {
  draw_legend(canvas, profiles.curves);
  const double top = top_of(profiles);
  for (std::size_t i = 0; i < profiles.quantities.size(); ++i)
    draw_panel(canvas, profiles, i, top + static_cast<double>(i) * (panel + gap));
  canvas.text((left + right) / 2, bottom_of(profiles) + 23, profiles.s_label, aligned({8.5}, Align::center));
}

}  // namespace ashlar::output
