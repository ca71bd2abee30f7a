#include "suitesparse/umfpack.hpp"

#include <gtest/gtest.h>

#include <random>

#include "algebra/assemble.hpp"
#include "framework/algebra/grids.hpp"

namespace ashlar::suitesparse {
namespace {

using algebra::Adjacency;

/// A matrix of random entries, strong on the diagonal, on the pattern of a grid of quads.
struct Unsymmetric {
  Unsymmetric() {
    const Adjacency groups = algebra::testing::quad_groups(7, 5, 4);
    const Adjacency* lists[] = {&groups};
    matrix.pattern = algebra::make_pattern(algebra::testing::quad_unknowns(7, 5, 4), lists);
    std::mt19937 random(11);
    std::uniform_real_distribution entry(-1.0, 1.0);
    full = Eigen::MatrixXd::Zero(matrix.pattern.size, matrix.pattern.size);
    for (Index j = 0; j < matrix.pattern.size; ++j)
      for (Index p = matrix.pattern.column_start[j]; p < matrix.pattern.column_start[j + 1]; ++p) {
        const Index i = matrix.pattern.row[p];
        matrix.value.push_back(i == j ? 15 + entry(random) : entry(random));
        matrix.upper.push_back(i == j ? matrix.value.back() : entry(random));
        full(i, j) = matrix.value.back();
        full(j, i) = matrix.upper.back();
      }
    right = Eigen::VectorXd(matrix.pattern.size);
    for (double& b : right) b = entry(random);
  }
  std::span<const double> load() const { return {right.data(), static_cast<std::size_t>(right.size())}; }

  algebra::SymmetricMatrix matrix;
  Eigen::MatrixXd full;
  Eigen::VectorXd right;
};

TEST(umfpack, solves_as_a_dense_solver_does) {
  const Unsymmetric given;
  Umfpack solver;
  solver.analyse(given.matrix.pattern, {}, {});
  ASSERT_TRUE(solver.factor(given.matrix).done);
  Eigen::VectorXd x(given.right.size());
  solver.solve(given.load(), {x.data(), static_cast<std::size_t>(x.size())});
  EXPECT_LT((given.full * x - given.right).norm(), 1e-13 * given.right.norm());
}

TEST(umfpack, solves_with_the_transposed_matrix) {
  const Unsymmetric given;
  Umfpack solver;
  solver.analyse(given.matrix.pattern, {}, {});
  ASSERT_TRUE(solver.factor(given.matrix).done);
  Eigen::VectorXd x(given.right.size());
  solver.solve_transposed(given.load(), {x.data(), static_cast<std::size_t>(x.size())});
  EXPECT_LT((given.full.transpose() * x - given.right).norm(), 1e-13 * given.right.norm());
}

TEST(umfpack, kept_unknowns_get_their_schur_complement) {
  const Unsymmetric given;
  const std::vector<Index> kept = {3, 4, 17, 40};
  Umfpack solver;
  solver.analyse(given.matrix.pattern, kept, {});
  ASSERT_TRUE(solver.factor(given.matrix).done);
  std::vector<Index> inner;
  for (Index i = 0; i < given.matrix.pattern.size; ++i)
    if (std::find(kept.begin(), kept.end(), i) == kept.end()) inner.push_back(i);
  const Eigen::MatrixXd& a = given.full;
  const Eigen::MatrixXd schur =
      a(kept, kept) -
      a(kept, inner) * Eigen::MatrixXd(a(inner, inner)).lu().solve(Eigen::MatrixXd(a(inner, kept)));
  EXPECT_LT((solver.schur() - schur).norm(), 1e-12 * schur.norm());
  std::vector<double> work;
  const Eigen::VectorXd load = solver.condense(given.load(), work);
  const Eigen::VectorXd held = solver.schur().lu().solve(load);
  Eigen::VectorXd x(given.right.size());
  solver.expand(work, held, {x.data(), static_cast<std::size_t>(x.size())});
  EXPECT_LT((a * x - given.right).norm(), 1e-12 * given.right.norm());
}

TEST(umfpack, a_singular_matrix_is_told) {
  Unsymmetric given;
  for (Index p = given.matrix.pattern.column_start[5]; p < given.matrix.pattern.column_start[6]; ++p)
    given.matrix.value[p] = 0;
  for (Index j = 0; j < 5; ++j)
    for (Index p = given.matrix.pattern.column_start[j]; p < given.matrix.pattern.column_start[j + 1]; ++p)
      if (given.matrix.pattern.row[p] == 5) given.matrix.upper[p] = 0;
  Umfpack solver;
  solver.analyse(given.matrix.pattern, {}, {});
  const auto report = solver.factor(given.matrix);
  EXPECT_FALSE(report.done);
  EXPECT_NE(report.reason.find("singular"), std::string::npos) << report.reason;
}

}  // namespace
}  // namespace ashlar::suitesparse
