#pragma once
// How much an inverse magnifies, estimated from solves alone.

#include <functional>
#include <span>

#include "mesh/adjacency.hpp"

namespace ashlar::algebra {

using mesh::Index;

/// x = A⁻¹ b, or A⁻ᵀ b.
using Solve = std::function<void(std::span<const double> b, std::span<double> x)>;

/// An estimate of ‖A⁻¹‖₁ from a few solves with A and with Aᵀ: a lower bound, rarely below a third of it.
/// Hager, SIAM J. Sci. Stat. Comput. 5 (1984); Higham, ACM Trans. Math. Softw. 14 (1988), algorithm 4.1.
/// Deterministic. Infinite if a solution is.
double inverse_norm(Index size, const Solve& solve, const Solve& solve_transposed);

}  // namespace ashlar::algebra
