#include <algorithm>
#include <cmath>

#include "output/files.hpp"
#include "output/pictures/frame.hpp"
#include "output/pictures/pictures.hpp"
#include "output/pictures/profiles.hpp"
#include "output/pictures/values.hpp"

namespace ashlar::output {

using geometry::Point;
using model::SectionResult;

namespace {

constexpr double line_height = 10.5, margin = 52;
constexpr std::size_t most_notes = 8;  // stages whose forces are written below: the last ones

int column(const SectionResult& section, const std::string& name) {
  for (std::size_t k = 0; k < section.columns.size(); ++k)
    if (section.columns[k].name == name) return static_cast<int>(k);
  return -1;
}

/// One straight run of the body without gaps and jumps: what beam theory speaks of.
bool is_beam(const SectionResult& section) {
  const auto& rows = section.rows;
  double covered = 0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (rows[i + 1].piece > 0) break;
    covered += rows[i + 1].s - rows[i].s;
  }
  const double length = geometry::distance(section.first, section.last);
  return std::abs(covered - length) < 1e-6 * length;
}

/// N/A + M s/I between the section's ends.
std::vector<Point> beam_line(const SectionResult& section, double thickness) {
  if (!section.summed || !is_beam(section)) return {};
  const double length = geometry::distance(section.first, section.last);
  if (std::abs(section.forces.normal) <= roundoff * section.size &&
      std::abs(section.forces.moment) <= roundoff * section.size * length)
    return {};
  const double mean = section.forces.normal / (thickness * length);
  const double bending = 6 * section.forces.moment / (thickness * length * length);
  const double s = section.rows.front().s;
  return {{s, mean - bending}, {s + length, mean + bending}};
}

ProfileCurve curve_of(const model::Scene& scene, const std::string& stage, const SectionResult& section) {
  ProfileCurve curve{stage, {}, {}, {beam_line(section, scene.thickness)}};
  const double area = scene.thickness * geometry::distance(section.first, section.last);
  for (const SectionResult::Row& row : section.rows) {
    ProfileRow& drawn =
        curve.rows.emplace_back(ProfileRow{row.s, row.piece, row.side == SectionResult::Side::right, {}});
    for (const char* name : {"sn", "tau"}) {
      const double value = row.values[static_cast<std::size_t>(column(section, name))];
      drawn.values.push_back(std::abs(value) * area <= roundoff * section.size ? 0 : value);
    }
  }
  return curve;
}

/// To two digits: an estimate has no more.
double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
  return unit * std::round(value / unit);
}

/// "N −91.2 MN   V 0 N   M 1.3 GN·m   profile 0.4 % apart".
std::string note(const SectionResult& section) {
  const double length = geometry::distance(section.first, section.last);
  const auto value = [&](double number, const char* unit, double scale) {
    if (std::abs(number) <= roundoff * scale) return std::string("0");
    return value_text(number, unit_scale(unit, std::abs(number)), unit);
  };
  const auto& f = section.forces;
  return "*N* " + value(f.normal, "N", section.size) + ",  *V* " + value(f.shear, "N", section.size) +
         ",  *M* " + value(f.moment, "N·m", section.size * length) + ",  integral " +
         value_text(rounded(100 * section.difference)) + " % apart";
}

}  // namespace

Picture section_picture(const model::Scene& scene, const model::RunResult& result, const std::string& name) {
  Profiles profiles{
      {}, {{"normal stress", "Pa"}, {"shear stress", "Pa"}}, "distance along the section *s* [m]"};
  std::vector<std::string> notes;
  bool beam = false, sides = false;
  for (const model::StageResult& stage : result.good())
    for (const SectionResult& section : stage.sections) {
      if (section.name != name || column(section, "sn") < 0 || section.rows.empty()) continue;
      profiles.curves.push_back(curve_of(scene, stage.name, section));
      beam = beam || !profiles.curves.back().lines[0].empty();
      sides = sides || std::ranges::any_of(profiles.curves.back().rows, &ProfileRow::dashed);
      if (section.summed) notes.push_back(stage.name + ":  " + note(section));
    }
  if (profiles.curves.empty()) return {};
  color_curves(profiles.curves);
  if (notes.size() > most_notes) notes.erase(notes.begin(), notes.end() - most_notes);
  std::string legend = "left on right, tension positive";
  if (beam) legend += "; long dashes: *N*/*A* + *M* *s*/*I*";
  if (sides) legend += "; short dashes: right side";
  notes.push_back(legend);
  const double top = page_height(profiles);
  return {"section_" + file_name(name), top + line_height * static_cast<double>(notes.size()) + 2,
          [&scene, name, profiles, notes, top](Canvas& canvas) {
            draw_title(canvas, "Section " + name, scene.title);
            draw_profiles(canvas, profiles);
            const TextStyle style{7.5};
            for (std::size_t i = 0; i < notes.size(); ++i)
              canvas.text(margin, top + 6 + line_height * static_cast<double>(i),
                          canvas.fitted(notes[i], page_width - margin - 8, style), style);
          }};
}

}  // namespace ashlar::output
