#pragma once
// What a committed stage is asked for: fields, balance of forces, probes, extreme values.

#include "model/results.hpp"
#include "model/scene.hpp"

namespace ashlar::solve {

/// The forces of a stage at its end.
struct StageForces {
  const model::Terms& terms;
  const model::Constraints& constraints;
  const fields::State& state;
  std::span<const double> out_of_balance;  ///< by dof: reactions in held dofs [N]
  double round_off_scale;  ///< where nothing loads: reactions far below this are round-off [N]
};

/// Sums loads by effect and reactions by support.
model::Balance balance(const model::Model& model, const model::StageData& stage, const StageForces& forces);

/// Values of the point fields in `result` at the scene's probes; `points` are their mesh points.
void add_probes(const model::Scene& scene, const model::Model& model, std::span<const geometry::Index> points,
                model::StageResult& result);

/// Warns of what probes ask for and `result` has no values of at points.
void warn_of_unread(const model::Scene& scene, const model::StageResult& result);

/// Warns of probes that read stresses where materials meet: what is recovered there is a mean of all sides.
void warn_of_mixed_probes(const model::Scene& scene, const model::Model& model,
                          std::span<const geometry::Index> points);

/// Pressures that loads exert between the lips of joints (water, grout), beside the effective ones of
/// contact.
void add_lip_pressures(const model::Model& model, const model::Terms& terms, model::StageResult& result);

/// Least and greatest value of every component of every field in `result`, with their places.
void add_extremes(const model::Model& model, model::StageResult& result);

}  // namespace ashlar::solve
