#include "solve/advance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/ledger.hpp"

namespace ashlar::solve {

namespace {

// A direct solve leaves some 1e-16 times a small growth; more than this is refined, once or twice.
constexpr double good_backward_error = 1e-14;
// A solve that refinement cannot bring below this is refused.
constexpr double worst_backward_error = 1e-9;
constexpr int most_refinements = 4;

double largest(std::span<const double> values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// Bulk part of the residual, K u − load, over all dofs.
std::vector<double> bulk_residual(const Bulk& bulk, std::span<const double> load, std::span<const double> u) {
  std::vector<double> residual(load.size());
  std::transform(load.begin(), load.end(), residual.begin(), [](double f) { return -f; });
  bulk.add_internal_force(u, residual);
  return residual;
}

/// The dofs of local terms out of all.
Eigen::VectorXd touched_values(const LocalTerms& local, std::span<const double> u) {
  Eigen::VectorXd values(static_cast<Index>(local.touched().size()));
  for (Index i = 0; i < values.size(); ++i) values[i] = u[local.touched()[i]];
  return values;
}

std::vector<double> free_part(const model::Constraints& constraints, std::span<const double> all) {
  std::vector<double> part(constraints.dof.size());
  std::transform(constraints.dof.begin(), constraints.dof.end(), part.begin(),
                 [&](Index dof) { return all[dof]; });
  return part;
}

/// K δ = −r with the local terms iterated in their own dofs; δ is added to the trial displacement.
LocalResult correct(const Bulk& bulk, const LocalTerms& local, const model::Constraints& constraints,
                    std::span<const double> residual, fields::State& state,
                    std::vector<model::Iteration>& rows) {
  std::vector<double> right = free_part(constraints, residual);
  for (double& r : right) r = -r;
  std::vector<double> change(right.size());
  LocalResult result{true, false, {}};
  if (right.empty()) return result;
  if (local.empty()) {
    bulk.solver().solve(right, change);
  } else {
    std::vector<double> work;
    const Eigen::VectorXd condensed = bulk.solver().condense(right, work);
    const Eigen::MatrixXd& schur = bulk.solver().schur();
    Eigen::VectorXd u = touched_values(local, state.trial(displacement));
    const Eigen::VectorXd start = u(local.free());
    {
      const auto timing = core::ledger().time("iterate", local.effect());
      result = iterate(local, schur, condensed + schur * start, state, u, rows);
    }
    bulk.solver().expand(work, u(local.free()) - start, change);
  }
  const std::span<double> u = state.trial(displacement);
  for (std::size_t i = 0; i < change.size(); ++i) u[constraints.dof[i]] += change[i];
  return result;
}

}  // namespace

std::vector<double> out_of_balance(const Bulk& bulk, const LocalTerms& local, std::span<const double> load,
                                   const fields::State& state) {
  std::vector<double> residual = bulk_residual(bulk, load, state.trial(displacement));
  if (!local.empty()) {
    Eigen::VectorXd force;
    Eigen::MatrixXd tangent;
    local.evaluate(state, touched_values(local, state.trial(displacement)), force, tangent);
    for (Index i = 0; i < force.size(); ++i) residual[local.touched()[i]] += force[i];
  }
  return residual;
}

StepReport advance(const Bulk& bulk, const LocalTerms& local, const model::Constraints& constraints,
                   const StepTarget& target, fields::State& state) {
  StepReport report;
  const std::span<double> u = state.trial(displacement);
  for (std::size_t dof = 0; dof < u.size(); ++dof)
    if (constraints.held[dof]) u[dof] = target.prescribed[dof];
  if (!local.empty()) local.update_status(state, touched_values(local, u));

  const auto timing = core::ledger().time("solve");
  for (int round = 0; round <= most_refinements; ++round) {
    const std::vector<double> residual = bulk_residual(bulk, target.load, u);
    std::vector<model::Iteration> rows;
    const LocalResult result = correct(bulk, local, constraints, residual, state, rows);
    if (round == 0 || !result.converged || rows.size() > 1)
      report.iterations.insert(report.iterations.end(), rows.begin(), rows.end());
    if (!result.converged) {
      report.reason = result.reason;
      report.advice = result.singular
                          ? "hold the body by a support in this stage, or load it so that its joints close"
                          : "smaller cells along the joint, a softer contact (a smaller penalty factor), or "
                            "the load spread over several stages";
      report.singular = result.singular;
      return report;
    }
    const std::vector<double> left = out_of_balance(bulk, local, target.load, state);
    const double free_most = largest(free_part(constraints, left));
    const double force_scale = std::max({largest(target.load), largest(left), 1e-300});
    report.residual = free_most / force_scale;
    const double before = report.backward_error;
    report.backward_error = free_most / std::max(bulk.norm() * largest(u) + largest(target.load), 1e-300);
    if (!std::isfinite(report.backward_error)) break;
    if (report.backward_error <= good_backward_error) break;
    if (round > 0 && report.backward_error > 0.3 * before) break;  // round-off: no more to gain
  }
  report.converged = report.backward_error <= worst_backward_error;
  if (!report.converged) {
    char text[120];
    std::snprintf(text, sizeof text,
                  "the linear system is too badly conditioned: its backward error stays at %.1e",
                  report.backward_error);
    report.reason = text;
    report.advice =
        "stiffnesses nearer to each other: a smaller penalty factor, moduli that differ less, "
        "cells that are less thin";
  }
  return report;
}

}  // namespace ashlar::solve
