#include "model/read_stages.hpp"

#include <algorithm>

#include "model/read_shape.hpp"

namespace ashlar::model {

namespace {

using core::Form;
using core::Mistakes;
using core::Settings;
using core::Table;
using core::Value;

const Table* stages_of(const Value& scene) {
  const Value* stages = scene.table() ? scene.table()->find("stages") : nullptr;
  return stages ? stages->table() : nullptr;
}

bool ends(const Value& value) {
  const bool* flag = value.boolean();
  return flag && !*flag;
}

bool is_end(const std::string& key, const Value& value, const core::Schema& schema) {
  const core::Parameter* parameter = schema.find(key);
  return ends(value) && parameter && !parameter->required && !core::allows(parameter->forms, Form::boolean);
}

Value without_ends_in_stage(const Value& stage, const core::Schema& schema) {
  if (!stage.table()) return stage;
  Table table = *stage.table();
  std::erase_if(table.entries, [&](const auto& entry) { return is_end(entry.first, entry.second, schema); });
  return core::make_value(std::move(table), stage.place);
}

void read_movement(const Settings& support, SupportData& data, Mistakes& mistakes) {
  const std::string fix = support.text("fix");
  const std::array<std::pair<char, const char*>, 2> components = {{{'x', "ux"}, {'y', "uy"}}};
  for (std::size_t c = 0; c < 2; ++c) {
    const auto [letter, key] = components[c];
    const bool fixed = fix.find(letter) != std::string::npos;
    if (fixed) data.move[c] = Value{support.place_of("fix"), {}};
    if (!support.has(key)) continue;
    if (fixed)
      mistakes.add(support.place_of(key), std::string("the same component is held by fix = \"") + fix + "\"",
                   "say one of the two");
    data.move[c] = support.value(key);
  }
}

void read_box(const Settings& support, SupportData& data, Mistakes& mistakes) {
  const Table* box = support.value("box").table();
  if (!box) return;
  if (box->items.size() != 2) {
    mistakes.add(support.place_of("box"),
                 "needs two opposite corners, got " + std::to_string(box->items.size()) + " points");
    return;
  }
  data.box.emplace();
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto corner = core::read_point(box->items[i], {1, 0, 0}, mistakes))
      (*data.box)[i] = {corner->first, corner->second};
}

SupportData read_support(const std::string& name, const Settings& support, const Names& names,
                         Mistakes& mistakes) {
  SupportData data;
  data.name = name;
  data.place = support.place;
  const int places = support.has("edge") + support.has("at") + support.has("box");
  data.edge = support.text("edge");
  if (support.has("at")) {
    const auto [x, y] = support.point("at");
    data.at = {x, y};
  }
  read_box(support, data, mistakes);
  if (places == 0) {
    data.edge = name;
    check_name(name, "edge", support.place, names, mistakes);
  }
  read_movement(support, data, mistakes);
  return data;
}

const Settings* find_object(const Settings::Entry& entry, const std::string& name) {
  for (const auto& [key, object] : entry.objects)
    if (key == name) return &object;
  return nullptr;
}

// What a stage does not say comes from its parent, with the place where it was said.
void inherit(const StageData& parent, StageData& stage, const Table* said) {
  for (Settings::Entry& entry : stage.settings.entries) {
    if (entry.key.empty() || entry.key == "parent") continue;
    const Value* word = said ? said->find(entry.key) : nullptr;
    if (word && ends(*word) && !entry.said) {
      entry = Settings::Entry{entry.key, {}, true, entry.dimension, {}, {}};
      continue;
    }
    if (!entry.said) entry = parent.settings.entry(entry.key);
  }
}

int find_parent(const std::vector<StageData>& stages, std::size_t index, Mistakes& mistakes) {
  const Settings& settings = stages[index].settings;
  const std::string word = settings.text("parent");
  if (word.empty()) return static_cast<int>(index) - 1;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (stages[i].name != word) continue;
    if (i < index) return static_cast<int>(i);
    mistakes.add(settings.place_of("parent"),
                 i == index ? "a stage cannot start from itself"
                            : "'" + word + "' comes later: a stage starts from an earlier one");
    return -1;
  }
  return -1;  // reported with the other names
}

}  // namespace

Value without_ends(const Value& scene, const core::Registry& registry) {
  const Table* stages = stages_of(scene);
  if (!stages) return scene;
  const core::Schema& schema = registry.find("stage", "stage")->schema;
  Table list = *stages;
  for (Value& stage : list.items) stage = without_ends_in_stage(stage, schema);
  Table root = *scene.table();
  for (auto& [key, value] : root.entries)
    if (key == "stages") {
      value = core::make_value(std::move(list), value.place);
      break;
    }
  return core::make_value(std::move(root), scene.place);
}

std::vector<SupportData> read_supports(const Settings& owner, const Names& names, Mistakes& mistakes) {
  std::vector<SupportData> supports;
  const Settings::Entry& entry = owner.entry("supports");
  const Table* table = entry.value.table();
  if (!table) return supports;
  for (const auto& [name, value] : table->entries) {
    if (const Settings* object = find_object(entry, name)) {
      supports.push_back(read_support(name, *object, names, mistakes));
      continue;
    }
    check_name(name, "edge", value.place, names, mistakes);
    if (!value.text()) continue;
    SupportData data;
    data.name = data.edge = name;
    data.place = value.place;
    for (std::size_t c = 0; c < 2; ++c)
      if (value.text()->find("xy"[c]) != std::string::npos) data.move[c] = Value{value.place, {}};
    supports.push_back(std::move(data));
  }
  return supports;
}

std::vector<StageData> read_stage_names(const Settings& root, Mistakes& mistakes) {
  std::vector<StageData> stages;
  for (const auto& [number, settings] : root.objects("stages")) {
    StageData stage;
    stage.settings = settings;
    stage.place = settings.place;
    if (settings.items.size() > 1)
      mistakes.add(settings.place, "a stage has one name, got " + std::to_string(settings.items.size()));
    if (!settings.items.empty() && settings.items[0].text()) stage.name = *settings.items[0].text();
    const std::string why = bad_name(stage.name, true);
    if (!settings.items.empty() && !why.empty()) mistakes.add(settings.place, why);
    for (const StageData& other : stages)
      if (other.name == stage.name && !stage.name.empty())
        mistakes.add(settings.place, "there is a stage '" + stage.name + "' already",
                     "the other one is in line " + std::to_string(other.place.line));
    stages.push_back(std::move(stage));
  }
  const Table* said = root.value("stages").table();
  if (said && said->items.empty()) mistakes.add(root.place_of("stages"), "needs at least one stage");
  return stages;
}

void read_stages(const Value& said, const Settings& root, const Names& names, std::vector<StageData>& stages,
                 Mistakes& mistakes) {
  const Table* list = stages_of(said);
  const std::vector<SupportData> base = read_supports(root, names, mistakes);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    StageData& stage = stages[i];
    stage.parent = find_parent(stages, i, mistakes);
    const Table* words = list && i < list->items.size() ? list->items[i].table() : nullptr;
    const bool own = stage.settings.said("supports");
    stage.supports = own ? read_supports(stage.settings, names, mistakes) : base;
    if (stage.parent < 0) continue;
    const StageData& parent = stages[static_cast<std::size_t>(stage.parent)];
    if (!own) stage.supports = parent.supports;
    inherit(parent, stage, words);
  }
}

}  // namespace ashlar::model
