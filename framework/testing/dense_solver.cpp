#include "testing/dense_solver.hpp"

#include <algorithm>

namespace ashlar::testing {

using algebra::Index;

Eigen::MatrixXd to_dense(const algebra::SymmetricMatrix& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.pattern.size, matrix.pattern.size);
  for (Index column = 0; column < matrix.pattern.size; ++column)
    for (Index e = matrix.pattern.column_start[column]; e < matrix.pattern.column_start[column + 1]; ++e) {
      const Index row = matrix.pattern.row[e];
      dense(row, column) = dense(column, row) = matrix.value[e];
    }
  return dense;
}

void DenseSolver::analyse(const algebra::SymmetricPattern& pattern, std::span<const Index> kept,
                          std::span<const Index> /*node*/) {
  kept_.assign(kept.begin(), kept.end());
  inner_.clear();
  for (Index i = 0; i < pattern.size; ++i)
    if (!std::binary_search(kept_.begin(), kept_.end(), i)) inner_.push_back(i);
}

algebra::FactorReport DenseSolver::factor(const algebra::SymmetricMatrix& matrix) {
  const Eigen::MatrixXd dense = to_dense(matrix);
  inner_block_ = dense(inner_, inner_);
  coupling_ = dense(inner_, kept_);
  algebra::FactorReport report;
  if (!inner_.empty()) {
    factor_.compute(inner_block_);
    if (factor_.info() != Eigen::Success || factor_.rcond() < 1e-15) {
      report.reason = "the matrix is not positive definite";
      return report;
    }
  }
  schur_ = dense(kept_, kept_);
  if (!inner_.empty() && !kept_.empty()) schur_ -= coupling_.transpose() * factor_.solve(coupling_);
  report.done = true;
  report.ordering = "dense";
  return report;
}

void DenseSolver::solve(std::span<const double> b, std::span<double> x) const {
  Eigen::Map<Eigen::VectorXd>(x.data(), static_cast<Index>(x.size())) =
      factor_.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<Index>(b.size())));
}

Eigen::VectorXd DenseSolver::condense(std::span<const double> b, std::vector<double>& work) const {
  work.assign(b.begin(), b.end());
  const Eigen::Map<const Eigen::VectorXd> all(b.data(), static_cast<Index>(b.size()));
  Eigen::VectorXd load = all(kept_);
  if (!inner_.empty()) load -= coupling_.transpose() * factor_.solve(Eigen::VectorXd(all(inner_)));
  return load;
}

void DenseSolver::expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
                         std::span<double> x) const {
  const Eigen::Map<const Eigen::VectorXd> all(work.data(), static_cast<Index>(work.size()));
  Eigen::Map<Eigen::VectorXd> out(x.data(), static_cast<Index>(x.size()));
  out(kept_) = kept_values;
  if (inner_.empty()) return;
  const Eigen::VectorXd right = Eigen::VectorXd(all(inner_)) - coupling_ * kept_values;
  const Eigen::VectorXd inner = factor_.solve(right);
  out(inner_) = inner;
}

}  // namespace ashlar::testing
