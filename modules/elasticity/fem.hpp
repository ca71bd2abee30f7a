#pragma once
// Isoparametric finite elements with straight edges, for comparison: triangles of three and six nodes,
// quadrilaterals of four and eight (serendipity), and the quadrilateral of four with incompatible modes.
// Zienkiewicz, Taylor, Zhu: The Finite Element Method, 6th ed., ch. 4 and 5. Incompatible modes: Taylor,
// Beresford, Wilson, Int. J. Numer. Methods Engrg. 10 (1976), with derivatives taken at the centre so that
// the patch test holds; the modes 1 − r², 1 − s² are the cell's own nodes.
//
// Around an axis, ε_zz = Σ N_i u_xi / x at each point.
//
//   ε = Σ B_i u_i,  B_i from ∂N_i/∂x = J⁻ᵀ ∂N_i/∂r,  x = Σ corners L_i(r) x_i, L_i linear or bilinear

#include "model/element.hpp"

namespace ashlar::elasticity {

using geometry::Point;

class FiniteElement final : public model::Element {
 public:
  /// `order`: 1 or 2; incompatible modes with order 1 only.
  FiniteElement(int order, bool incompatible) : order_(order), incompatible_(incompatible) {}

  model::NodeCounts nodes() const override { return {1, order_ - 1, incompatible_ ? 2 : 0}; }
  int order() const override { return order_; }
  std::string refuses(const model::Cell& cell) const override;
  int point_count(std::size_t corners) const override;
  void integrate(const model::Cell& cell, model::IntegrationPoints& points) const override;
  void add_body_force(const model::Cell& cell, Point b, std::span<double> force) const override;
  void edge_shape(double t, std::span<double> values) const override;
  void rigid_values(const model::Cell& cell, std::span<model::RigidValue> values) const override;

 private:
  int order_;
  bool incompatible_;
};

}  // namespace ashlar::elasticity
