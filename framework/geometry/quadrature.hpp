#pragma once
// Gauss–Legendre quadrature on the unit interval.

#include <vector>

namespace ashlar::geometry {

/// ∫₀¹ f dt ≈ Σ weight[i] f(at[i]); `at` ascends, the weights sum to 1.
struct Rule {
  std::vector<double> at, weight;
};

/// The rule that is exact for polynomials up to `degree` (0 … 39), with the fewest points.
const Rule& gauss_legendre(int degree);

}  // namespace ashlar::geometry
