#pragma once
// One load step: from the committed state to equilibrium under given loads and prescribed displacements.

#include "solve/bulk.hpp"
#include "solve/local.hpp"
#include "solve/mechanism.hpp"

namespace ashlar::solve {

/// What acts at the end of a step.
struct StepTarget {
  std::span<const double> load;        ///< external force by dof [N]
  std::span<const double> prescribed;  ///< displacement of held dofs [m]; others ignored
  /// The load that the committed state is in balance with, by the same bulk, joints and free dofs: forces
  /// then change by loads alone, and few dofs have any. Empty if that is not known.
  std::span<const double> balanced = {};
};

struct StepReport {
  bool converged = false;
  std::string reason, advice;
  bool singular = false;     ///< a body is free to move
  bool held_before = false;  ///< but was held at first: smaller steps may help
  Mechanism mechanism;       ///< how it moves
  Index worst = -1;          ///< if not converged: the unknown whose forces balance least, or that broke down
  double residual = 0;  ///< ‖forces out of balance in free dofs‖∞ over the largest nodal force, at the
                        ///< step's start or end
  double backward_error = 0;  ///< of the linear solve: ‖r‖∞ / (‖K‖∞ ‖u‖∞ + ‖f‖∞)
  double forward_error = 0;   ///< what round-off does to the displacements, relative to the largest; linear
                              ///< stages without local terms only
  std::vector<model::Iteration> iterations;
  std::vector<double> out_of_balance;  ///< at the step's end, if the bulk is linear; else empty
};

/// Brings the trial state to equilibrium. Linear stages take one solve (and one of refinement if its backward
/// error asks for it); nonlinear terms are iterated with Newton's method.
StepReport advance(Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                   const StepTarget& target, fields::State& state);

/// force = K u + n(u) + c − load, c: the trial tractions of joints, over all dofs at the trial state: zero in
/// free dofs, reactions in held ones.
std::vector<double> out_of_balance(const Bulk& bulk, const LocalTerms& local, std::span<const double> load,
                                   fields::State& state);

}  // namespace ashlar::solve
