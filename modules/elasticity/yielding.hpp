#pragma once
// The solid where a law is nonlinear: forces, tangents and internal variables from the integration points.
//
//   n(u) = Σ_cells Σ_q w_q B_qᵀ σ(B_q u, history) + S u,   ∂n/∂u = Σ w_q B_qᵀ D_q B_q + S
//
// S is that of the elastic law throughout, if the element has any: see the module's README for what that
// means near collapse.

#include <set>
#include <string>

#include "elasticity/layout.hpp"
#include "model/effect.hpp"

namespace ashlar::elasticity {

/// What a cell is made of whatever its displacements: its integration points, and S.
struct CellOperators {
  model::IntegrationPoints points;
  std::vector<double> rest;  ///< packed; empty: none
};

class Yielding final : public model::Nonlinear {
 public:
  /// Adds the internal variables to `state`. `fields`: results that are wanted.
  Yielding(const model::Model& model, Layout layout, const model::Scene& scene, std::set<std::string> fields,
           fields::State& state);

  const algebra::Adjacency& groups() const override { return layout_.dofs; }
  bool symmetric() const override { return layout_.symmetric; }
  void add_internal_force(fields::State& state, std::span<double> force) const override;
  void add_tangent(fields::State& state, const algebra::ScatterMap& map, std::span<double> lower,
                   std::span<double> upper) const override;
  void add_tangent_product(fields::State& state, std::span<const double> direction,
                           std::span<double> force) const override;
  std::vector<std::pair<std::string, double>> facts(const fields::State& state) const override;
  std::size_t bytes() const override { return layout_.bytes() + kept_bytes_; }
  void add_group_force(const fields::State& state, Index cell, std::span<double> force) const override;
  void add_results(const fields::State& state, model::StageResult& result) const override;

 private:
  void keep_operators();
  const CellOperators& operators(Index cell) const;
  /// Asks the law at every point of a cell. `trial` receives the cell's internal variables.
  struct CellNow& ask(Index cell, std::span<const double> u, fields::State& state) const;

  const model::Model& model_;
  Layout layout_;
  const model::Scene& scene_;
  std::set<std::string> fields_;
  fields::State::Id history_;
  std::vector<CellOperators> kept_;  ///< by cell; empty: made anew each time
  std::size_t kept_bytes_ = 0;
};

}  // namespace ashlar::elasticity
