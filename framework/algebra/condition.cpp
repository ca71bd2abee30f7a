#include "algebra/condition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ashlar::algebra {

namespace {

// Higham's limit; two or three are the rule.
constexpr int most_iterations = 5;

double norm_1(std::span<const double> x) {
  double sum = 0;
  for (const double each : x) sum += std::abs(each);
  return sum;
}

}  // namespace

double inverse_norm(Index size, const Solve& solve, const Solve& solve_transposed) {
  if (size == 0) return 0;
  const auto n = static_cast<std::size_t>(size);
  std::vector<double> x(n, 1.0 / size), y(n), sign(n), z(n);
  double found = 0;
  std::size_t last = n;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    solve(x, y);
    const double norm = norm_1(y);
    if (!std::isfinite(norm)) return std::numeric_limits<double>::infinity();
    if (iteration > 0 && norm <= found) break;
    found = norm;
    std::vector<double> now(n);
    std::ranges::transform(y, now.begin(), [](double v) { return v < 0 ? -1.0 : 1.0; });
    if (iteration > 0 && now == sign) break;
    sign = now;
    solve_transposed(sign, z);
    // The column of the inverse that grows most.
    const auto steepest = std::ranges::max_element(z, {}, [](double v) { return std::abs(v); });
    const auto column = static_cast<std::size_t>(steepest - z.begin());
    if (column == last) break;
    last = column;
    std::ranges::fill(x, 0.0);
    x[column] = 1;
  }
  // A vector of growing entries with changing signs: catches what cancels in the steps above.
  for (std::size_t i = 0; i < n; ++i)
    x[i] = (i % 2 == 0 ? 1 : -1) *
           (1 + static_cast<double>(i) / std::max<double>(1, static_cast<double>(n) - 1));
  solve(x, y);
  const double other = 2 * norm_1(y) / (3 * static_cast<double>(n));
  if (!std::isfinite(other)) return std::numeric_limits<double>::infinity();
  return std::max(found, other);
}

}  // namespace ashlar::algebra
