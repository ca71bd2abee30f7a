#pragma once
// CHOLMOD's supernodal Cholesky factorisation behind the framework's LinearSolver. See README.md for how kept
// unknowns are set apart. Chen, Davis, Hager, Rajamanickam: Algorithm 887, ACM Trans. Math. Softw. 35 (2008).

#include <cstdint>

#include "algebra/linear_solver.hpp"
#include "suitesparse/lapack.hpp"
#include "suitesparse/ordering.hpp"

namespace ashlar::suitesparse {

class Cholesky final : public algebra::LinearSolver {
 public:
  explicit Cholesky(Method method) : method_(method), factor_(nullptr, FreeFactor{&common_}) {}
  ~Cholesky() override;

  void analyse(const SymmetricPattern& pattern, std::span<const Index> kept,
               std::span<const Index> node) override;
  algebra::FactorReport factor(const algebra::SymmetricMatrix& matrix) override;
  void solve(std::span<const double> b, std::span<double> x) const override;
  const Eigen::MatrixXd& schur() const override { return schur_; }
  Eigen::VectorXd condense(std::span<const double> b, std::vector<double>& work) const override;
  void expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
              std::span<double> x) const override;
  const algebra::DenseAlgebra& dense() const override { return lapack(); }
  std::size_t bytes() const override;

 private:
  void add_structure(const SymmetricPattern& pattern, const Ordering& ordering);
  void analyse_order(Ordering& ordering);
  cholmod_sparse view() const;
  bool breakdown(algebra::FactorReport& report) const;
  void extract_kept_factor();
  Index size() const { return static_cast<Index>(column_start_.size()) - 1; }
  Index interior() const { return size() - static_cast<Index>(kept_.size()); }

  Method method_;
  mutable Common common_;
  Factor factor_;
  std::string ordering_;  ///< in words
  std::string trouble_;   ///< why the analysis failed
  std::uint64_t fingerprint_ = 0;
  std::vector<Index> kept_;
  // The matrix with the entries of structure that hold the kept unknowns at the end.
  std::vector<Index> column_start_, row_;
  std::vector<double> value_;
  std::vector<double> shift_;  ///< added to the kept diagonal before factoring
  Eigen::MatrixXd kept_factor_, schur_;
  mutable cholmod_dense *solution_ = nullptr, *y_ = nullptr, *e_ = nullptr;  ///< kept between solves
};

}  // namespace ashlar::suitesparse
