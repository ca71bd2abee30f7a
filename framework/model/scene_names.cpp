#include "model/scene_names.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/log.hpp"
#include "model/read_shape.hpp"

namespace ashlar::model {

namespace {

bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

using Use = std::function<void(const NameUse&)>;

void visit_texts(const core::Value& value, NameUse name, const Use& use) {
  if (const std::string* word = value.text()) {
    name.word = *word;
    name.place = value.place;
    use(name);
  }
  const core::Table* table = value.table();
  if (!table) return;
  for (const core::Value& item : table->items) visit_texts(item, name, use);
}

void visit_parameter(const core::Settings::Entry& entry, const core::Parameter& parameter,
                     const std::string& kind, const Use& use) {
  const core::Table* table = entry.value.table();
  const bool keyed = table && !table->entries.empty() && table->constructor.empty();
  if (!parameter.refers.empty() && keyed) {
    for (const auto& [key, item] : table->entries) use({key, parameter.refers, kind, item.place});
  } else if (!parameter.refers.empty()) {
    visit_texts(entry.value, {{}, parameter.refers, kind, {}}, use);
  }
  if (!table || !parameter.each || parameter.each->refers.empty()) return;
  const NameUse name{{}, parameter.each->refers, kind, {}};
  for (const core::Value& item : table->items) visit_texts(item, name, use);
  for (const auto& [key, item] : table->entries) visit_texts(item, name, use);
}

// A relative path starts at the folder of the script that says it.
void check_file(const std::string& word, const core::Place& place, core::Mistakes& mistakes) {
  std::filesystem::path path = word;
  if (path.is_relative()) path = std::filesystem::path(place.file).parent_path() / path;
  std::error_code error;
  const std::string name = "'" + path.string() + "'";
  if (!std::filesystem::exists(path, error))
    mistakes.add(place, "there is no file " + name,
                 path.string() == word ? "" : "a relative path starts at the script's folder");
  else if (!std::filesystem::is_regular_file(path, error))
    mistakes.add(place, name + " is no regular file");
  else if (!std::ifstream(path, std::ios::binary).good())
    mistakes.add(place, name + " cannot be read", "may you read it?");
}

}  // namespace

void check_name(const std::string& word, const std::string& what, const core::Place& place,
                const Names& names, core::Mistakes& mistakes) {
  if (what == "file") return check_file(word, place, mistakes);
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

void visit_names(const core::Settings& settings, const core::Registry& registry, const Use& use) {
  const core::Registry::Entry* kind = registry.find(settings.kind, settings.name);
  for (const core::Settings::Entry& entry : settings.entries) {
    const core::Parameter* parameter = kind ? kind->schema.find(entry.key) : nullptr;
    if (parameter) visit_parameter(entry, *parameter, settings.kind, use);
    if (entry.object) visit_names(*entry.object, registry, use);
    for (const auto& [name, object] : entry.objects) visit_names(object, registry, use);
  }
}

void check_names(const core::Settings& settings, const core::Registry& registry, const Names& names,
                 core::Mistakes& mistakes) {
  visit_names(settings, registry,
              [&](const NameUse& name) { check_name(name.word, name.what, name.place, names, mistakes); });
}

void warn_of_held_loads(const Scene& scene, const core::Registry& registry) {
  std::set<std::string> told;
  for (const StageData& stage : scene.stages)
    visit_names(stage.settings, registry, [&](const NameUse& name) {
      if (name.what != "edge" || name.kind == "support") return;
      const bool held =
          std::any_of(stage.supports.begin(), stage.supports.end(), [&](const SupportData& support) {
            return support.edge == name.word && support.move[0] && support.move[1];
          });
      const std::string text = core::to_string(name.place) + ": '" + name.word +
                               "' is held in x and y in stage '" + stage.name +
                               "': what acts on it goes straight to the support";
      if (held && told.insert(core::to_string(name.place)).second) core::log().warning(text);
    });
}

std::vector<std::string> picture_words(const core::Registry& registry) {
  std::vector<std::string> words = {"mesh", "deformed", "joints", "sections", "crosses", "ux", "uy",
                                    "sxx",  "syy",      "sxy",    "szz",      "s1",      "s3", "tmax"};
  for (const std::string& field : registry.names("field")) words.push_back(field);
  return words;
}

Names collect_names(const Scene& scene) {
  Names names;
  for (const char* what : {"edge", "region", "joint", "lip", "probe", "stage"}) names.known[what];
  for (const RegionData& region : scene.regions) {
    names.known["region"].push_back(region.name);
    names.edges_unknown = names.edges_unknown || !region.mesh_group.empty() || !is_whole(region.shape);
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
