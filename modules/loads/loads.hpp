#pragma once
// Loads given by the scene: README.md has the equations.

#include "model/effect.hpp"

namespace ashlar::loads {

class Loads final : public model::Effect {
 public:
  void check(const model::Scene& scene, core::Mistakes& mistakes) const override;
  void contribute(const model::StageContext& context, model::Terms& terms) override;
};

}  // namespace ashlar::loads
