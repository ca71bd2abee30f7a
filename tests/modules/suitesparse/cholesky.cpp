#include "suitesparse/cholesky.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "algebra/assemble.hpp"
#include "framework/algebra/grids.hpp"

namespace ashlar::suitesparse {
namespace {

using algebra::Adjacency;
using algebra::SymmetricMatrix;

// Springs along the sides and diagonals of each quad in both directions: singular to translations only.
void spring_quad(Index group, std::span<double> packed) {
  const double stiffness = 1 + 0.1 * (group % 5);
  std::fill(packed.begin(), packed.end(), 0.0);
  const auto at = [&](std::size_t r, std::size_t c) -> double& { return packed[r * (r + 1) / 2 + c]; };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < 2; ++c) {
        at(2 * i + c, 2 * i + c) += stiffness;
        at(2 * j + c, 2 * j + c) += stiffness;
        at(2 * i + c, 2 * j + c) -= stiffness;
      }
}

struct Case {
  Case(Index nx, Index ny, Index held) {
    const Adjacency groups = algebra::testing::quad_groups(nx, ny, held);
    const Adjacency* lists[] = {&groups};
    matrix.pattern = algebra::make_pattern(algebra::testing::quad_unknowns(nx, ny, held), lists);
    matrix.value.resize(matrix.pattern.entries());
    algebra::assemble(algebra::ScatterMap(matrix.pattern, groups), matrix.value, spring_quad);
    for (Index i = 0; i < matrix.pattern.size; ++i) node.push_back((i + held) / 2);
    full = algebra::testing::dense(matrix);
    std::mt19937 random(3);
    right = Eigen::VectorXd(matrix.pattern.size);
    for (double& b : right) b = std::uniform_real_distribution(-1.0, 1.0)(random);
  }
  std::span<const double> load() const { return {right.data(), static_cast<std::size_t>(right.size())}; }

