#pragma once
// UMFPACK's unsymmetric multifrontal LU factorisation behind the framework's LinearSolver: for tangents of
// non-associated plastic flow. Davis: Algorithm 832, ACM Trans. Math. Softw. 30 (2004).
//
// Kept unknowns k are set apart by hand: only A_ii is factored, and S = A_kk − A_ki A_ii⁻¹ A_ik takes one
// solve for each of them.

#include "algebra/linear_solver.hpp"
#include "suitesparse/lapack.hpp"

namespace ashlar::suitesparse {

using algebra::Index;

class Umfpack final : public algebra::LinearSolver {
 public:
  Umfpack() = default;
  ~Umfpack() override;
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;

  void analyse(const algebra::SymmetricPattern& pattern, std::span<const Index> kept,
               std::span<const Index> node) override;
  algebra::FactorReport factor(const algebra::SymmetricMatrix& matrix) override;
  void solve(std::span<const double> b, std::span<double> x) const override;
  void solve_transposed(std::span<const double> b, std::span<double> x) const override;
  const Eigen::MatrixXd& schur() const override { return schur_; }
  Eigen::VectorXd condense(std::span<const double> b, std::vector<double>& work) const override;
  void expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
              std::span<double> x) const override;
  const algebra::DenseAlgebra& dense() const override { return lapack(); }
  std::size_t bytes() const override;

 private:
  /// Sorts the entries into A_ii and the three blocks of the kept unknowns.
  void scatter(const algebra::SymmetricMatrix& matrix);
  void add_entry(Index row, Index column, double value, std::vector<Index>& next);
  void make_schur();
  Eigen::VectorXd solve_inside(const Eigen::VectorXd& right, bool transposed = false) const;

  std::vector<Index> inner_;  ///< by unknown: number among the interior ones, or −1 − number among the kept
  Index inside_ = 0, kept_ = 0;
  std::vector<Index> column_start_, row_;  ///< A_ii by columns
  std::vector<double> value_;
  Eigen::MatrixXd to_kept_, from_kept_, kept_block_, schur_;  ///< A_ki, A_ik, A_kk, S
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  std::string trouble_;
};

}  // namespace ashlar::suitesparse
