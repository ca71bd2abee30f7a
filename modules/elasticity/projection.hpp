#pragma once
// The polynomial projections of one cell for the virtual elements of order 2 and 3; equations in
// vem_high.hpp. "Scalar dofs" are those of one component: corners, edge nodes (edge by edge), cell moments.

#include <span>

#include <Eigen/Dense>

#include "geometry/point.hpp"

namespace ashlar::elasticity {

using geometry::Point;

/// Inner and outer nodes of the Gauss–Lobatto rule with order + 1 points on [0, 1], and its weights.
struct EdgeRule {
  std::span<const double> at, weight;
};
EdgeRule edge_rule(int order);

/// Number of monomials of degree ≤ d.
constexpr int monomials(int d) {
  return (d + 1) * (d + 2) / 2;
}

/// ξ = L⁻¹ (x − c).
struct Frame {
  explicit Frame(std::span<const Point> corners);
  Point to_local(Point x) const;
  Point to_global(Point xi) const;

  double area = 0;
  Point centre;
  double xx = 1, yx = 0, yy = 1;  ///< L, lower triangle
};

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
