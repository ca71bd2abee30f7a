#pragma once
// Direct solution of symmetric positive definite systems with some unknowns set apart ("kept"): they are
// ordered last, so that the last block of the factor is the factor of their Schur complement. Terms that act
// on the kept unknowns only (contact) then iterate on a small dense system, and the bulk is factored once.

#include <memory>
#include <span>
#include <string>

#include <Eigen/Dense>

#include "algebra/dense.hpp"
#include "algebra/sparse.hpp"
#include "core/schema.hpp"

namespace ashlar::algebra {

struct FactorReport {
  bool done = false;
  std::string reason;    ///< why not, in words
  Index unknown = -1;    ///< where it broke down, if known
  std::string ordering;  ///< "METIS on 41200 nodes": logged
  double entries = 0;    ///< of the factor
  double flops = 0;
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Orders the unknowns; `kept` (ascending, may be empty) come last in the factor. `node[i]` is the mesh
  /// node of unknown i, ascending in i: the graph of nodes is ordered, not that of unknowns.
  virtual void analyse(const SymmetricPattern& pattern, std::span<const Index> kept,
                       std::span<const Index> node) = 0;
  /// Factors; matrices that are not symmetric only if the solver is of kind "unsymmetric_solver". If there
  /// are kept unknowns, the matrix may be singular in them (a body held by contact alone): only the block of
  /// the other unknowns must be positive definite.
  virtual FactorReport factor(const SymmetricMatrix& matrix) = 0;

  /// x = A⁻¹ b. Only without kept unknowns.
  virtual void solve(std::span<const double> b, std::span<double> x) const = 0;
  /// x = A⁻ᵀ b, as `solve`. Solvers for symmetric matrices need not say how.
  virtual void solve_transposed(std::span<const double> b, std::span<double> x) const { solve(b, x); }

  /// S = A_kk − A_ki A_ii⁻¹ A_ik, dense, in the order of `kept`.
  virtual const Eigen::MatrixXd& schur() const = 0;
  /// The load on the kept unknowns with the others eliminated: b_k − A_ki A_ii⁻¹ b_i. `work` serves `expand`.
  virtual Eigen::VectorXd condense(std::span<const double> b, std::vector<double>& work) const = 0;
  /// All unknowns, given the kept ones: x_i = A_ii⁻¹ (b_i − A_ik x_k).
  virtual void expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
                      std::span<double> x) const = 0;

  /// For systems in the kept unknowns.
  virtual const DenseAlgebra& dense() const { return eigen_dense(); }

  virtual std::size_t bytes() const = 0;
};

/// A module registers a solver as kind "solver", or "unsymmetric_solver", with this signature.
using MakeSolver = std::unique_ptr<LinearSolver>(const core::Settings& settings);

}  // namespace ashlar::algebra
