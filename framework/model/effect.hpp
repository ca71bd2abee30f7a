#pragma once
// An effect is what a scene can call for: elasticity, contact, gravity, water. Whether a stage calls for it,
// and which line says so, is in the module's module.lua; only then is the module opened and the effect made.

#include <functional>
#include <memory>

#include "model/scene.hpp"
#include "model/term.hpp"

namespace ashlar::model {

/// What an effect may read when it contributes to a stage.
struct StageContext {
  const Scene& scene;
  const StageData& stage;
  const Model& model;
  fields::State& state;      ///< only to add arrays of its own
  core::Mistakes& mistakes;  ///< what shows only on the mesh: empty groups, missing weights
};

class Effect {
 public:
  virtual ~Effect() = default;
  /// Mistakes in the scene that schemas cannot see. Called once, before anything is computed.
  virtual void check(const Scene&, core::Mistakes&) const {}
  /// Adds its terms of one stage. One object serves all stages: a term that does not change is the same
  /// object again, which is how a stage knows that its matrix did not change.
  virtual void contribute(const StageContext& context, Terms& terms) = 0;
};

/// A module registers an effect as kind "effect" with this signature.
using MakeEffect = std::unique_ptr<Effect>(core::Registry& registry);

}  // namespace ashlar::model
