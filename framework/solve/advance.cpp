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
// Displacements that round-off changes by more than this share are refused: engineers ask for three digits.
constexpr double worst_forward_error = 1e-4;
constexpr int most_refinements = 4;
// Newton converges quadratically near the solution: half a dozen steps, or the step is too large.
constexpr int most_newton_steps = 15;
// Forces in balance relative to the largest: three digits above the round-off of a badly conditioned tangent.
constexpr double newton_tolerance = 1e-10;
// A full step that leaves forces larger than they were is shortened so many times by half.
constexpr int most_halvings = 4;
// A residual this much above the first will not come back.
constexpr double diverged = 1e4;

double largest(std::span<const double> values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// Bulk part of the residual, K u + n(u) − load, over all dofs.
std::vector<double> bulk_residual(const Bulk& bulk, std::span<const double> load, fields::State& state) {
  std::vector<double> residual(load.size());
  std::transform(load.begin(), load.end(), residual.begin(), [](double f) { return -f; });
  bulk.add_internal_force(state, residual);
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

/// K δ = −r with the local terms iterated in their own dofs; δ is added to the trial displacement and to
/// `total`.
LocalResult correct(const Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                    std::span<const double> residual, fields::State& state,
                    std::vector<model::Iteration>& rows, std::vector<double>& total) {
  std::vector<double> right = free_part(constraints, residual);
  for (double& r : right) r = -r;
  std::vector<double> change(right.size());
  total.resize(right.size());
  LocalResult result{true, false, {}};
  if (right.empty()) return result;
  if (local.empty()) {
    bulk.solver().solve(right, change);
  } else {
    std::vector<double> work;
    const Eigen::VectorXd right_kept = bulk.solver().condense(right, work);
    const Condensed& condensed = local.condensed(bulk);
    Eigen::VectorXd u = touched_values(local, state.trial(displacement));
    const Eigen::VectorXd start = u(local.free());
    {
      const auto timing = core::ledger().time("iterate", local.effect());
      result = iterate(local, condensed, right_kept + bulk.solver().schur() * start, state, u, rows);
    }
    bulk.solver().expand(work, u(local.free()) - start, change);
  }
  const std::span<double> u = state.trial(displacement);
  for (std::size_t i = 0; i < change.size(); ++i) {
    u[constraints.dof[i]] += change[i];
    total[i] += change[i];
  }
  return result;
}

}  // namespace

std::vector<double> out_of_balance(const Bulk& bulk, const LocalTerms& local, std::span<const double> load,
                                   fields::State& state) {
  std::vector<double> residual = bulk_residual(bulk, load, state);
  local.add_force(state, residual);
  return residual;
}

namespace {

/// The unknown whose forces balance least.
Index worst_unknown(std::span<const double> free) {
  const auto most = std::ranges::max_element(free, {}, [](double r) { return std::abs(r); });
  return most == free.end() ? -1 : static_cast<Index>(most - free.begin());
}

void stop(const LocalResult& result, const LocalTerms& local, StepReport& report) {
  report.reason = result.reason;
  report.advice =
      result.singular
          ? "hold the body by a support in this stage, load it so that its joints close, or give them more "
            "strength"
          : "smaller cells along the joint, a softer contact (a smaller penalty factor), or "
            "the load spread over several stages";
  report.singular = result.singular;
  report.held_before = result.held_before;
  report.mechanism = {local.touched(), result.motion};
}

void refuse(StepReport& report) {
  char text[120];
  std::snprintf(text, sizeof text,
                "the linear system is too badly conditioned: its backward error stays at %.1e",
                report.backward_error);
  report.reason = text;
  report.advice =
      "stiffnesses nearer to each other: a smaller penalty factor, moduli that differ less, "
      "cells that are less thin";
}

void refuse_barely_held(StepReport& report) {
  char text[120];
  std::snprintf(text, sizeof text,
                "round-off alone changes displacements by %.1g of the largest, most of all",
                report.forward_error);
  report.reason = text;
  report.advice =
      "the body is barely held: support it at more points or farther apart; or cells that are less thin, "
      "moduli that differ less";
}

/// Whether another round of refinement is called for, and may help.
bool refine_again(int round, double before, double error) {
  if (!std::isfinite(error) || error <= good_backward_error || round == most_refinements) return false;
  return round == 0 || error <= 0.3 * before;  // else round-off: no more to gain
}

/// The largest force when the step begins, from the bulk's residual: one that takes all load off ends with
/// none to measure by.
double most_force_at_start(const LocalTerms& local, const StepTarget& target, std::vector<double> residual,
                           fields::State& state) {
  if (largest(state.trial(displacement)) == 0) return std::max(largest(target.load), 1e-300);
  local.add_force(state, residual);
  return std::max({largest(target.load), largest(residual), 1e-300});
}

/// Bulk part of the residual in free dofs when the step begins. In balance K u = f₀ − c, with f₀ the load
/// then and c the joints' forces, so that K u − f = f₀ − c − f without K u: exactly 0 where nothing changes.
std::vector<double> residual_at_start(const Bulk& bulk, const LocalTerms& local, const StepTarget& target,
                                      fields::State& state) {
  if (target.balanced.empty()) return bulk_residual(bulk, target.load, state);
  std::vector<double> residual(target.load.size());
  local.add_force(state, residual);
  for (std::size_t dof = 0; dof < residual.size(); ++dof)
    residual[dof] = target.balanced[dof] - target.load[dof] - residual[dof];
  return residual;
}

/// Moves held dofs to their places; false if they are there.
bool move_held(const model::Constraints& constraints, const StepTarget& target, std::span<double> u) {
  bool moved = false;
  for (std::size_t dof = 0; dof < u.size(); ++dof) {
    if (!constraints.held[dof] || u[dof] == target.prescribed[dof]) continue;
    u[dof] = target.prescribed[dof];
    moved = true;
  }
  return moved;
}

/// What round-off does to the displacements, relative to the largest: K⁻¹ of the forces that it left.
double forward_error(const Bulk& bulk, std::span<const double> left, double most_u, Index& worst) {
  if (left.empty() || most_u == 0) return 0;
  std::vector<double> change(left.size());
  bulk.solver().solve(left, change);
  worst = worst_unknown(change);
  return largest(change) / most_u;
}

/// One solve, and refinements where its backward error asks for them.
StepReport solve_linear(const Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                        const StepTarget& target, fields::State& state) {
  StepReport report;
  const std::span<double> u = state.trial(displacement);
  double most_u = largest(u);
  std::vector<double> residual = residual_at_start(bulk, local, target, state);
  const double most_force = most_force_at_start(local, target, residual, state);
  bool current = !move_held(constraints, target, u);
  std::vector<double> change;
  for (int round = 0;; ++round) {
    if (!current) residual = bulk_residual(bulk, target.load, state);
    current = false;
    std::vector<model::Iteration> rows;
    const LocalResult result = correct(bulk, local, constraints, residual, state, rows, change);
    if (round == 0 || !result.converged || rows.size() > 1)
      report.iterations.insert(report.iterations.end(), rows.begin(), rows.end());
    if (!result.converged) {
      stop(result, local, report);
      return report;
    }
    std::vector<double> left = out_of_balance(bulk, local, target.load, state);
    const std::vector<double> free = free_part(constraints, left);
    report.residual = largest(free) / std::max(most_force, largest(left));
    report.out_of_balance = std::move(left);
    report.worst = worst_unknown(free);
    most_u = std::max(most_u, largest(u));
    const double before = report.backward_error;
    report.backward_error = largest(free) / std::max(bulk.norm() * most_u + largest(target.load), 1e-300);
    if (refine_again(round, before, report.backward_error)) continue;
    report.converged = report.backward_error <= worst_backward_error;
    if (!report.converged) refuse(report);
    if (!report.converged || !local.empty()) return report;
    report.forward_error = forward_error(bulk, free, most_u, report.worst);
    report.converged = report.forward_error <= worst_forward_error;
    if (!report.converged) refuse_barely_held(report);
    return report;
  }
}

/// The residual that a Newton step starts from. In the first, held dofs move to their places along the
/// tangent, so that no cell sees the whole of it at once.
std::vector<double> newton_residual(const Bulk& bulk, const StepTarget& target,
                                    const model::Constraints& constraints, fields::State& state) {
  std::vector<double> residual = bulk_residual(bulk, target.load, state);
  const std::span<double> u = state.trial(displacement);
  std::vector<double> move(u.size());
  bool moves = false;
  for (std::size_t dof = 0; dof < u.size(); ++dof) {
    if (!constraints.held[dof] || u[dof] == target.prescribed[dof]) continue;
    move[dof] = target.prescribed[dof] - u[dof];
    moves = true;
  }
  if (!moves) return residual;
  bulk.add_tangent_product(state, move, residual);
  for (std::size_t dof = 0; dof < u.size(); ++dof) u[dof] += move[dof];
  return residual;
}

/// A Newton correction.
struct Correction {
  LocalResult local;
  double backward_error = 0;
};

/// K δ + c(u + δ) = −r with the tangent K that was factored, refined as in linear stages.
Correction newton_correction(const Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                             const std::vector<double>& residual, fields::State& state) {
  Correction found;
  const double right = largest(free_part(constraints, residual));
  std::vector<double> now = residual, change;
  for (int round = 0;; ++round) {
    std::vector<model::Iteration> rows;
    found.local = correct(bulk, local, constraints, now, state, rows, change);
    if (!found.local.converged || change.empty()) return found;
    std::vector<double> product(change.size());
    bulk.multiply(change, product);
    now = residual;
    for (std::size_t i = 0; i < product.size(); ++i) now[constraints.dof[i]] += product[i];
    std::vector<double> left = now;
    local.add_force(state, left);
    // Local forces are those of the whole displacement, and round with it.
    const double size = local.empty() ? largest(change) : largest(state.trial(displacement));
    const double before = found.backward_error;
    found.backward_error =
        largest(free_part(constraints, left)) / std::max(bulk.norm() * size + right, 1e-300);
    if (!refine_again(round, before, found.backward_error)) return found;
  }
}

/// Measures what is out of balance after a Newton step against the largest force, at least `most_force`, and
/// adds a row to the iteration table.
void measure(const Bulk& bulk, const LocalTerms& local, const model::Constraints& constraints,
             const StepTarget& target, fields::State& state, double most_force, StepReport& report) {
  const std::vector<double> left = out_of_balance(bulk, local, target.load, state);
  const std::vector<double> free = free_part(constraints, left);
  report.residual = largest(free) / std::max(largest(left), most_force);
  report.worst = worst_unknown(free);
  const int number = static_cast<int>(report.iterations.size()) + 1;
  report.iterations.push_back({1, number, report.residual, bulk.facts(state)});
}

double length(std::span<const double> values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum);
}

/// Forces out of balance in the free dofs.
double imbalance(const Bulk& bulk, const model::Constraints& constraints, const StepTarget& target,
                 fields::State& state) {
  return length(free_part(constraints, bulk_residual(bulk, target.load, state)));
}

/// Shortens the step from `before` to the trial displacement while that lessens the imbalance.
void shorten(const Bulk& bulk, const model::Constraints& constraints, const StepTarget& target,
             std::span<const double> before, double was, fields::State& state) {
  const std::span<double> u = state.trial(displacement);
  const std::vector<double> full(u.begin(), u.end());
  std::vector<double> best = full;
  double least = imbalance(bulk, constraints, target, state), share = 1;
  for (int i = 0; i < most_halvings && !(least < was); ++i) {
    share /= 2;
    for (std::size_t dof = 0; dof < u.size(); ++dof) u[dof] = before[dof] + share * (full[dof] - before[dof]);
    const double now = imbalance(bulk, constraints, target, state);
    if (now < least || !std::isfinite(least)) {
      least = now;
      best.assign(u.begin(), u.end());
    }
  }
  std::copy(best.begin(), best.end(), u.begin());
}

void tell_unsettled(StepReport& report) {
  char text[120];
  std::snprintf(text, sizeof text,
                "Newton's iteration does not settle: %.1e of the forces stay out of balance, most of them",
                report.residual);
  report.reason = text;
  report.advice =
      "the body may not carry this load: less of it, more strength, or displacements given in its place";
}

/// Newton with the tangent of the laws; local terms settle inside each step.
StepReport solve_newton(Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                        const StepTarget& target, fields::State& state) {
  StepReport report;
  double first = 0;
  const double most_force =
      most_force_at_start(local, target, bulk_residual(bulk, target.load, state), state);
  for (int number = 1; number <= most_newton_steps; ++number) {
    bulk.linearise(state);
    local.bulk_changed();
    if (!bulk.report().done) {
      report.reason = "the tangent cannot be factored: " + bulk.report().reason;
      report.advice = "see that supports hold every body; or the body may not carry this load";
      report.worst = bulk.report().unknown;
      return report;
    }
    const std::vector<double> residual = newton_residual(bulk, target, constraints, state);
    const std::vector<double> before(state.trial(displacement).begin(), state.trial(displacement).end());
    const Correction correction = newton_correction(bulk, local, constraints, residual, state);
    if (!correction.local.converged) {
      stop(correction.local, local, report);
      return report;
    }
    report.backward_error = std::max(report.backward_error, correction.backward_error);
    if (!(correction.backward_error <= worst_backward_error)) {
      report.backward_error = correction.backward_error;
      refuse(report);
      return report;
    }
    if (local.empty() && number > 1)
      shorten(bulk, constraints, target, before, length(free_part(constraints, residual)), state);
    measure(bulk, local, constraints, target, state, most_force, report);
    report.converged = report.residual <= newton_tolerance;
    if (report.converged) return report;
    if (number == 1) first = report.residual;
    if (!std::isfinite(report.residual) || report.residual > diverged * first) break;
  }
  tell_unsettled(report);
  return report;
}

}  // namespace

StepReport advance(Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                   const StepTarget& target, fields::State& state) {
  const auto timing = core::ledger().time("solve");
  if (bulk.linear()) return solve_linear(bulk, local, constraints, target, state);
  return solve_newton(bulk, local, constraints, target, state);
}

}  // namespace ashlar::solve
