#include "solve/condition.hpp"

#include <limits>

#include "algebra/condition.hpp"
#include "core/ledger.hpp"

namespace ashlar::solve {

namespace {

/// With joints the matrix is that of the bulk and of joints that touch everywhere with their ground
/// stiffness.
double with_local_terms(const Bulk& bulk, const LocalTerms& local, Index unknowns) {
  const Eigen::SparseMatrix<double> b = local.free_jumps();
  const Eigen::MatrixXd own = b.transpose() * local.area().cwiseProduct(local.ground()).asDiagonal() * b;
  const Eigen::LDLT<Eigen::MatrixXd> factor(bulk.solver().schur() + own);
  if (factor.info() != Eigen::Success || !factor.isPositive() || factor.rcond() < 1e-16)
    return std::numeric_limits<double>::infinity();
  const algebra::Solve solve = [&](std::span<const double> right, std::span<double> x) {
    std::vector<double> work;
    const Eigen::VectorXd condensed = bulk.solver().condense(right, work);
    bulk.solver().expand(work, factor.solve(condensed), x);
  };
  const double norm = bulk.norm() + own.cwiseAbs().rowwise().sum().maxCoeff();
  return norm * algebra::inverse_norm(unknowns, solve, solve);
}

}  // namespace

double condition_estimate(const Bulk& bulk, const LocalTerms& local, Index unknowns) {
  const auto timing = core::ledger().time("condition");
  if (unknowns == 0) return 1;
  if (!local.free().empty()) return bulk.symmetric() ? with_local_terms(bulk, local, unknowns) : 0;
  // ‖K⁻¹‖∞ = ‖K⁻ᵀ‖₁.
  const algebra::LinearSolver& solver = bulk.solver();
  return bulk.norm() * algebra::inverse_norm(
                           unknowns, [&](auto b, auto x) { solver.solve_transposed(b, x); },
                           [&](auto b, auto x) { solver.solve(b, x); });
}

}  // namespace ashlar::solve
