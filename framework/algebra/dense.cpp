#include "algebra/dense.hpp"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace ashlar::algebra {

namespace {

class EigenLu final : public DenseLu {
 public:
  explicit EigenLu(const Eigen::MatrixXd& matrix) {
    if (matrix.size() == 0) rcond_ = 1;
    if (matrix.size() == 0 || !matrix.allFinite()) return;
    factor_.compute(matrix);
    const Eigen::ArrayXd pivots = factor_.matrixLU().diagonal().array().abs();
    // An exact zero makes the estimate no number.
    if (pivots.minCoeff() > 0) rcond_ = std::min(factor_.rcond(), pivots.minCoeff() / pivots.maxCoeff());
  }
  double rcond() const override { return rcond_; }
  Eigen::MatrixXd solve(Eigen::MatrixXd right) const override { return factor_.solve(right); }

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factor_;
  double rcond_ = 0;
};

class EigenCholesky final : public DenseCholesky {
 public:
  explicit EigenCholesky(const Eigen::MatrixXd& matrix) : factor_(matrix) {
    const bool done = factor_.info() == Eigen::Success;
    rcond_ = matrix.size() == 0 ? 1 : done ? factor_.rcond() : 0;
  }
  double rcond() const override { return rcond_; }
  Eigen::VectorXd solve(Eigen::VectorXd right) const override { return factor_.solve(right); }
  // With H = L⁻¹ Bᵀ:  B A⁻¹ Bᵀ = Hᵀ H
  Eigen::MatrixXd inverse_between(Eigen::MatrixXd transposed) const override {
    const Eigen::MatrixXd half = factor_.matrixL().solve(transposed);
    Eigen::MatrixXd between = Eigen::MatrixXd::Zero(half.cols(), half.cols());
    between.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
    between.triangularView<Eigen::StrictlyUpper>() = between.transpose();
    return between;
  }

 private:
  Eigen::LLT<Eigen::MatrixXd> factor_;
  double rcond_ = 0;
};

class EigenDense final : public DenseAlgebra {
 public:
  std::unique_ptr<DenseLu> lu(Eigen::MatrixXd matrix) const override {
    return std::make_unique<EigenLu>(matrix);
  }
  std::unique_ptr<DenseCholesky> cholesky(Eigen::MatrixXd matrix) const override {
    return std::make_unique<EigenCholesky>(matrix);
  }
};

}  // namespace

const DenseAlgebra& eigen_dense() {
  static const EigenDense dense;
  return dense;
}

}  // namespace ashlar::algebra
