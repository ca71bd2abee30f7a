#pragma once
// Which effects each stage calls for, and which line of the script says so. Made from the scene alone: no
// module is opened for it.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "model/effect.hpp"

namespace ashlar::model {

/// One effect that a stage calls for.
struct Call {
  std::string effect;
  std::string module;
  core::Place place;  ///< the entry of the script that calls for it
  bool nonlinear = false;
};

struct StagePlan {
  std::string stage;
  std::vector<Call> calls;
};

struct Plan {
  std::vector<StagePlan> stages;
  std::vector<core::EffectEntry> left_out;  ///< effects that no stage calls for, with what that means
};

Plan make_plan(const Scene& scene, const core::Registry& registry);

/// Makes the effects that the plan calls for (opening their modules) and lets each check the scene.
std::map<std::string, std::unique_ptr<Effect>> make_effects(const Plan& plan, const Scene& scene,
                                                            core::Registry& registry,
                                                            core::Mistakes& mistakes);

}  // namespace ashlar::model
