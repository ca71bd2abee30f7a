#include <algorithm>
#include <cmath>

#include "output/files.hpp"
#include "output/tables.hpp"

namespace ashlar::output {

using model::RunResult;
using model::SectionResult;
using model::StageResult;

std::string side_name(SectionResult::Side side) {
  if (side == SectionResult::Side::both) return "both";
  return side == SectionResult::Side::left ? "left" : "right";
}

std::vector<std::string> section_names(const RunResult& result) {
  std::vector<std::string> names;
  for (const StageResult& stage : result.stages)
    for (const SectionResult& section : stage.sections)
      if (std::find(names.begin(), names.end(), section.name) == names.end()) names.push_back(section.name);
  return names;
}

std::string section_csv(const RunResult& result, const std::string& name) {
  std::string text;
  for (const StageResult& stage : result.stages)
    for (const SectionResult& section : stage.sections) {
      if (section.name != name) continue;
      if (text.empty()) {
        text = "stage,s [m],x [m],y [m],side,region,piece";
        for (const SectionResult::Column& column : section.columns)
          text += "," + csv_field(column.name + " [" + column.unit + "]");
        text += "\n";
      }
      for (const SectionResult::Row& row : section.rows) {
        text += csv_field(stage.name);
        for (const double value : {row.s, row.at.x, row.at.y}) text += "," + shortest(value);
        text += "," + side_name(row.side) + "," + csv_field(row.region) + "," + std::to_string(row.piece);
        for (const double value : row.values)
          text += "," + (std::isnan(value) ? std::string() : shortest(value));
        text += "\n";
      }
    }
  return text;
}

std::string sections_csv(const RunResult& result) {
  std::string text =
      "stage,section,x first [m],y first [m],x last [m],y last [m],N [N],V [N],M [N*m],N integral [N],"
      "V integral [N],M integral [N*m],difference\n";
  for (const StageResult& stage : result.stages)
    for (const SectionResult& section : stage.sections) {
      text += csv_field(stage.name) + "," + csv_field(section.name);
      const auto add = [&](std::initializer_list<double> values, bool known) {
        for (const double value : values) text += "," + (known ? shortest(value) : std::string());
      };
      add({section.first.x, section.first.y, section.last.x, section.last.y}, true);
      add({section.forces.normal, section.forces.shear, section.forces.moment}, section.summed);
      add({section.integral.normal, section.integral.shear, section.integral.moment, section.difference},
          section.integrated);
      text += "\n";
    }
  return text;
}

}  // namespace ashlar::output
