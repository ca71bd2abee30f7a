#include "study/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace ashlar::study {

namespace {

using nlohmann::json;

json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  return json::parse(file, nullptr, false);
}

Part part_of(const std::string& phase) {
  if (phase == "mesh") return Part::mesh;
  if (phase == "prepare" || phase == "assemble") return Part::assembly;
  if (phase == "order" || phase == "factor") return Part::factorisation;
  if (phase == "solve" || phase == "iterate") return Part::solve;
  return phase == "recover" || phase == "write" ? Part::output : Part::other;
}

Run read_run(const RunRecord& record, const json& results) {
  Run run;
  run.record = record;
  const auto other = static_cast<std::size_t>(Part::other);
  run.wall[other] = record.wall;
  run.cpu[other] = record.cpu;
  for (const json& row : results.at("timings")) {
    const double wall = row.at("wall"), cpu = row.at("cpu");
    if (const std::string effect = row.at("effect"); !effect.empty()) run.effects[effect] += wall;
    const auto part = static_cast<std::size_t>(part_of(row.at("phase")));
    if (part == other) continue;
    run.wall[part] += wall;
    run.cpu[part] += cpu;
    run.wall[other] -= wall;
    run.cpu[other] -= cpu;
  }
  run.wall[other] = std::max(0.0, run.wall[other]);
  run.cpu[other] = std::max(0.0, run.cpu[other]);
  return run;
}

// The item of that name in a list, or the value of that key; the longest name first, for names hold dots.
const json* step(const json& here, const std::string& path, std::size_t& at) {
  for (std::size_t end = path.size();; end = path.rfind('.', end - 1)) {
    if (end == std::string::npos || end <= at) return nullptr;
    const std::string word = path.substr(at, end - at);
    const json* found = nullptr;
    if (here.is_array())
      for (const json& item : here)
        if (item.is_object() && item.value("name", "") == word) found = &item;
    if (here.is_object() && here.contains(word)) found = &here.at(word);
    if (found) {
      at = end + 1;
      return found;
    }
  }
}

std::optional<double> number_at(const json& root, const std::string& path) {
  const json* here = &root;
  for (std::size_t at = 0; at < path.size();) {
    here = step(*here, path, at);
    if (!here) return {};
  }
  if (!here->is_number()) return {};
  return here->get<double>();
}

std::optional<double> read_probe(const json& stage, const Measure& measure, const std::string& quantity) {
  const auto value = [&](const std::string& probe) -> std::optional<double> {
    const json* probes = stage.contains("probes") ? &stage.at("probes") : nullptr;
    if (!probes || !probes->contains(probe)) return {};
    const json& found = probes->at(probe);
    if (!found.contains(quantity) || !found.at(quantity).is_number()) return {};
    return found.at(quantity).get<double>();
  };
  const auto first = value(measure.probe);
  if (measure.minus.empty() || !first) return first;
  const auto second = value(measure.minus);
  return second ? std::optional(*first - *second) : std::nullopt;
}

/// Iterations of the stage or of all of them; the time of the run or of an effect in it.
std::optional<double> read_cost(const json& results, const Measure& measure, const RunRecord& record) {
  double sum = 0;
  bool found = false;
  if (measure.cost == "iterations") {
    for (const json& stage : results.at("stages")) {
      if (!measure.stage.empty() && stage.value("name", "") != measure.stage) continue;
      sum += static_cast<double>(stage.at("iterations").size());
      found = true;
    }
    return found ? std::optional(sum) : std::nullopt;
  }
  if (measure.effect.empty()) return measure.cost == "cpu" ? record.cpu : record.wall;
  for (const json& row : results.at("timings")) {
    if (row.at("effect") != measure.effect) continue;
    sum += row.at(measure.cost).get<double>();
    found = true;
  }
  return found ? std::optional(sum) : std::nullopt;
}

