#pragma once
// How sensitive a stage's linear system is.

#include "solve/local.hpp"

namespace ashlar::solve {

/// An estimate of ‖K‖∞ ‖K⁻¹‖∞ over the free unknowns: K is the tangent that was factored last, with joints
/// that touch everywhere and have their ground stiffness. Costs about five solves. Infinite if these do not
/// hold the body; 0 if it cannot be told (joints beside a tangent that is not symmetric).
double condition_estimate(const Bulk& bulk, const LocalTerms& local, Index unknowns);

}  // namespace ashlar::solve
