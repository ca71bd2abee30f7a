#pragma once
// Hydrostatic pressure as a load: README.md has the equations.

#include <set>

#include "model/edge_load.hpp"
#include "model/effect.hpp"

namespace ashlar::water {

/// γ of a `Water { … }` [N/m³].
double unit_weight(const core::Settings& water);

/// p = γ max(0, level − y), against the outward normal.
model::EdgeTraction pressure(double unit_weight, double level);

class Water final : public model::Effect {
 public:
  void check(const model::Scene& scene, core::Mistakes& mistakes) const override;
  void contribute(const model::StageContext& context, model::Terms& terms) override;

 private:
  std::vector<mesh::Index> wet_edges(const core::Settings& water, const model::StageContext& context);

  std::set<std::pair<std::string, std::string>> warned_;  ///< stage and edge
};

}  // namespace ashlar::water
