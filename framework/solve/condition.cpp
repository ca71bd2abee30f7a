#include "solve/condition.hpp"

#include <limits>

#include "algebra/condition.hpp"
#include "core/ledger.hpp"

namespace ashlar::solve {

namespace {

/// Unknowns of local terms are eliminated last: S + C is the system that is left for them.
double with_local_terms(const Bulk& bulk, const LocalTerms& local, const fields::State& state,
                        Index unknowns) {
  const std::span<const double> u = state.trial(displacement);
  Eigen::VectorXd values(static_cast<Index>(local.touched().size())), force;
  for (Index i = 0; i < values.size(); ++i) values[i] = u[local.touched()[i]];
  Eigen::MatrixXd tangent;
  local.evaluate(state, values, force, tangent);
  const Eigen::MatrixXd own = tangent(local.free(), local.free());
  const Eigen::LDLT<Eigen::MatrixXd> factor(bulk.solver().schur() + own);
  if (factor.info() != Eigen::Success || !factor.isPositive() || factor.rcond() < 1e-16)
    return std::numeric_limits<double>::infinity();
  const algebra::Solve solve = [&](std::span<const double> b, std::span<double> x) {
    std::vector<double> work;
    const Eigen::VectorXd condensed = bulk.solver().condense(b, work);
    bulk.solver().expand(work, factor.solve(condensed), x);
  };
  const double norm = bulk.norm() + own.cwiseAbs().rowwise().sum().maxCoeff();
  return norm * algebra::inverse_norm(unknowns, solve, solve);
}

}  // namespace

double condition_estimate(const Bulk& bulk, const LocalTerms& local, const fields::State& state,
                          Index unknowns) {
  const auto timing = core::ledger().time("condition");
  if (unknowns == 0) return 1;
  if (!local.free().empty()) return bulk.symmetric() ? with_local_terms(bulk, local, state, unknowns) : 0;
  // ‖K⁻¹‖∞ = ‖K⁻ᵀ‖₁.
  const algebra::LinearSolver& solver = bulk.solver();
  return bulk.norm() * algebra::inverse_norm(
                           unknowns, [&](auto b, auto x) { solver.solve_transposed(b, x); },
                           [&](auto b, auto x) { solver.solve(b, x); });
}

}  // namespace ashlar::solve
