#pragma once
// An effect is what a scene can call for: elasticity, contact, gravity, water. Whether a stage calls for it,
// and which line says so, is in the module's module.lua; only then is the module opened and the effect made.

#include <functional>
#include <map>
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
  /// Changes the mesh before anything is numbered on it, such as points that lips need. Called once, for the
  /// effects of the plan in the order of their names.
  virtual void shape_mesh(const Scene&, mesh::Mesh&, core::Mistakes&) const {}
  /// Adds its terms of one stage. One object serves all stages: a term that does not change is the same
  /// object again, which is how a stage knows that its matrix did not change.
  virtual void contribute(const StageContext& context, Terms& terms) = 0;
};

/// By name.
using Effects = std::map<std::string, std::unique_ptr<Effect>>;

/// A module registers an effect as kind "effect" with this signature.
using MakeEffect = std::unique_ptr<Effect>(core::Registry& registry);

}  // namespace ashlar::model
