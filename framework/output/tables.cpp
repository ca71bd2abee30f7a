#include "output/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "output/files.hpp"

#include "output/joint_columns.hpp"

namespace ashlar::output {

using model::Iteration;
using model::JointResult;
using model::ProbeResult;
using model::RunResult;
using model::StageResult;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string quantity_unit(const std::string& quantity) {
  if (quantity == "ux" || quantity == "uy" || quantity == "u") return "m";
  const bool stress = quantity.size() >= 2 && quantity.size() <= 3 && quantity[0] == 's' &&
                      (quantity[1] == 'x' || quantity[1] == 'y' || quantity[1] == 'z' ||
                       (quantity[1] >= '1' && quantity[1] <= '3'));
  if (quantity == "principal_angle") return "deg";
  return stress || quantity == "von_mises" || quantity == "pressure" ? "Pa" : "";
}

std::vector<std::string> joint_names(const RunResult& result) {
  std::vector<std::string> names;
  for (const StageResult& stage : result.stages)
    for (const JointResult& joint : stage.joints)
      if (std::find(names.begin(), names.end(), joint.name) == names.end()) names.push_back(joint.name);
  return names;
}

std::string probes_csv(const RunResult& result) {
  std::set<std::string> quantities;
  for (const StageResult& stage : result.stages)
    for (const ProbeResult& probe : stage.probes)
      for (const auto& [quantity, value] : probe.values) quantities.insert(quantity);
  std::string text = "stage,probe,x [m],y [m]";
  for (const std::string& quantity : quantities) {
    const std::string unit = quantity_unit(quantity);
    text += "," + csv_field(unit.empty() ? quantity : quantity + " [" + unit + "]");
  }
  text += "\n";
  for (const StageResult& stage : result.stages)
    for (const ProbeResult& probe : stage.probes) {
      text += csv_field(stage.name) + "," + csv_field(probe.name) + "," + shortest(probe.at.x) + "," +
              shortest(probe.at.y);
      for (const std::string& quantity : quantities) {
        const auto found = probe.values.find(quantity);
        text += found == probe.values.end() ? "," : "," + shortest(found->second);
      }
      text += "\n";
    }
  return text;
}

std::vector<JointResult::Row> rows_and_tips(const JointResult& joint) {
  std::vector<JointResult::Row> rows = joint.rows;
  for (const JointResult::Tip& tip : joint.tips) {
    const auto after =
        std::find_if(rows.begin(), rows.end(), [&](const JointResult::Row& row) { return row.s > tip.s; });
    const int piece = rows.empty() ? 0 : after == rows.begin() ? after->piece : (after - 1)->piece;
    JointResult::Row row{.s = tip.s, .at = tip.at, .closed = true, .piece = piece};
    for (const JointColumn& column : joint_columns)
      if (column.traction) row.*column.value = std::numeric_limits<double>::quiet_NaN();
    rows.insert(after, row);
  }
  return rows;
}

std::string joint_csv(const RunResult& result, const std::string& name) {
  std::string text = "stage,s [m],x [m],y [m]";
  for (const JointColumn& column : joint_columns)
    text += std::string(",") + column.name + (*column.unit ? std::string(" [") + column.unit + "]" : "");
  text += ",state,piece,welded\n";
  bool any = false;
  for (const StageResult& stage : result.stages)
    for (const JointResult& joint : stage.joints) {
      if (joint.name != name) continue;
      any = true;
      const std::string first = csv_field(stage.name);
      for (const JointResult::Row& row : rows_and_tips(joint)) {
        const bool welded = std::isnan(row.pressure);
        text += first;
        for (const double value : {row.s, row.at.x, row.at.y}) text += "," + shortest(value);
        for (const JointColumn& column : joint_columns)
          text += "," + (welded && column.traction ? std::string() : shortest(row.*column.value));
        text += std::string(",") + (welded ? "" : state_word(row.state)) + "," + std::to_string(row.piece) +
                (welded ? ",1\n" : ",0\n");
      }
    }
  return any ? text : std::string();
}

std::vector<std::string> fact_names(std::span<const StageResult> stages) {
  std::vector<std::string> names;
  for (const StageResult& stage : stages)
    for (const Iteration& iteration : stage.iterations)
      for (const auto& [fact, value] : iteration.facts)
        if (std::find(names.begin(), names.end(), fact) == names.end()) names.push_back(fact);
  return names;
}

std::optional<double> fact_of(const Iteration& iteration, const std::string& name) {
  for (const auto& [fact, value] : iteration.facts)
    if (fact == name) return value;
  return {};
}

std::string iterations_csv(const RunResult& result) {
  const std::vector<std::string> facts = fact_names(result.stages);
  std::string text = "stage,step,iteration,residual";
  for (const std::string& fact : facts) text += "," + csv_field(fact);
  text += "\n";
  for (const StageResult& stage : result.stages)
    for (const Iteration& iteration : stage.iterations) {
      text += csv_field(stage.name) + "," + std::to_string(iteration.step) + "," +
              std::to_string(iteration.number) + "," + shortest(iteration.residual);
      for (const std::string& fact : facts) {
        const auto value = fact_of(iteration, fact);
        text += "," + (value ? shortest(*value) : std::string());
      }
      text += "\n";
    }
  return text;
}

}  // namespace ashlar::output
