#include "model/plan.hpp"

#include <algorithm>
#include <optional>

namespace ashlar::model {

namespace {

using core::Settings;

bool says_something(const core::Value& value) {
  if (value.is_nothing()) return false;
  if (const bool* flag = value.boolean()) return *flag;
  const core::Table* table = value.table();
  return !table || !table->constructor.empty() || !table->items.empty() || !table->entries.empty();
}

// The entry at a path of keys below `settings`, if it was said and is neither false nor empty.
const core::Value* said_at(const Settings& settings, const std::string& path) {
  const auto dot = path.find('.');
  const std::string key = path.substr(0, dot);
  const auto entry = std::find_if(settings.entries.begin(), settings.entries.end(),
                                  [&](const Settings::Entry& e) { return e.key == key; });
  if (entry == settings.entries.end() || !entry->said || !says_something(entry->value)) return nullptr;
  if (dot == std::string::npos) return &entry->value;
  return entry->object ? said_at(*entry->object, path.substr(dot + 1)) : nullptr;
}

/// Where the scene says what calls for an effect: "stage.KEY", "scene.KEY", or "material.LAW" in a region.
std::optional<core::Place> calls(const core::EffectEntry& effect, const Scene& scene,
                                 const StageData& stage) {
  for (const std::string& path : effect.called_by) {
    const auto dot = path.find('.');
    if (dot == std::string::npos) continue;
    const std::string owner = path.substr(0, dot), rest = path.substr(dot + 1);
    if (owner == "material") {
      const auto region = std::ranges::find_if(
          scene.regions, [&](const RegionData& each) { return each.material.name == rest; });
      if (region != scene.regions.end()) return region->material.place;
    } else if (const core::Value* value = said_at(owner == "stage" ? stage.settings : scene.root, rest)) {
      return value->place;
    }
  }
  return {};
}

}  // namespace

Plan make_plan(const Scene& scene, const core::Registry& registry) {
  Plan plan;
  for (const StageData& stage : scene.stages) {
    StagePlan& planned = plan.stages.emplace_back();
    planned.stage = stage.name;
    for (const core::EffectEntry& effect : registry.effects())
      if (const auto place = calls(effect, scene, stage))
        planned.calls.push_back({effect.name, effect.module, *place, effect.nonlinear});
  }
  for (const core::EffectEntry& effect : registry.effects()) {
    const bool called = std::any_of(plan.stages.begin(), plan.stages.end(), [&](const StagePlan& stage) {
      return std::any_of(stage.calls.begin(), stage.calls.end(),
                         [&](const Call& call) { return call.effect == effect.name; });
    });
    if (!called) plan.left_out.push_back(effect);
  }
  return plan;
}

std::map<std::string, std::unique_ptr<Effect>> make_effects(const Plan& plan, const Scene& scene,
                                                            core::Registry& registry,
                                                            core::Mistakes& mistakes) {
  std::map<std::string, std::unique_ptr<Effect>> effects;
  for (const StagePlan& stage : plan.stages)
    for (const Call& call : stage.calls) {
      if (effects.contains(call.effect)) continue;
      effects[call.effect] = registry.make<MakeEffect>("effect", call.effect)(registry);
      effects[call.effect]->check(scene, mistakes);
    }
  return effects;
}

}  // namespace ashlar::model
