#pragma once
// The polynomial projections of one cell for the virtual elements of order 2 and 3; equations in
// vem_high.hpp. "Scalar dofs" are those of one component: corners, edge nodes (edge by edge), cell moments.

#include <span>

#include <Eigen/Dense>

#include "elasticity/polynomials.hpp"

namespace ashlar::elasticity {

/// The most monomials: order 3.
inline constexpr int most_strains = 6, most_displacements = 10;

class Projection {
 public:
  Projection(std::span<const Point> corners, int order);

  Frame frame;
  /// Π∂_x v and Π∂_y v: coefficients (by orthonormal polynomials of degree ≤ k−1) × scalar dofs.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_strains> along_x, along_y;
  /// Orthonormal rows that span the scalar dofs of all polynomials of degree ≤ k: P = rangeᵀ range.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_displacements> range;

  /// Values at ξ of the orthonormal polynomials: their mean product over the cell is 1 or 0.
  Eigen::VectorXd orthonormal(Point xi) const;

 private:
  void project_gradient(std::span<const Point> local, std::span<const Point> corners);
  void project_dofs(std::span<const Point> local);

  int order_;
  /// Mean of m_α m_β, degrees ≤ k and ≤ k−2 or ≤ k−1 both.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_displacements, most_strains>
      mass_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_strains, most_strains> factor_;
};

}  // namespace ashlar::elasticity
