#include "geometry/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ashlar::geometry {
namespace {

// ∫₀¹ t^d dt = 1/(d+1) to round-off for every degree up to the rule's, and not beyond it.
TEST(quadrature, gauss_legendre_is_exact_up_to_its_degree) {
  for (int degree = 0; degree < 40; ++degree) {
    const Rule& rule = gauss_legendre(degree);
    EXPECT_EQ(rule.at.size(), static_cast<std::size_t>(degree / 2 + 1));
    for (int d = 0; d <= degree; ++d) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.at.size(); ++i) sum += rule.weight[i] * std::pow(rule.at[i], d);
      EXPECT_NEAR(sum, 1.0 / (d + 1), 1e-15) << "degree " << d << " by the rule for " << degree;
    }
  }
  const Rule& two = gauss_legendre(3);
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) sum += two.weight[i] * std::pow(two.at[i], 4);
  EXPECT_NEAR(sum, 0.2 - 1.0 / 180, 1e-15);
}

}  // namespace
}  // namespace ashlar::geometry