std::optional<double> read_value(const json& results, const Measure& measure) {
  if (!measure.at.empty()) return number_at(results, measure.at);
  const json* stage = nullptr;
  for (const json& each : results.at("stages"))
    if (measure.stage.empty() || each.value("name", "") == measure.stage) stage = &each;
  if (!stage) return {};
  if (!measure.joint.empty()) {
    const json* joints = stage->contains("joints") ? &stage->at("joints") : nullptr;
    if (!joints || !joints->contains(measure.joint)) return {};
    const json& found = joints->at(measure.joint);
    return found.contains(measure.quantity) && found.at(measure.quantity).is_number()
               ? std::optional(found.at(measure.quantity).get<double>())
               : std::nullopt;
  }
  if (measure.quantity != "u") return read_probe(*stage, measure, measure.quantity);
  const auto x = read_probe(*stage, measure, "ux"), y = read_probe(*stage, measure, "uy");
  return x && y ? std::optional(std::hypot(*x, *y)) : std::nullopt;
}

void read_size(const json& results, Outcome& outcome) {
  const json& mesh = results.at("mesh");
  outcome.cells = mesh.at("cells");
  outcome.h = std::sqrt(mesh.at("area").get<double>() / outcome.cells);
  for (const json& stage : results.at("stages"))
    if (stage.contains("solve"))
      outcome.unknowns = std::max(outcome.unknowns, stage.at("solve").at("unknowns").get<double>());
}

/// Values are those of the first run; of costs, the least of all runs counts.
void read_values(const Study& study, const json& results, const RunRecord& record, Outcome& outcome) {
  const bool first = outcome.values.empty();
  for (std::size_t m = 0; m < study.measures.size(); ++m) {
    const Measure& measure = study.measures[m];
    if (measure.cost.empty() && !first) continue;
    const auto value =
        measure.cost.empty() ? read_value(results, measure) : read_cost(results, measure, record);
    if (first)
      outcome.values.push_back(value);
    else if (value && outcome.values[m])
      outcome.values[m] = std::min(*value, *outcome.values[m]);
    if (first && !value) outcome.missing.push_back("its results lack the measure '" + measure.name + "'");
  }
}

}  // namespace

const Run& Outcome::best() const {
  return *std::ranges::min_element(runs, {}, [](const Run& run) { return run.record.wall; });
}

double Outcome::worst_wall() const {
  double worst = 0;
  for (const Run& run : runs) worst = std::max(worst, run.record.wall);
  return worst;
}

double Outcome::best_cpu() const {
  double least = runs.front().record.cpu;
  for (const Run& run : runs) least = std::min(least, run.record.cpu);
  return least;
}

double Outcome::memory() const {
  std::int64_t most = 0;
  for (const Run& run : runs) most = std::max(most, run.record.memory);
  return static_cast<double>(most);
}

std::filesystem::path results_file(const std::filesystem::path& folder, const std::string& name,
                                   std::size_t number) {
  return folder / "cases" / name / ("run_" + std::to_string(number) + ".json");
}

std::filesystem::path log_file(const std::filesystem::path& folder, const std::string& name,
                               std::size_t number) {
  return folder / "cases" / name / ("run_" + std::to_string(number) + ".log");
}

Outcome read_outcome(const Study& study, const std::filesystem::path& folder, const std::string& name,
                     const CaseRecord& record) {
  Outcome outcome;
  outcome.name = name;
  outcome.reason = "was not run";
  for (std::size_t i = 0; i < record.runs.size(); ++i) {
    const RunRecord& run = record.runs[i];
    if (run.code != 0) {
      outcome.reason =
          "exit code " + std::to_string(run.code) + (run.reason.empty() ? "" : ": " + run.reason);
      outcome.ok = false;
      return outcome;
    }
    const json results = read_json(results_file(folder, name, i + 1));
    if (results.is_discarded()) continue;
    if (outcome.runs.empty()) read_size(results, outcome);
    read_values(study, results, run, outcome);
    outcome.runs.push_back(read_run(run, results));
  }
  outcome.ok = !outcome.runs.empty();
  if (outcome.ok) outcome.reason.clear();
  return outcome;
}

}  // namespace ashlar::study
