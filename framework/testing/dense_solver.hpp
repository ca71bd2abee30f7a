#pragma once
// A LinearSolver by dense algebra: small, slow and plain, to test the march without a module and modules
// against it.

#include "algebra/linear_solver.hpp"

namespace ashlar::testing {

class DenseSolver : public algebra::LinearSolver {
 public:
  void analyse(const algebra::SymmetricPattern& pattern, std::span<const algebra::Index> kept,
               std::span<const algebra::Index> node) override;
  algebra::FactorReport factor(const algebra::SymmetricMatrix& matrix) override;
  void solve(std::span<const double> b, std::span<double> x) const override;
  const Eigen::MatrixXd& schur() const override { return schur_; }
  Eigen::VectorXd condense(std::span<const double> b, std::vector<double>& work) const override;
  void expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
              std::span<double> x) const override;
  std::size_t bytes() const override {
    return sizeof(double) * static_cast<std::size_t>(inner_block_.size());
  }

 private:
  std::vector<algebra::Index> inner_, kept_;
  Eigen::MatrixXd inner_block_, coupling_, schur_;  ///< A_ii, A_ik, S
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// The whole matrix, both triangles.
Eigen::MatrixXd to_dense(const algebra::SymmetricMatrix& matrix);

}  // namespace ashlar::testing
