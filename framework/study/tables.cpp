#include "study/tables.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "output/files.hpp"
#include "output/tables.hpp"
#include "study/cases.hpp"

namespace ashlar::study {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Study& study) {
  std::vector<std::string> keys;
  for (const Case& one : study.cases)
    for (const Setting& setting : one.settings)
      if (std::ranges::find(keys, setting.key) == keys.end()) keys.push_back(setting.key);
  return keys;
}

const Reading* reading_of(const Analysis& analysis, std::size_t measure, std::size_t one) {
  for (const Finding& finding : analysis.findings)
    for (const Reading& reading : finding.readings)
      if (finding.measure == measure && reading.one == one) return &reading;
  return nullptr;
}

std::string number(double value) {
  return std::isnan(value) ? "" : output::shortest(value);
}

std::string heading(const Study& study) {
  std::string line = "case,status,reason";
  for (const std::string& key : keys_of(study)) line += "," + output::csv_field(key);
  line += ",mesh cells,h [m],unknowns,wall [s],worst wall [s],cpu [s],memory [B]";
  for (const char* part : part_names) line += "," + std::string(part) + " [s]";
  for (const Measure& measure : study.measures) {
    const std::string unit = unit_of(measure);
    line += "," + output::csv_field(measure.name + (unit.empty() ? "" : " [" + unit + "]"));
    for (const char* what : {"error", "relative error", "sure error", "front"})
      line += "," + output::csv_field(measure.name + " " + what);
  }
  return line + "\n";
}

std::string row(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis,
                std::size_t c) {
  const Outcome& outcome = outcomes[c];
  std::string line = output::csv_field(outcome.name) + "," + (outcome.ok ? "ok" : "failed") + "," +
                     output::csv_field(outcome.reason);
  for (const std::string& key : keys_of(study)) {
    const core::Value* value = find(study.cases[c], key);
    const core::Quantity* quantity = value ? value->quantity() : nullptr;
    line += "," + output::csv_field(quantity ? output::shortest(quantity->value)
                                    : value  ? shown(*value)
                                             : "");
  }
  if (!outcome.ok) return line + std::string(7 + part_count + 5 * study.measures.size(), ',') + "\n";
  const Run& best = outcome.best();
  for (const double x : {outcome.cells, outcome.h, outcome.unknowns, best.record.wall, outcome.worst_wall(),
                         outcome.best_cpu(), outcome.memory()})
    line += "," + number(x);
  for (const double wall : best.wall) line += "," + number(wall);
  for (std::size_t m = 0; m < study.measures.size(); ++m) {
    const Reading* reading = reading_of(analysis, m, c);
    if (!reading) {
      line += ",,,,,";
      continue;
    }
    for (const double x : {reading->value, reading->error, reading->relative, reading->sure})
      line += "," + number(x);
    line += reading->on_front ? ",1" : ",0";
  }
  return line + "\n";
}

Json run_json(const Run& run) {
  Json json = {{"wall", run.record.wall}, {"cpu", run.record.cpu}, {"memory", run.record.memory}};
  for (std::size_t p = 0; p < part_count; ++p)
    json["parts"][part_names[p]] = {{"wall", run.wall[p]}, {"cpu", run.cpu[p]}};
  json["effects"] = Json::object();
  for (const auto& [effect, wall] : run.effects) json["effects"][effect] = wall;
  return json;
}

Json setting_json(const core::Value& value) {
  if (const core::Quantity* quantity = value.quantity()) return quantity->value;
  if (const bool* flag = value.boolean()) return *flag;
  return shown(value);
}

Json case_json(const Study& study, const Outcome& outcome, const Case& one) {
  Json json = {{"case", outcome.name}, {"ok", outcome.ok}};
  if (!one.without.empty()) json["without"] = one.without;
  json["parameters"] = Json::object();
  for (const Setting& setting : one.settings) json["parameters"][setting.key] = setting_json(setting.value);
  if (!outcome.ok) {
    json["reason"] = outcome.reason;
    return json;
  }
  json["cells"] = outcome.cells;
  json["h"] = outcome.h;
  json["unknowns"] = outcome.unknowns;
  json["values"] = Json::object();
  for (std::size_t m = 0; m < study.measures.size(); ++m)
    json["values"][study.measures[m].name] = outcome.values[m] ? Json(*outcome.values[m]) : Json();
  json["runs"] = Json::array();
  for (const Run& run : outcome.runs) json["runs"].push_back(run_json(run));
  return json;
}

Json rung_json(const Rung& rung) {
  constexpr const char* known[] = {"at most", "interpolated", "extrapolated", "unknown"};
  Json json = {{"relative_error", rung.error}, {"how", known[static_cast<int>(rung.price.known)]}};
  if (rung.price.known == Price::Known::unknown) return json;
  json["wall"] = rung.price.cost;
  json["with"] = rung.with;
  json["from"] = rung.from;
  return json;
}

Json finding_json(const Study& study, const std::vector<Outcome>& outcomes, const Finding& finding) {
  Json json = {{"measure", study.measures[finding.measure].name},
               {"title", study.measures[finding.measure].title},
               {"problem", finding.problem}};
  json["reference"] = {{"value", finding.reference.value},
                       {"uncertainty", finding.reference.uncertainty},
                       {"how", finding.reference.how}};
  json["readings"] = Json::array();
  for (const Reading& reading : finding.readings)
    json["readings"].push_back({{"case", outcomes[reading.one].name},
                                {"value", reading.value},
                                {"error", reading.error},
                                {"relative_error", reading.relative},
                                {"sure_error", reading.sure},
                                {"front", reading.on_front}});
  json["limits"] = Json::array();
  for (const Limit& limit : finding.limits)
    json["limits"].push_back({{"series", limit.series},
                              {"limit", limit.found.limit},
                              {"order", limit.found.order},
                              {"uncertainty", limit.found.uncertainty},
                              {"sound", limit.found.sound},
                              {"why", limit.found.why},
                              {"slope", limit.observed}});
  json["costs"] = Json::array();
  for (const Rung& rung : finding.ladder) json["costs"].push_back(rung_json(rung));
  json["sentences"] = finding.sentences;
  return json;
}

}  // namespace

std::string study_csv(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis) {
  std::string text = heading(study);
  for (std::size_t c = 0; c < outcomes.size(); ++c) text += row(study, outcomes, analysis, c);
  return text;
}

std::string study_json(const Study& study, const std::vector<Outcome>& outcomes, const Analysis& analysis) {
  Json json = {{"title", study.title}, {"refine", study.refine}, {"threads", study.threads}};
  json["cases"] = Json::array();
  for (std::size_t c = 0; c < outcomes.size(); ++c)
    json["cases"].push_back(case_json(study, outcomes[c], study.cases[c]));
  json["findings"] = Json::array();
  for (const Finding& finding : analysis.findings)
    json["findings"].push_back(finding_json(study, outcomes, finding));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ashlar::study
