#pragma once
// Stage after stage: advance, then commit or revert. A stage of linear terms is one factorisation and one
// solve; a stage whose matrix did not change does not factor again; local terms iterate on their own dofs.

#include <functional>
#include <map>
#include <memory>

#include "core/registry.hpp"
#include "model/effect.hpp"
#include "model/plan.hpp"
#include "model/results.hpp"

namespace ashlar::solve {

/// Told about the march as it goes.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void stage_begins(const std::string& /*name*/, int /*number*/, int /*of*/) {}
  virtual void iterated(const model::Iteration&) {}
  /// The stage is committed. Its results are kept by the march too.
  virtual void stage_ends(const model::StageResult&) {}
};

struct MarchInput {
  const model::Scene& scene;
  const model::Plan& plan;
  const model::Model& model;
  core::Registry& registry;
  std::map<std::string, std::unique_ptr<model::Effect>>& effects;
};

/// Runs all stages. Stops at the first that does not converge: its StageResult says why, and those before it
/// stand. Throws InputError for mistakes that show only on the mesh (before the first stage is solved).
model::RunResult march(const MarchInput& input, Observer& observer);

}  // namespace ashlar::solve
