#include "algebra/assemble.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/algebra/grids.hpp"

namespace ashlar::algebra {
namespace {

using testing::quad_groups;
using testing::quad_unknowns;

// Numbers whose sum depends on the order of summation.
void fill(Index group, std::span<double> values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = std::sin(1.0 + group + 0.37 * static_cast<double>(k)) * std::pow(10.0, group % 7);
}

struct Threads {
  explicit Threads(int count) { core::set_thread_count(count); }
  ~Threads() { core::set_thread_count(1); }
};

TEST(assemble, sums_what_a_plain_loop_sums) {
  const Adjacency groups = quad_groups(6, 5, 3);
  const Index size = quad_unknowns(6, 5, 3);
  const Adjacency* lists[] = {&groups};
  SymmetricMatrix matrix{make_pattern(size, lists), {}};
  matrix.value.resize(matrix.pattern.entries());
  const ScatterMap map(matrix.pattern, groups);
  assemble(map, matrix.value, fill);

  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(size, size);
  std::vector<double> packed(36);
  for (Index g = 0; g < groups.size(); ++g) {
    fill(g, packed);
    std::size_t k = 0;
    for (int r = 0; r < 8; ++r)
      for (int c = 0; c <= r; ++c, ++k) {
        const Index i = groups[g][r], j = groups[g][c];
        if (i < 0 || j < 0) continue;
        expected(i, j) += packed[k];
        if (r != c) expected(j, i) += packed[k];
      }
  }
  EXPECT_EQ(testing::dense(matrix), expected);
}

TEST(assemble, gives_the_same_bits_on_any_number_of_threads) {
  const Adjacency groups = quad_groups(130, 90);
  const Index size = quad_unknowns(130, 90);
  const Adjacency* lists[] = {&groups};
  const SymmetricPattern pattern = make_pattern(size, lists);
  std::vector<double> matrix_on_one, vector_on_one;
  for (const int threads : {1, 2, 3, 7}) {
    const Threads use(threads);
    const ScatterMap map(pattern, groups);
    std::vector<double> matrix(pattern.entries()), vector(static_cast<std::size_t>(size));
    assemble(map, matrix, fill);
    assemble(groups, vector, fill);
    if (threads == 1) {
      matrix_on_one = matrix;
      vector_on_one = vector;
    }
    EXPECT_EQ(matrix, matrix_on_one) << threads << " threads";
    EXPECT_EQ(vector, vector_on_one) << threads << " threads";
  }
}

TEST(matrix, multiplies_and_measures_like_its_full_form) {
  const Adjacency groups = quad_groups(4, 3, 5);
  const Index size = quad_unknowns(4, 3, 5);
  const Adjacency* lists[] = {&groups};
  SymmetricMatrix matrix{make_pattern(size, lists), {}};
  matrix.value.resize(matrix.pattern.entries());
  assemble(ScatterMap(matrix.pattern, groups), matrix.value, fill);
  const Eigen::MatrixXd full = testing::dense(matrix);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -1, 2);
  Eigen::VectorXd y(size);
  multiply(matrix, {x.data(), static_cast<std::size_t>(size)}, {y.data(), static_cast<std::size_t>(size)});
  const double norm = full.cwiseAbs().rowwise().sum().maxCoeff();
  EXPECT_NEAR(infinity_norm(matrix), norm, 1e-14 * norm);
  EXPECT_LT((y - full * x).cwiseAbs().maxCoeff(), 1e-14 * norm);
}

TEST(matrix, multiplies_like_its_full_form_where_it_is_not_symmetric) {
  const Adjacency groups = quad_groups(3, 2);
  const Index size = quad_unknowns(3, 2);
  const Adjacency* lists[] = {&groups};
  SymmetricMatrix matrix{make_pattern(size, lists), {}};
  matrix.value.resize(matrix.pattern.entries());
  assemble(ScatterMap(matrix.pattern, groups), matrix.value, fill);
  matrix.upper = matrix.value;
  Eigen::MatrixXd full = testing::dense(matrix);
  for (Index j = 0; j < size; ++j)
    for (Index p = matrix.pattern.column_start[j] + 1; p < matrix.pattern.column_start[j + 1]; ++p)
      full(j, matrix.pattern.row[p]) = matrix.upper[p] = 3 + 0.5 * p;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -1, 2);
  Eigen::VectorXd y(size);
  multiply(matrix, {x.data(), static_cast<std::size_t>(size)}, {y.data(), static_cast<std::size_t>(size)});
  const double norm = full.cwiseAbs().rowwise().sum().maxCoeff();
  EXPECT_NEAR(infinity_norm(matrix), norm, 1e-14 * norm);
  EXPECT_LT((y - full * x).cwiseAbs().maxCoeff(), 1e-14 * norm);
}

}  // namespace
}  // namespace ashlar::algebra
