#pragma once
// Dense factorisations, as the sparse solver's library offers them: for some thousand rows LAPACK and BLAS
// are several times as fast as Eigen, which is the default.

#include <memory>

#include <Eigen/Core>

namespace ashlar::algebra {

/// A = P L U.
class DenseLu {
 public:
  virtual ~DenseLu() = default;
  /// The lesser of an estimate of 1/(‖A‖₁ ‖A⁻¹‖₁) and the smallest over the largest pivot: the estimate may
  /// miss a singular direction, a pivot of round-off does not. 0 if A is singular or not finite.
  virtual double rcond() const = 0;
  /// A⁻¹ B. Only if rcond() > 0.
  virtual Eigen::MatrixXd solve(Eigen::MatrixXd right) const = 0;
};

/// A = L Lᵀ.
class DenseCholesky {
 public:
  virtual ~DenseCholesky() = default;
  /// An estimate of 1/(‖A‖₁ ‖A⁻¹‖₁); 0 if A is not positive definite.
  virtual double rcond() const = 0;
  /// A⁻¹ b. Only if rcond() > 0.
  virtual Eigen::VectorXd solve(Eigen::VectorXd right) const = 0;
  /// B A⁻¹ Bᵀ, from Bᵀ.
  virtual Eigen::MatrixXd inverse_between(Eigen::MatrixXd transposed) const = 0;
};

class DenseAlgebra {
 public:
  virtual ~DenseAlgebra() = default;
  virtual std::unique_ptr<DenseLu> lu(Eigen::MatrixXd matrix) const = 0;
  /// Of a symmetric matrix; its lower triangle is read.
  virtual std::unique_ptr<DenseCholesky> cholesky(Eigen::MatrixXd matrix) const = 0;
};

/// By Eigen.
const DenseAlgebra& eigen_dense();

}  // namespace ashlar::algebra
