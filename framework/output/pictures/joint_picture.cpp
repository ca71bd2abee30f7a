#include <algorithm>
#include <array>
#include <cmath>

#include "output/files.hpp"
#include "output/pictures/frame.hpp"
#include "output/pictures/pictures.hpp"
#include "output/tables.hpp"

namespace ashlar::output {

using geometry::Point;
using model::JointResult;

namespace {

constexpr double left = 52, right = page_width - 14, first_top = 50, panel = 84, gap = 15, foot = 34,
                 legend_row = 11;
const LineStyle axis_line{{0.13, 0.14, 0.16}, 0.6};
const LineStyle grid_line{{0.86, 0.87, 0.88}, 0.45};
const TextStyle tick_style{7.5};

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

struct Quantity {
  const char* name;
  const char* symbol;
  const char* unit;
  double JointResult::Row::*value;
};
constexpr std::array<Quantity, 3> quantities = {
    {{"opening", "opening", "m", &JointResult::Row::opening},
     {"slip", "slip", "m", &JointResult::Row::slip},
     {"pressure", "pressure", "Pa", &JointResult::Row::pressure}}};

/// One stage's profile.
struct Curve {
  std::string stage;
  std::vector<JointResult::Row> rows;  ///< with the welded tips
  Color color;
};

std::vector<Curve> curves_of(const model::RunResult& result, const std::string& name) {
  std::vector<Curve> curves;
  for (const model::StageResult& stage : result.stages)
    for (const JointResult& joint : stage.joints)
      if (joint.name == name && !joint.rows.empty()) curves.push_back({stage.name, rows_and_tips(joint), {}});
  for (std::size_t i = 0; i < curves.size(); ++i)
    curves[i].color = curve_color(static_cast<int>(i), static_cast<int>(curves.size()));
  return curves;
}

// The quantities that outputs.joints names for this joint; all if it names none.
std::vector<Quantity> chosen(const model::Scene& scene, const std::string& joint) {
  const core::Settings::Entry* joints = scene.outputs.find("joints");
  const core::Table* by_name = joints ? joints->value.table() : nullptr;
  const core::Value* said = by_name ? by_name->find(joint) : nullptr;
  std::vector<Quantity> list;
  for (const Quantity& q : quantities)
    for (const core::Value& item : said && said->table() ? said->table()->items : std::vector<core::Value>())
      if (item.text() && *item.text() == q.name) list.push_back(q);
  if (list.empty()) return {quantities.begin(), quantities.end()};
  return list;
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
Range common_range(const std::vector<JointResult::Row>& rows, const Quantity& quantity) {
  std::vector<std::pair<double, double>> values;  // with the length that each stands for
  double total = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double from = rows[i > 0 ? i - 1 : i].s, to = rows[i + 1 < rows.size() ? i + 1 : i].s;
    if (!std::isfinite(rows[i].*quantity.value)) continue;
    values.emplace_back(rows[i].*quantity.value, (to - from) / 2);
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
Panel make_panel(const std::vector<Curve>& curves, const Quantity& quantity, double top) {
  Panel p{top, 1e300, -1e300, 0, 0};
  Range common;
  for (const Curve& curve : curves) {
    const Range range = common_range(curve.rows, quantity);
    common = {std::min(common.low, range.low), std::max(common.high, range.high)};
    for (const JointResult::Row& row : curve.rows) {
      p.s_low = std::min(p.s_low, row.s);
      p.s_high = std::max(p.s_high, row.s);
      const double value = row.*quantity.value;
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

void draw_curve(Canvas& canvas, const Panel& axes, const Curve& curve, const Quantity& quantity) {
  std::vector<Point> line;
  const auto& rows = curve.rows;
  const auto known = [&](std::size_t i) { return std::isfinite(rows[i].*quantity.value); };
  for (std::size_t i = 0; i <= rows.size(); ++i) {
    const bool ends = i == rows.size() || !known(i) || (i > 0 && rows[i].piece != rows[i - 1].piece);
    if (ends) {
      canvas.polyline(line, {curve.color, 1.25});
      line.clear();
    }
    if (i < rows.size() && known(i)) line.push_back(axes.at(rows[i].s, rows[i].*quantity.value));
  }
  // Few points are points: show where they are.
  if (rows.size() > 40) return;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (known(i))
      canvas.disc(axes.at(rows[i].s, rows[i].*quantity.value), 1.3, curve.color, {{1, 1, 1}, 0.3});
}

// "peak 60 MPa at s = 5.27 m", where the axis does not reach it.
std::string peak_text(const std::vector<Curve>& curves, const Panel& axes, const Quantity& quantity,
                      const UnitScale& unit) {
  const JointResult::Row* peak = nullptr;
  for (const Curve& curve : curves)
    for (const JointResult::Row& row : curve.rows) {
      const double value = row.*quantity.value;
      if (!(value > axes.high || value < axes.low)) continue;
      if (!peak || std::abs(value) > std::abs(peak->*quantity.value)) peak = &row;
    }
  if (!peak) return {};
  return "peak " + value_text(peak->*quantity.value, unit, quantity.unit) +
         " at *s* = " + value_text(peak->s) + " m";
}

void draw_panel(Canvas& canvas, const std::vector<Curve>& curves, const Quantity& quantity, double top,
                bool last) {
  const Panel axes = make_panel(curves, quantity, top);
  const UnitScale unit = unit_scale(quantity.unit, std::max(std::abs(axes.low), std::abs(axes.high)));
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
    for (const Curve& curve : curves) draw_curve(canvas, axes, curve, quantity);
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
  canvas.text(right - 4, top + 9, peak_text(curves, axes, quantity, unit), note);
  TextStyle turned = aligned({8.5}, Align::center);
  turned.turn = 1;
  canvas.text(15, top + panel / 2, std::string(quantity.symbol) + " [" + unit.name + "]", turned);
}

/// Where each stage stands in the legend, in rows that do not leave the plot.
std::vector<Point> legend_places(const std::vector<Curve>& curves) {
  std::vector<Point> places;
  Point at{left, 40};
  for (const Curve& curve : curves) {
    const double width = 17 + measured(curve.stage, tick_style);
    if (at.x > left && at.x + width > right) at = {left, at.y + legend_row};
    places.push_back(at);
    at.x += width + 14;
  }
  return places;
}

void draw_legend(Canvas& canvas, const std::vector<Curve>& curves) {
  const std::vector<Point> places = legend_places(curves);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto [x, y] = places[i];
    canvas.line({x, y}, {x + 13, y}, {curves[i].color, 1.5});
    canvas.text(x + 17, y + 2.6, canvas.fitted(curves[i].stage, right - x - 17, tick_style), tick_style);
  }
}

}  // namespace

Picture joint_picture(const model::Scene& scene, const model::RunResult& result, const std::string& joint) {
  const std::vector<Curve> curves = curves_of(result, joint);
  if (curves.empty()) return {};
  const std::vector<Quantity> list = chosen(scene, joint);
  const double top = first_top + legend_places(curves).back().y - 40;
  const double bottom = top + panel * list.size() + gap * (list.size() - 1);
  return {"joint_" + file_name(joint), bottom + foot,
          [&scene, joint, curves, list, top, bottom](Canvas& canvas) {
            draw_title(canvas, "Joint " + joint, scene.title);
            draw_legend(canvas, curves);
            for (std::size_t i = 0; i < list.size(); ++i)
              draw_panel(canvas, curves, list[i], top + i * (panel + gap), i + 1 == list.size());
            canvas.text((left + right) / 2, bottom + 23, "distance along the joint *s* [m]",
                        aligned({8.5}, Align::center));
          }};
}

}  // namespace ashlar::output
