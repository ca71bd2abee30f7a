#pragma once
// The matrix of a stage's terms that reach all over the body. Constant terms alone: assembled and factored
// once, and kept while terms, held dofs and kept dofs stay the same. With nonlinear ones the constant part is
// kept, and the tangent is factored where Newton asks for it.

#include <memory>

#include "algebra/linear_solver.hpp"
#include "core/registry.hpp"
#include "model/term.hpp"

namespace ashlar::solve {

using mesh::Index;

/// Index of the displacement in the state: added first.
constexpr fields::State::Id displacement = 0;

struct BulkTerms {
  std::vector<std::shared_ptr<const model::Stiffness>> stiffness;
  std::vector<std::shared_ptr<const model::Nonlinear>> nonlinear;
  bool operator==(const BulkTerms&) const = default;
  /// Every tangent is symmetric.
  bool symmetric() const;
};

class Bulk {
 public:
  /// `touched`: ascending dofs of the stage's local terms. Constant terms are factored at once: see
  /// `report()`.
  Bulk(const model::Model& model, BulkTerms terms, const model::Constraints& constraints,
       std::vector<Index> touched, std::unique_ptr<algebra::LinearSolver> solver);

  /// True if this matrix serves a stage with these terms and dofs.
  bool serves(const BulkTerms& terms, const model::Constraints& constraints,
              std::span<const Index> touched) const;
  bool linear() const { return terms_.nonlinear.empty(); }
  bool symmetric() const { return terms_.symmetric(); }

  const algebra::FactorReport& report() const { return report_; }
  const algebra::LinearSolver& solver() const { return *solver_; }
  /// Unknowns (ascending) of the touched dofs that are free.
  const std::vector<Index>& kept() const { return kept_; }
  /// force += K u + f(u) over all dofs at the trial state, whose internal variables follow.
  void add_internal_force(fields::State& state, std::span<double> force) const;
  /// Factors the tangent at the trial state. Nonlinear terms only; see `report()`.
  void linearise(fields::State& state);
  /// force += tangent · direction at the trial state, over all dofs.
  void add_tangent_product(fields::State& state, std::span<const double> direction,
                           std::span<double> force) const;
  /// y = K x over the free unknowns with the tangent that was factored last. Nonlinear terms only.
  void multiply(std::span<const double> x, std::span<double> y) const { algebra::multiply(matrix_, x, y); }
  /// Numbers of the nonlinear terms for the iteration table.
  std::vector<std::pair<std::string, double>> facts(const fields::State& state) const;
  /// ‖K‖∞ over the free unknowns, for backward errors.
  double norm() const { return norm_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void assemble(const model::Constraints& constraints);
  void order(const model::Model& model, const model::Constraints& constraints);
  void factor();

  BulkTerms terms_;
  std::vector<char> held_;
  std::vector<Index> touched_, kept_;
  std::unique_ptr<algebra::LinearSolver> solver_;
  algebra::FactorReport report_;
  algebra::SymmetricMatrix matrix_;        ///< the last that was factored; gone once constant terms are
  std::vector<double> constant_;           ///< values of the constant terms, beside nonlinear ones
  std::vector<algebra::ScatterMap> maps_;  ///< of the nonlinear terms
  double norm_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace ashlar::solve
