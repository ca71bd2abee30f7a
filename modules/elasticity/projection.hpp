#pragma once
// The polynomial projections of one cell for the virtual elements of order 2 and 3; equations in
// vem_high.hpp. "Scalar dofs" are those of one component: corners, edge nodes (edge by edge), cell moments.

#include <span>

#include <Eigen/Dense>

#include "elasticity/polynomials.hpp"

namespace ashlar::elasticity {

class Projection {
 public:
  Projection(std::span<const Point> corners, int order);

  Frame frame;
  /// Π∂_x v and Π∂_y v: coefficients (by orthonormal polynomials of degree ≤ k−1) × scalar dofs.
  Eigen::MatrixXd along_x, along_y;
  /// I − P of the scalar dofs.
  Eigen::MatrixXd rest;

  /// Values at ξ of the orthonormal polynomials: their mean product over the cell is 1 or 0.
  Eigen::VectorXd orthonormal(Point xi) const;

 private:
  void project_gradient(std::span<const Point> local, std::span<const Point> corners);
  void project_dofs(std::span<const Point> local);

  int order_;
  Eigen::MatrixXd mass_;  ///< mean of m_α m_β, degrees ≤ k and ≤ k−2 or ≤ k−1 both
  Eigen::MatrixXd factor_;
};

}  // namespace ashlar::elasticity
