#include "suitesparse/lapack.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <cblas.h>

#include "suitesparse/common.hpp"

// LAPACK, as OpenBLAS has it: Fortran's calling convention, the length of a character last.
// NOLINTBEGIN(readability-identifier-naming): the library's names
extern "C" {
void dgetrf_(const int* rows, const int* columns, double* a, const int* stride, int* pivot, int* info);
void dgetrs_(const char* form, const int* size, const int* rights, const double* a, const int* stride,
             const int* pivot, double* b, const int* b_stride, int* info, std::size_t);
void dgecon_(const char* norm, const int* size, const double* a, const int* stride, const double* a_norm,
             double* rcond, double* work, int* iwork, int* info, std::size_t);
void dpotrf_(const char* part, const int* size, double* a, const int* stride, int* info, std::size_t);
void dpotrs_(const char* part, const int* size, const int* rights, const double* a, const int* stride,
             double* b, const int* b_stride, int* info, std::size_t);
void dpocon_(const char* part, const int* size, const double* a, const int* stride, const double* a_norm,
             double* rcond, double* work, int* iwork, int* info, std::size_t);
}
// NOLINTEND(readability-identifier-naming)

namespace ashlar::suitesparse {

namespace {

int integer(Eigen::Index size) {
  return static_cast<int>(size);
}

/// LAPACK wants strides of at least 1.
int stride(Eigen::Index rows) {
  return std::max(1, integer(rows));
}

/// ‖A‖₁ of the symmetric matrix whose lower triangle this is.
double symmetric_norm(const Eigen::MatrixXd& lower) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.rows());
  for (Eigen::Index j = 0; j < lower.cols(); ++j)
    for (Eigen::Index i = j; i < lower.rows(); ++i) {
      sums[i] += std::abs(lower(i, j));
      if (i != j) sums[j] += std::abs(lower(i, j));
    }
  return sums.size() ? sums.maxCoeff() : 0;
}

class Lu final : public algebra::DenseLu {
 public:
  explicit Lu(Eigen::MatrixXd matrix);
  double rcond() const override { return rcond_; }
  Eigen::MatrixXd solve(Eigen::MatrixXd right) const override;

 private:
  Eigen::MatrixXd factor_;
  std::vector<int> pivot_;
  double rcond_ = 0;
};

class DenseCholesky final : public algebra::DenseCholesky {
 public:
  explicit DenseCholesky(Eigen::MatrixXd matrix);
  double rcond() const override { return rcond_; }
  Eigen::VectorXd solve(Eigen::VectorXd right) const override;
  Eigen::MatrixXd inverse_between(Eigen::MatrixXd transposed) const override;

 private:
  Eigen::MatrixXd factor_;
  double rcond_ = 0;
};

Lu::Lu(Eigen::MatrixXd matrix) : factor_(std::move(matrix)) {
  const OneThread one_thread;
  const int size = integer(factor_.rows()), along = stride(factor_.rows());
  rcond_ = 1;
  if (size == 0) return;
  const double norm = factor_.cwiseAbs().colwise().sum().maxCoeff();
  pivot_.resize(factor_.rows());
  int info = 0;
  rcond_ = 0;
  if (!factor_.allFinite()) return;
  dgetrf_(&size, &size, factor_.data(), &along, pivot_.data(), &info);
  if (info != 0 || !factor_.allFinite()) return;
  std::vector<double> work(4 * pivot_.size());
  std::vector<int> integers(pivot_.size());
  dgecon_("1", &size, factor_.data(), &along, &norm, &rcond_, work.data(), integers.data(), &info, 1);
  const Eigen::ArrayXd pivots = factor_.diagonal().array().abs();
  rcond_ = std::min(rcond_, pivots.minCoeff() / pivots.maxCoeff());
}

Eigen::MatrixXd Lu::solve(Eigen::MatrixXd right) const {
  const OneThread one_thread;
  const int size = integer(factor_.rows()), along = stride(size), rights = integer(right.cols());
  int info = 0;
  dgetrs_("N", &size, &rights, factor_.data(), &along, pivot_.data(), right.data(), &along, &info, 1);
  return right;
}

DenseCholesky::DenseCholesky(Eigen::MatrixXd matrix) : factor_(std::move(matrix)) {
  const OneThread one_thread;
  const int size = integer(factor_.rows()), along = stride(factor_.rows());
  rcond_ = 1;
  if (size == 0) return;
  const double norm = symmetric_norm(factor_);
  int info = 0;
  rcond_ = 0;
  dpotrf_("L", &size, factor_.data(), &along, &info, 1);
  if (info != 0) return;
  std::vector<double> work(3 * static_cast<std::size_t>(size));
  std::vector<int> integers(static_cast<std::size_t>(size));
  dpocon_("L", &size, factor_.data(), &along, &norm, &rcond_, work.data(), integers.data(), &info, 1);
}

Eigen::VectorXd DenseCholesky::solve(Eigen::VectorXd right) const {
  const OneThread one_thread;
  const int size = integer(factor_.rows()), along = stride(size), rights = 1;
  int info = 0;
  dpotrs_("L", &size, &rights, factor_.data(), &along, right.data(), &along, &info, 1);
  return right;
}

// With H = L⁻¹ Bᵀ:  B A⁻¹ Bᵀ = Hᵀ H
Eigen::MatrixXd DenseCholesky::inverse_between(Eigen::MatrixXd transposed) const {
  const OneThread one_thread;
  const int size = integer(factor_.rows()), rights = integer(transposed.cols()), along = stride(size);
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(rights, rights);
  cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, size, rights, 1,
              factor_.data(), along, transposed.data(), along);
  cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, rights, size, 1, transposed.data(), along, 0,
              between.data(), stride(rights));
  between.triangularView<Eigen::StrictlyUpper>() = between.transpose();
  return between;
}

class Lapack final : public algebra::DenseAlgebra {
 public:
  std::unique_ptr<algebra::DenseLu> lu(Eigen::MatrixXd matrix) const override {
    return std::make_unique<Lu>(std::move(matrix));
  }
  std::unique_ptr<algebra::DenseCholesky> cholesky(Eigen::MatrixXd matrix) const override {
    return std::make_unique<DenseCholesky>(std::move(matrix));
  }
};

}  // namespace

const algebra::DenseAlgebra& lapack() {
  static const Lapack dense;
  return dense;
}

// Block columns j of the lower half: S(j.., j) = L(j.., 0..j) L(j, 0..j)ᵀ
Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& lower) {
  const OneThread one_thread;
  constexpr int width = 128;
  const int size = integer(lower.rows()), along = stride(size);
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(size, size);
  for (int j = 0; j < size; j += width) {
    const int columns = std::min(width, size - j), inner = j + columns;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, size - j, columns, inner, 1, lower.data() + j, along,
                lower.data() + j, along, 0, product.data() + j + static_cast<std::ptrdiff_t>(j) * size,
                along);
  }
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

}  // namespace ashlar::suitesparse
