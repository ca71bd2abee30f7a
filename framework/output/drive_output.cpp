#include "output/drive_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "output/files.hpp"
#include "output/pictures/chart.hpp"
#include "output/pictures/frame.hpp"
#include "output/text_table.hpp"

namespace ashlar::output {

using solve::DrivePoint;
using solve::DriveResult;

namespace {

constexpr std::array strain_names = {"xx", "yy", "xy", "zz"};
constexpr std::array stress_names = {"sxx", "syy", "sxy", "szz"};
constexpr std::array strain_labels = {"strain *ε*_{xx}", "strain *ε*_{yy}", "shear angle *γ*_{xy}",
                                      "strain *ε*_{zz}"};
constexpr std::array stress_labels = {"*σ*_{xx}", "*σ*_{yy}", "*σ*_{xy}", "*σ*_{zz}"};
constexpr std::size_t rows_shown = 18;

std::string printed(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

double span(const DriveResult& result, int component, model::Voigt DrivePoint::*of) {
  double low = INFINITY, high = -INFINITY;
  for (const DrivePoint& point : result.points) {
    low = std::min(low, (point.*of)[component]);
    high = std::max(high, (point.*of)[component]);
  }
  return high - low;
}

double greatest_stress(const DriveResult& result) {
  double most = 0;
  for (const DrivePoint& point : result.points)
    for (const double value : point.stress) most = std::max(most, std::abs(value));
  return most;
}

Chart stress_chart(const DriveResult& result, const UnitScale& unit) {
  int driven = 0;
  for (int i = 1; i < 4; ++i)
    if (span(result, i, &DrivePoint::strain) > span(result, driven, &DrivePoint::strain)) driven = i;
  Chart chart{strain_labels[driven], "stress", {1e-3, "mm/m"}, unit, {}};
  for (int i = 0; i < 4; ++i) {
    // Stresses that stay at zero would only crowd the picture.
    if (span(result, i, &DrivePoint::stress) <= 1e-6 * greatest_stress(result)) continue;
    ChartCurve curve{stress_labels[i], {}};
    for (const DrivePoint& point : result.points)
      curve.points.push_back({point.strain[driven], point.stress[i]});
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

Chart path_chart(const DriveResult& result, const UnitScale& unit) {
  Chart chart{"mean of the extreme principal stresses (*σ*_{1} + *σ*_{3})/2",
              "(*σ*_{1} − *σ*_{3})/2",
              unit,
              unit,
              {}};
  ChartCurve curve;
  for (const DrivePoint& point : result.points) {
    const auto s = principal_stresses(point.stress);
    curve.points.push_back({(s[0] + s[2]) / 2, (s[0] - s[2]) / 2});
  }
  chart.curves.push_back(std::move(curve));
  return chart;
}

}  // namespace

std::array<double, 3> principal_stresses(const model::Voigt& stress) {
  const double mean = (stress[0] + stress[1]) / 2;
  const double radius = std::hypot((stress[0] - stress[1]) / 2, stress[2]);
  std::array<double, 3> values = {mean + radius, mean - radius, stress[3]};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

std::string drive_csv(const DriveResult& result) {
  std::string text =
      "leg,step,xx,yy,xy,zz,sxx [Pa],syy [Pa],sxy [Pa],szz [Pa],s1 [Pa],s2 [Pa],s3 [Pa],iterations";
  for (std::size_t i = 1; i <= result.points.front().variables.size(); ++i) text += ",v" + std::to_string(i);
  text += "\n";
  for (const DrivePoint& point : result.points) {
    text += std::to_string(point.leg) + "," + std::to_string(point.step);
    for (const double value : point.strain) text += "," + shortest(value);
    for (const double value : point.stress) text += "," + shortest(value);
    for (const double value : principal_stresses(point.stress)) text += "," + shortest(value);
    text += "," + std::to_string(point.iterations);
    for (const double value : point.variables) text += "," + shortest(value);
    text += "\n";
  }
  return text;
}

std::string drive_table(const DriveResult& result) {
  const UnitScale unit = unit_scale("Pa", greatest_stress(result));
  std::vector<std::vector<std::string>> rows = {{"leg", "step"}};
  for (const char* name : strain_names) rows[0].emplace_back(name);
  for (const char* name : stress_names) rows[0].push_back(std::string(name) + " [" + unit.name + "]");
  // Held stresses are met to a tolerance: what is left is no number to read.
  const double noise = 1e-9 * greatest_stress(result);
  const std::size_t count = result.points.size();
  const std::size_t stride = (count + rows_shown - 1) / rows_shown;
  for (std::size_t i = 0; i < count; ++i) {
    const DrivePoint& point = result.points[i];
    const bool leg_ends = i + 1 == count || result.points[i + 1].leg != point.leg;
    if (i % stride != 0 && !leg_ends) continue;
    std::vector<std::string> row = {std::to_string(point.leg), std::to_string(point.step)};
    for (const double value : point.strain) row.push_back(printed(value));
    for (const double value : point.stress)
      row.push_back(printed(std::abs(value) > noise ? value / unit.factor : 0));
    rows.push_back(std::move(row));
  }
  return aligned(rows, 0);
}

Picture drive_picture(const model::Drive& drive, const DriveResult& result) {
  const UnitScale unit = unit_scale("Pa", greatest_stress(result));
  const Chart stresses = stress_chart(result, unit), path = path_chart(result, unit);
  constexpr double title = 34;
  return {"drive", title + page_height(stresses) + page_height(path),
          [&drive, stresses, path](Canvas& canvas) {
            draw_title(canvas, drive.title, drive.law + ", " + model::words(drive.plane));
            draw_chart(canvas, stresses, title);
            draw_chart(canvas, path, title + page_height(stresses));
          }};
}

}  // namespace ashlar::output