  SymmetricMatrix matrix;
  std::vector<Index> node;
  Eigen::MatrixXd full;
  Eigen::VectorXd right;
};

std::span<double> span(Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

class EachOrdering : public ::testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(cholesky, EachOrdering,
                         ::testing::Values(Method::automatic, Method::metis, Method::amd));

TEST_P(EachOrdering, solves_as_a_dense_solver_does) {
  const Case c(9, 7, 5);
  Cholesky solver(GetParam());
  solver.analyse(c.matrix.pattern, {}, c.node);
  const auto report = solver.factor(c.matrix);
  ASSERT_TRUE(report.done) << report.reason;
  EXPECT_GT(report.entries, 0);
  EXPECT_GT(solver.bytes(), 0u);
  Eigen::VectorXd x(c.right.size());
  solver.solve(c.load(), span(x));
  const Eigen::VectorXd expected = c.full.ldlt().solve(c.right);
  EXPECT_LT((x - expected).norm(), 1e-13 * expected.norm());
}

/// Checks condense, Schur complement and expand against dense elimination; `full` may be singular.
void check_kept(const Case& c, const std::vector<Index>& kept, Method method) {
  Cholesky solver(method);
  solver.analyse(c.matrix.pattern, kept, c.node);
  const auto report = solver.factor(c.matrix);
  ASSERT_TRUE(report.done) << report.reason;

  std::vector<Index> inner;
  for (Index i = 0; i < c.matrix.pattern.size; ++i)
    if (!std::binary_search(kept.begin(), kept.end(), i)) inner.push_back(i);
  const Eigen::MatrixXd ii = c.full(inner, inner), ki = c.full(kept, inner), kk = c.full(kept, kept);
  const auto inverse = ii.ldlt();
  const Eigen::MatrixXd schur = kk - ki * inverse.solve(ki.transpose());
  ASSERT_EQ(solver.schur().rows(), schur.rows());
  EXPECT_LT((solver.schur() - schur).norm(), 1e-13 * kk.norm());

  std::vector<double> work;
  const Eigen::VectorXd load = solver.condense(c.load(), work);
  const Eigen::VectorXd expected_load = c.right(kept) - ki * inverse.solve(c.right(inner));
  EXPECT_LT((load - expected_load).norm(), 1e-13 * (1 + expected_load.norm()));

  const Eigen::VectorXd kept_values = Eigen::VectorXd::LinSpaced(static_cast<Index>(kept.size()), -1, 1);
  Eigen::VectorXd x(c.right.size());
  solver.expand(work, kept_values, span(x));
  const Eigen::VectorXd expected = inverse.solve(c.right(inner) - ki.transpose() * kept_values);
  EXPECT_EQ(Eigen::VectorXd(x(kept)), kept_values);
  EXPECT_LT((x(inner) - expected).norm(), 1e-13 * expected.norm());
}

TEST_P(EachOrdering, condenses_to_the_kept_unknowns) {
  check_kept(Case(9, 7, 5), {3, 4, 40, 41, 42, 90, 91, 120}, GetParam());
}

// Columns of the factor that a load on few unknowns does not reach are passed over.
TEST_P(EachOrdering, condenses_a_load_on_few_unknowns) {
  Case c(19, 17, 5);
  const Eigen::VectorXd all = c.right;
  c.right.setZero();
  for (const Index i : {11, 12, 300}) c.right[i] = all[i];
  check_kept(c, {3, 4, 40, 41, 42, 90, 91, 120}, GetParam());
  c.right.setZero();
  check_kept(c, {3, 4, 40, 41}, GetParam());
}

// A line of kept unknowns across the grid: they cut the graph in two pieces.
TEST_P(EachOrdering, keeps_a_cut_last) {
  std::vector<Index> kept(20);
  std::iota(kept.begin(), kept.end(), 3 * 20 - 5);
  check_kept(Case(9, 7, 5), kept, GetParam());
}

// A strip cut in four: the pieces beyond the second cut do not touch the first kept unknown, so that a
// postorder is free to place them after it unless the structure forbids it.
TEST_P(EachOrdering, keeps_several_cuts_last) {
  std::vector<Index> kept;
  for (const Index x : {10, 20, 30})
    for (const Index node : {x, 41 + x})
      for (const Index c : {0, 1}) kept.push_back(2 * node + c - 4);
  std::sort(kept.begin(), kept.end());
  check_kept(Case(40, 1, 4), kept, GetParam());
}

TEST_P(EachOrdering, condenses_a_floating_body_without_a_spring) {
  const Case c(6, 5, 0);
  const std::vector<Index> kept = {0, 1, 30, 31, 82, 83};
  check_kept(c, kept, GetParam());
  // The Schur complement of a free body does not resist a translation.
  Cholesky solver(GetParam());
  solver.analyse(c.matrix.pattern, kept, c.node);
  ASSERT_TRUE(solver.factor(c.matrix).done);
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(6);
  for (Eigen::Index k = 0; k < 6; k += 2) shift[k] = 1;
  EXPECT_LT((solver.schur() * shift).norm(), 1e-14 * c.full.norm());
}

TEST(cholesky, every_unknown_may_be_kept) {
  const Case c(2, 1, 3);
  std::vector<Index> all(static_cast<std::size_t>(c.matrix.pattern.size));
  std::iota(all.begin(), all.end(), 0);
  Cholesky solver(Method::automatic);
  solver.analyse(c.matrix.pattern, all, c.node);
  ASSERT_TRUE(solver.factor(c.matrix).done);
  EXPECT_LT((solver.schur() - c.full).norm(), 1e-14 * c.full.norm());
}

TEST(cholesky, says_which_unknown_moves_freely) {
  const Case c(6, 5, 0);
  Cholesky solver(Method::automatic);
  solver.analyse(c.matrix.pattern, {}, c.node);
  const auto report = solver.factor(c.matrix);
  EXPECT_FALSE(report.done);
  EXPECT_GE(report.unknown, 0);
  EXPECT_NE(report.reason.find("free to move"), std::string::npos) << report.reason;
}

TEST(cholesky, reports_an_indefinite_matrix) {
  Case c(4, 4, 4);
  c.matrix.value[c.matrix.pattern.column_start[17]] = -1;
  Cholesky solver(Method::automatic);
  solver.analyse(c.matrix.pattern, {}, c.node);
  const auto report = solver.factor(c.matrix);
  EXPECT_FALSE(report.done);
  EXPECT_GE(report.unknown, 0);
}

TEST(cholesky, factors_anew_without_a_new_analysis_and_after_a_failure) {
  Case c(9, 7, 5);
  Cholesky solver(Method::automatic);
  solver.analyse(c.matrix.pattern, {}, c.node);
  SymmetricMatrix bad = c.matrix;
  bad.value[bad.pattern.column_start[17]] = -1;
  EXPECT_FALSE(solver.factor(bad).done);
  for (double& v : c.matrix.value) v *= 2;
  solver.analyse(c.matrix.pattern, {}, c.node);
  ASSERT_TRUE(solver.factor(c.matrix).done);
  Eigen::VectorXd x(c.right.size());
  solver.solve(c.load(), span(x));
  const Eigen::VectorXd expected = 0.5 * c.full.ldlt().solve(c.right);
  EXPECT_LT((x - expected).norm(), 1e-13 * expected.norm());
  // Another choice of kept unknowns is another analysis.
  const std::vector<Index> kept = {7, 8};
  solver.analyse(c.matrix.pattern, kept, c.node);
  ASSERT_TRUE(solver.factor(c.matrix).done);
  EXPECT_EQ(solver.schur().rows(), 2);
}

TEST(cholesky, gives_the_same_bits_every_time_and_leaves_thread_settings_alone) {
  const Case c(60, 50, 8);
  Eigen::VectorXd first(c.right.size()), second(c.right.size());
  for (Eigen::VectorXd* x : {&first, &second}) {
    Cholesky solver(Method::metis);
    solver.analyse(c.matrix.pattern, {}, c.node);
    ASSERT_TRUE(solver.factor(c.matrix).done);
    solver.solve(c.load(), span(*x));
  }
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace ashlar::suitesparse
