#include "model/scene_names.hpp"

#include <algorithm>

#include "model/read_shape.hpp"

namespace ashlar::model {

namespace {

bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

void check_texts(const core::Value& value, const std::string& what, const Names& names,
                 core::Mistakes& mistakes) {
  if (const std::string* word = value.text()) check_name(*word, what, value.place, names, mistakes);
  const core::Table* table = value.table();
  if (!table) return;
  for (const core::Value& item : table->items) check_texts(item, what, names, mistakes);
}

void check_parameter(const core::Settings::Entry& entry, const core::Parameter& parameter, const Names& names,
                     core::Mistakes& mistakes) {
  const core::Table* table = entry.value.table();
  const bool keyed = table && !table->entries.empty() && table->constructor.empty();
  if (!parameter.refers.empty() && keyed) {
    for (const auto& [key, item] : table->entries)
      check_name(key, parameter.refers, item.place, names, mistakes);
  } else if (!parameter.refers.empty()) {
    check_texts(entry.value, parameter.refers, names, mistakes);
  }
  if (!table || !parameter.each || parameter.each->refers.empty()) return;
  for (const core::Value& item : table->items) check_texts(item, parameter.each->refers, names, mistakes);
  for (const auto& [key, item] : table->entries) check_texts(item, parameter.each->refers, names, mistakes);
}

}  // namespace

void check_name(const std::string& word, const std::string& what, const core::Place& place,
                const Names& names, core::Mistakes& mistakes) {
  if (what == "edge" && names.edges_unknown) return;
  const auto found = names.known.find(what);
  const std::vector<std::string> valid =
      found == names.known.end() ? std::vector<std::string>() : found->second;
  if (has(valid, word)) return;
  const std::string problem = "there is no " + what + " '" + word + "'";
  // "upstream" was meant as "dam.upstream".
  for (const std::string& full : valid)
    if (full.ends_with("." + word)) {
      mistakes.add(place, problem, core::did_you_mean(full, valid));
      return;
    }
  mistakes.add(place, problem, valid.empty() ? "the scene has none" : core::did_you_mean(word, valid));
}

void check_names(const core::Settings& settings, const core::Registry& registry, const Names& names,
                 core::Mistakes& mistakes) {
  const core::Registry::Entry* kind = registry.find(settings.kind, settings.name);
  for (const core::Settings::Entry& entry : settings.entries) {
    const core::Parameter* parameter = kind ? kind->schema.find(entry.key) : nullptr;
    if (parameter) check_parameter(entry, *parameter, names, mistakes);
    if (entry.object) check_names(*entry.object, registry, names, mistakes);
    for (const auto& [name, object] : entry.objects) check_names(object, registry, names, mistakes);
  }
}

Names collect_names(const Scene& scene) {
  Names names;
  for (const char* what : {"edge", "region", "joint", "lip", "probe", "stage"}) names.known[what];
  for (const RegionData& region : scene.regions) {
    names.known["region"].push_back(region.name);
    names.edges_unknown = names.edges_unknown || !region.mesh_group.empty();
    for (const std::string& edge : edge_names(region.shape))
      names.known["edge"].push_back(region.name + "." + edge);
  }
  for (const JointData& joint : scene.joints) {
    names.known["joint"].push_back(joint.line.name);
    for (const std::string& side : joint.line.sides)
      for (const char* what : {"edge", "lip"}) names.known[what].push_back(joint.line.name + "." + side);
  }
  for (const ProbeData& probe : scene.probes) names.known["probe"].push_back(probe.name);
  for (const StageData& stage : scene.stages) names.known["stage"].push_back(stage.name);
  return names;
}

}  // namespace ashlar::model
