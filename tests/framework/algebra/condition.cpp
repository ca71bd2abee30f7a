#include "algebra/condition.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace ashlar::algebra {
namespace {

double norm_1(const Eigen::MatrixXd& a) {
  return a.cwiseAbs().colwise().sum().maxCoeff();
}

double estimate(const Eigen::MatrixXd& a, int* solves = nullptr) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> factor(a);
  const Eigen::PartialPivLU<Eigen::MatrixXd> transposed(a.transpose());
  const auto with = [solves](const Eigen::PartialPivLU<Eigen::MatrixXd>& lu) {
    return [&lu, solves](std::span<const double> b, std::span<double> x) {
      if (solves) ++*solves;
      Eigen::Map<Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())) =
          lu.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<Eigen::Index>(b.size())));
    };
  };
  return inverse_norm(static_cast<Index>(a.rows()), with(factor), with(transposed));
}

Eigen::MatrixXd random_matrix(std::mt19937& random, Eigen::Index size) {
  std::uniform_real_distribution entry(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(size, size, [&] { return entry(random); });
}

TEST(condition, of_random_matrices_is_found_within_a_third) {
  std::mt19937 random(5);
  int exact = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd a = random_matrix(random, 3 + trial % 40);
    const double right = norm_1(a.inverse());
    int solves = 0;
    const double found = estimate(a, &solves);
    EXPECT_LE(found, right * (1 + 1e-8));
    EXPECT_GE(found, right / 3);
    EXPECT_LE(solves, 11);
    exact += std::abs(found - right) < 1e-8 * right;
  }
  EXPECT_GT(exact, 120);  // mostly exact, as Higham found
}

TEST(condition, of_hilberts_matrices_is_found) {
  for (const int n : {2, 5, 9}) {
    Eigen::MatrixXd a(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) a(i, j) = 1.0 / (i + j + 1);
    const double right = norm_1(a.inverse());
    EXPECT_NEAR(estimate(a), right, 1e-3 * right);
  }
}

TEST(condition, grows_with_the_ratio_of_stiffnesses) {
  for (const double ratio : {1e3, 1e9, 1e15}) {
    Eigen::Matrix2d a;
    a << 1 + ratio, -ratio, -ratio, ratio;  // two springs in a row, the second stiffer
    EXPECT_NEAR(estimate(a) / norm_1(a.inverse()), 1, 0.3);
  }
}

TEST(condition, of_the_identity_and_of_nothing) {
  EXPECT_DOUBLE_EQ(estimate(Eigen::MatrixXd::Identity(7, 7)), 1);
  EXPECT_EQ(inverse_norm(0, {}, {}), 0);
}

}  // namespace
}  // namespace ashlar::algebra
