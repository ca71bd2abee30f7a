#include "suitesparse/lapack.hpp"

#include <gtest/gtest.h>

#include <random>

#include <Eigen/Dense>

namespace ashlar::suitesparse {
namespace {

Eigen::MatrixXd random(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937 numbers(7);
  Eigen::MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = std::uniform_real_distribution(-1.0, 1.0)(numbers);
  return matrix;
}

Eigen::MatrixXd positive(Eigen::Index size) {
  const Eigen::MatrixXd half = random(size, size);
  return half * half.transpose() + Eigen::MatrixXd::Identity(size, size);
}

class Dense : public ::testing::TestWithParam<const algebra::DenseAlgebra*> {};
INSTANTIATE_TEST_SUITE_P(by, Dense, ::testing::Values(&lapack(), &algebra::eigen_dense()));

TEST_P(Dense, lu_solves_and_tells_the_condition) {
  const Eigen::MatrixXd a = random(150, 150), b = random(150, 3);
  const auto lu = GetParam()->lu(a);
  EXPECT_LT((a * lu->solve(b) - b).norm(), 1e-12 * b.norm());
  const double exact =
      1 / (a.cwiseAbs().colwise().sum().maxCoeff() * a.inverse().cwiseAbs().colwise().sum().maxCoeff());
  EXPECT_GE(lu->rcond(), 0.99 * exact);
  EXPECT_LE(lu->rcond(), 10 * exact);
}

TEST_P(Dense, lu_knows_singular_and_broken_matrices) {
  Eigen::MatrixXd a = random(40, 40);
  a.col(11) = a.col(3) + 2 * a.col(20);
  EXPECT_LT(GetParam()->lu(a)->rcond(), 1e-15);
  a.col(11).setZero();
  EXPECT_EQ(GetParam()->lu(a)->rcond(), 0);
  a(5, 5) = NAN;
  EXPECT_EQ(GetParam()->lu(a)->rcond(), 0);
  EXPECT_EQ(GetParam()->lu(Eigen::MatrixXd())->rcond(), 1);
}

TEST_P(Dense, cholesky_solves_and_reads_the_lower_triangle_alone) {
  const Eigen::MatrixXd a = positive(140), b = random(20, 140);
  Eigen::MatrixXd lower = a.triangularView<Eigen::Lower>();
  const auto factor = GetParam()->cholesky(lower);
  const Eigen::VectorXd right = random(140, 1);
  EXPECT_LT((a * factor->solve(right) - right).norm(), 1e-11 * right.norm());
  const Eigen::MatrixXd between = b * a.llt().solve(b.transpose());
  EXPECT_LT((factor->inverse_between(b.transpose()) - between).norm(), 1e-12 * between.norm());
  const double exact =
      1 / (a.cwiseAbs().colwise().sum().maxCoeff() * a.inverse().cwiseAbs().colwise().sum().maxCoeff());
  EXPECT_GE(factor->rcond(), 0.99 * exact);
  EXPECT_LE(factor->rcond(), 10 * exact);
}

TEST_P(Dense, cholesky_refuses_what_is_not_positive_definite) {
  Eigen::MatrixXd a = positive(30);
  a(7, 7) = -1;
  EXPECT_EQ(GetParam()->cholesky(a)->rcond(), 0);
  EXPECT_EQ(GetParam()->cholesky(Eigen::MatrixXd())->rcond(), 1);
}

TEST(lapack, multiplies_a_triangle_by_its_transposed) {
  for (const Eigen::Index size : {0, 1, 128, 300}) {
    const Eigen::MatrixXd lower = random(size, size).triangularView<Eigen::Lower>();
    const Eigen::MatrixXd product = lower * lower.transpose();
    EXPECT_LE((times_transposed(lower) - product).norm(), 1e-13 * product.norm()) << size;
  }
}

}  // namespace
}  // namespace ashlar::suitesparse
