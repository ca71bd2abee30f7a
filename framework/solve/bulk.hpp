#pragma once
// The constant part of a stage's matrix: assembled and factored once, and kept while stiffness terms, held
// dofs and kept dofs stay the same.

#include <memory>

#include "algebra/linear_solver.hpp"
#include "core/registry.hpp"
#include "model/term.hpp"

namespace ashlar::solve {

using mesh::Index;

class Bulk {
 public:
  /// `touched`: ascending dofs of the stage's local terms. Throws nothing: see `report()`.
  Bulk(const model::Model& model, std::vector<std::shared_ptr<const model::Stiffness>> stiffness,
       const model::Constraints& constraints, std::vector<Index> touched,
       std::unique_ptr<algebra::LinearSolver> solver);

  /// True if this factorisation serves a stage with these terms and dofs.
  bool serves(const std::vector<std::shared_ptr<const model::Stiffness>>& stiffness,
              const model::Constraints& constraints, std::span<const Index> touched) const;

  const algebra::FactorReport& report() const { return report_; }
  const algebra::LinearSolver& solver() const { return *solver_; }
  /// Unknowns (ascending) of the touched dofs that are free.
  const std::vector<Index>& kept() const { return kept_; }
  /// force += K u over all dofs.
  void add_internal_force(std::span<const double> u, std::span<double> force) const;
  /// ‖K‖∞ over the free unknowns, for backward errors.
  double norm() const { return norm_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void assemble_and_factor(const model::Model& model, const model::Constraints& constraints);

  std::vector<std::shared_ptr<const model::Stiffness>> stiffness_;
  std::vector<char> held_;
  std::vector<Index> touched_, kept_;
  std::unique_ptr<algebra::LinearSolver> solver_;
  algebra::FactorReport report_;
  double norm_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace ashlar::solve
