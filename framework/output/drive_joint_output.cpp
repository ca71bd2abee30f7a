#include "output/drive_joint_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "output/files.hpp"
#include "output/pictures/chart.hpp"
#include "output/pictures/frame.hpp"
#include "output/text_table.hpp"

namespace ashlar::output {

using model::JointPoint;
using solve::JointDrivePoint;
using solve::JointDriveResult;

namespace {

constexpr std::size_t rows_shown = 18;
// What is left of zero after rounding is no number to read.
constexpr double noise = 1e-9;

using Member = double JointPoint::*;

double greatest(const JointDriveResult& result, Member member) {
  double most = 0;
  for (const JointDrivePoint& point : result.points) most = std::max(most, std::abs(point.at.*member));
  return most;
}

/// A column of numbers in the unit in which its greatest reads well.
struct Column {
  const char* name;
  Member member;
  double most;
  UnitScale unit;
  std::string cell(const JointPoint& point) const {
    const double value = point.*member;
    return shortest_of(std::abs(value) > noise * most ? value / unit.factor : 0);
  }
  std::string head() const { return std::string(name) + " [" + unit.name + "]"; }

 private:
  static std::string shortest_of(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
  }
};

std::vector<Column> columns_of(const JointDriveResult& result) {
  const double length = std::max(greatest(result, &JointPoint::opening), greatest(result, &JointPoint::slip));
  const double traction =
      std::max(greatest(result, &JointPoint::pressure), greatest(result, &JointPoint::shear));
  std::vector<Column> columns;
  for (const auto& [name, member] : {std::pair<const char*, Member>{"opening", &JointPoint::opening},
                                     {"slip", &JointPoint::slip},
                                     {"dilation", &JointPoint::dilation}}) {
    const double most = greatest(result, member);
    if (member == &JointPoint::dilation && most == 0) continue;
    columns.push_back({name, member, length, unit_scale("m", most > noise * length ? most : length)});
  }
  for (const auto& [name, member] :
       {std::pair<const char*, Member>{"pressure", &JointPoint::pressure}, {"shear", &JointPoint::shear}})
    columns.push_back({name, member, traction, unit_scale("Pa", traction)});
  return columns;
}

bool moves(const JointDriveResult& result, Member member, double least) {
  const auto [low, high] = std::ranges::minmax_element(
      result.points, {}, [&](const JointDrivePoint& point) { return point.at.*member; });
  return high->at.*member - low->at.*member > least;
}

struct Axis {
  Member member;
  const char* label;
  const char* unit;
};

Chart chart_of(const JointDriveResult& result, const Axis& x, const Axis& y) {
  Chart chart{x.label,
              y.label,
              unit_scale(x.unit, greatest(result, x.member)),
              unit_scale(y.unit, greatest(result, y.member)),
              {}};
  ChartCurve curve;
  for (const JointDrivePoint& point : result.points)
    curve.points.push_back({point.at.*x.member, point.at.*y.member});
  chart.curves.push_back(std::move(curve));
  return chart;
}

std::vector<Chart> charts_of(const JointDriveResult& result) {
  const Axis opening{&JointPoint::opening, "opening, closure negative", "m"},
      slip{&JointPoint::slip, "slip", "m"}, pressure{&JointPoint::pressure, "effective pressure", "Pa"},
      shear{&JointPoint::shear, "shear", "Pa"}, dilation{&JointPoint::dilation, "dilation", "m"};
  std::vector<Chart> charts;
  for (const auto& [x, y] : {std::pair{slip, shear}, {opening, pressure}, {slip, dilation}})
    if (moves(result, x.member, 0) && moves(result, y.member, noise * greatest(result, y.member)))
      charts.push_back(chart_of(result, x, y));
  return charts;
}

}  // namespace

std::string drive_csv(const model::Drive& drive, const JointDriveResult& result) {
  std::string text = "leg,step,opening [m],slip [m],pressure [Pa],shear [Pa],dilation [m],status,iterations";
  for (const std::string& name : drive.joint->variables()) text += "," + name;
  text += "\n";
  for (const auto& [leg, step, at] : result.points) {
    text += std::to_string(leg) + "," + std::to_string(step);
    for (const double value : {at.opening, at.slip, at.pressure, at.shear, at.dilation})
      text += "," + shortest(value);
    text += "," + at.status + "," + std::to_string(at.iterations);
    for (const double value : at.variables) text += "," + shortest(value);
    text += "\n";
  }
  return text;
}

std::string drive_table(const JointDriveResult& result) {
  const std::vector<Column> columns = columns_of(result);
  std::vector<std::vector<std::string>> rows = {{"leg", "step"}};
  for (const Column& column : columns) rows[0].push_back(column.head());
  rows[0].emplace_back("status");
  const std::size_t count = result.points.size();
  const std::size_t stride = (count + rows_shown - 1) / rows_shown;
  for (std::size_t i = 0; i < count; ++i) {
    const JointDrivePoint& point = result.points[i];
    const bool leg_ends = i + 1 == count || result.points[i + 1].leg != point.leg;
    if (i % stride != 0 && !leg_ends) continue;
    std::vector<std::string> row = {std::to_string(point.leg), std::to_string(point.step)};
    for (const Column& column : columns) row.push_back(column.cell(point.at));
    row.push_back(point.at.status);
    rows.push_back(std::move(row));
  }
  return aligned(rows, 0);
}

Picture drive_picture(const model::Drive& drive, const JointDriveResult& result) {
  const std::vector<Chart> charts = charts_of(result);
  constexpr double title = 34;
  double height = title;
  for (const Chart& chart : charts) height += page_height(chart);
  return {"drive", height, [&drive, charts](Canvas& canvas) {
            draw_title(canvas, drive.title, drive.joint->law());
            double top = title;
            for (const Chart& chart : charts) {
              draw_chart(canvas, chart, top);
              top += page_height(chart);
            }
          }};
}

}  // namespace ashlar::output
