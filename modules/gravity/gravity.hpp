#pragma once
// Self-weight as a load: README.md has the equation.

#include "model/effect.hpp"

namespace ashlar::gravity {

/// The acceleration that a stage says [m/s²]: standard gravity for true, 0 for false or nothing.
double acceleration(const core::Settings& stage);

/// Forces of the weight of all cells. Every material's unit weight must be known (≥ 0).
std::shared_ptr<const model::Load> self_weight(const model::Model& model, double g);

class Gravity final : public model::Effect {
 public:
  explicit Gravity(core::Registry& registry) : registry_(registry) {}
  void check(const model::Scene& scene, core::Mistakes& mistakes) const override;
  void contribute(const model::StageContext& context, model::Terms& terms) override;

 private:
  void check_region(const model::Scene& scene, const model::RegionData& region, double g,
                    core::Mistakes& mistakes) const;

  core::Registry& registry_;
  const model::Model* model_ = nullptr;  ///< of `load_`
  double g_ = 0;
  std::shared_ptr<const model::Load> load_;
};

}  // namespace ashlar::gravity
