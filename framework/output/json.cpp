#include "output/json.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "output/tables.hpp"

#include "output/joint_columns.hpp"

namespace ashlar::output {

namespace {

using Json = nlohmann::ordered_json;

Json object() {
  return Json::object();
}

Json resultant(const model::Resultant& force) {
  return Json{{"x", force.x}, {"y", force.y}, {"moment", force.moment}};
}

Json probes(const model::StageResult& stage) {
  Json json = object();
  for (const model::ProbeResult& probe : stage.probes) {
    Json& each = json[probe.name];
    each = Json{{"x", probe.at.x}, {"y", probe.at.y}};
    for (const auto& [quantity, value] : probe.values) each[quantity] = value;
  }
  return json;
}

Json profile(const model::JointResult& joint) {
  Json rows = Json::array();
  for (const auto& row : joint.rows) {
    Json& each = rows.emplace_back(Json{{"s", row.s}, {"x", row.at.x}, {"y", row.at.y}});
    for (const JointColumn& column : joint_columns) each[column.name] = row.*column.value;
    each["state"] = state_word(row.state);
    each["closed"] = row.closed;
    each["piece"] = row.piece;
  }
  return rows;
}

Json joints(const model::StageResult& stage) {
  Json json = object();
  for (const model::JointResult& joint : stage.joints) {
    Json& each = json[joint.name];
    for (const JointNumber& number : joint_numbers) each[number.name] = joint.*number.value;
    each["resultant"] = resultant(joint.resultant);
    each["closed"] = joint.closed;
    each["slipping"] = joint.slipping;
    each["points"] = joint.points;
    each["profile"] = profile(joint);
  }
  return json;
}

Json forces(const model::SectionForces& forces) {
  return Json{{"N", forces.normal}, {"V", forces.shear}, {"M", forces.moment}};
}

Json row_values(const model::SectionResult& section, const model::SectionResult::Row& row) {
  Json json = object();
  for (std::size_t k = 0; k < row.values.size(); ++k) json[section.columns[k].name] = row.values[k];
  return json;
}

Json profile(const model::SectionResult& section) {
  Json rows = Json::array();
  for (const auto& row : section.rows) {
    Json each = {{"s", row.s},           {"x", row.at.x},     {"y", row.at.y}, {"side", side_name(row.side)},
                 {"region", row.region}, {"piece", row.piece}};
    each.update(row_values(section, row));
    rows.push_back(std::move(each));
  }
  return rows;
}

Json sections(const model::StageResult& stage) {
  Json json = object();
  for (const model::SectionResult& section : stage.sections) {
    Json& each = json[section.name];
    each = section.summed ? forces(section.forces) : object();
    each["first"] = {section.first.x, section.first.y};
    each["last"] = {section.last.x, section.last.y};
    each["ends_inside"] = section.ends_inside;
    if (section.integrated) {
      each["integral"] = forces(section.integral);
      each["difference"] = section.difference;
    }
    if (section.rows.empty()) continue;
    // Both ends have names: a path into the profile would have to count rows.
    each["begin"] = row_values(section, section.rows.front());
    each["end"] = row_values(
        section, *std::ranges::max_element(section.rows, {}, [](const auto& row) { return row.s; }));
    each["profile"] = profile(section);
  }
  return json;
}

Json balance(const model::Balance& balance) {
  Json loads = object(), reactions = object();
  for (const auto& [name, force] : balance.loads) loads[name] = resultant(force);
  for (const auto& [name, force] : balance.reactions) reactions[name] = resultant(force);
  return Json{{"loads", loads},
              {"reactions", reactions},
              {"load", resultant(balance.load)},
              {"reaction", resultant(balance.reaction)},
              {"relative_error", balance.relative_error}};
}

Json iterations(const model::StageResult& stage) {
  Json rows = Json::array();
  for (const model::Iteration& iteration : stage.iterations) {
    Json row = {{"step", iteration.step}, {"number", iteration.number}, {"residual", iteration.residual}};
    for (const auto& [fact, value] : iteration.facts) row[fact] = value;
    rows.push_back(std::move(row));
  }
  return rows;
}

Json extremes(const model::StageResult& stage) {
  Json json = object();
  for (const model::Extreme& extreme : stage.extremes)
    json[extreme.quantity] = {{"unit", extreme.unit},
                              {"least", extreme.least},
                              {"least_at", {extreme.least_at.x, extreme.least_at.y}},
                              {"greatest", extreme.greatest},
                              {"greatest_at", {extreme.greatest_at.x, extreme.greatest_at.y}}};
  return json;
}

Json norms(const model::StageResult& stage) {
  Json json = object();
  for (const model::NormResult& norm : stage.norms)
    json[norm.name][norm.quantity] = {
        {"error", norm.error}, {"norm", norm.norm}, {"relative", norm.relative()}, {"unit", norm.unit}};
  return json;
}

Json stage_json(const model::StageResult& stage) {
  Json json = {{"name", stage.name}, {"converged", stage.converged}};
  json["effects"] = stage.effects;
  json["iterations"] = iterations(stage);
  if (!stage.converged) {
    json["reason"] = stage.reason;
    json["advice"] = stage.advice;
    return json;
  }
  json["probes"] = probes(stage);
  json["joints"] = joints(stage);
  json["sections"] = sections(stage);
  json["balance"] = balance(stage.balance);
  json["extremes"] = extremes(stage);
  if (!stage.norms.empty()) json["norms"] = norms(stage);
  json["solve"] = {{"unknowns", stage.unknowns},
                   {"kept", stage.kept},
                   {"factored", stage.factored},
                   {"solver", stage.solver},
                   {"backward_error", stage.backward_error},
                   {"forward_error", stage.forward_error}};
  if (stage.condition > 0) json["solve"]["condition"] = stage.condition;
  return json;
}

Json mesh_json(const mesh::MeshReport& report) {
  Json json = {{"cells", report.cells},
               {"points", report.points},
               {"edges", report.edges},
               {"area", report.area},
               {"size_min", report.size_min},
               {"size_mean", report.size_mean},
               {"size_max", report.size_max},
               {"corners_min", report.corners_min},
               {"corners_mean", report.corners_mean},
               {"corners_max", report.corners_max},
               {"shortest_edge", report.shortest_edge},
               {"shortest_edge_ratio", report.shortest_edge_ratio},
               {"roundness_min", report.roundness_min},
               {"roundness_mean", report.roundness_mean}};
  json["notes"] = object();
  for (const auto& [name, text] : report.notes) json["notes"][name] = text;
  return json;
}

Json timings(const core::Ledger& ledger) {
  Json rows = Json::array();
  for (const core::Cost& cost : ledger.rows())
    rows.push_back({{"phase", cost.phase},
                    {"effect", cost.effect},
                    {"wall", cost.wall},
                    {"cpu", cost.cpu},
                    {"calls", cost.calls},
                    {"bytes", cost.bytes},
                    {"unknowns", cost.unknowns}});
  return rows;
}

Json effects(const model::Plan& plan) {
  Json simulated = object(), left_out = object();
  for (const model::StagePlan& stage : plan.stages)
    for (const model::Call& call : stage.calls)
      simulated[stage.stage][call.effect] = {{"module", call.module}, {"called_by", to_string(call.place)}};
  for (const core::EffectEntry& effect : plan.left_out) left_out[effect.name] = effect.left_out;
  return Json{{"simulated", simulated}, {"left_out", left_out}};
}

}  // namespace

std::string results_json(const RunRecord& record) {
  Json json = {{"title", record.scene.title}, {"converged", record.result.converged}};
  json["stages"] = Json::array();
  for (const model::StageResult& stage : record.result.stages) json["stages"].push_back(stage_json(stage));
  json["mesh"] = mesh_json(record.mesh_report);
  json["timings"] = timings(record.ledger);
  json["memory"] = {{"peak_bytes", core::peak_memory()}};
  json["effects"] = effects(record.plan);
  json["modules"] = record.modules;
  json["parameters"] = object();
  for (const ParameterValue& parameter : record.parameters)
    json["parameters"][parameter.name] = parameter.value;
  json["versions"] = object();
  for (const auto& [name, version] : record.versions) json["versions"][name] = version;
  // Names may hold bytes that are no UTF-8; they must not cost a run its results.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ashlar::output
