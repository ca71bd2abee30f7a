#pragma once
// The elastic bulk: stiffness of all cells, and stresses from displacements.

#include <set>
#include <string>

#include "elasticity/yielding.hpp"

namespace ashlar::elasticity {

/// Names of the fields that a run can ask for.
inline const std::set<std::string> all_fields = {
    "utilisation",  "utilisation_nodes", "displacement",           "strain",
    "stress",       "principal_stress",  "principal_angle",        "von_mises",
    "stress_nodes", "von_mises_nodes",   "principal_stress_nodes", "principal_angle_nodes"};

class Bulk final : public model::Stiffness {
 public:
  /// `fields`: those of `all_fields` that are wanted as results.
  /// `scene`: its exact solutions, if it is there, are compared with.
  Bulk(const model::Model& model, std::set<std::string> fields, const model::Scene* scene = nullptr);

  const algebra::Adjacency& groups() const override { return layout_.dofs; }
  void add_tangent(const algebra::ScatterMap& map, std::span<double> value) const override;
  void add_internal_force(std::span<const double> u, std::span<double> force) const override;
  std::size_t bytes() const override;
  void add_group_force(const fields::State& state, Index cell, std::span<double> force) const override;
  void add_results(const fields::State& state, model::StageResult& result) const override;

 private:
  const model::Model& model_;
  std::set<std::string> fields_;
  const model::Scene* scene_;
  Layout layout_;
};

/// Adds the wanted fields of displacement, strain and stress. `history`: internal variables of all points.
void add_solid_results(const model::Model& model, const Layout& layout, const std::set<std::string>& fields,
                       std::span<const double> u, std::span<const double> history,
                       model::StageResult& result);

/// Named in the plan where a region's law yields; the forces are those of Elasticity.
class Plasticity final : public model::Effect {
 public:
  void contribute(const model::StageContext&, model::Terms&) override {}
};

class Elasticity final : public model::Effect {
 public:
  void contribute(const model::StageContext& context, model::Terms& terms) override;

 private:
  std::shared_ptr<const Bulk> bulk_;  ///< if every law is linear
  std::shared_ptr<const Yielding> yielding_;
};

}  // namespace ashlar::elasticity
