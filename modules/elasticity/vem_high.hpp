#pragma once
// Virtual elements of order 2 and 3 on any simple polygon.
// Beirão da Veiga, Brezzi, Marini: Virtual elements for linear elasticity problems, SIAM J. Numer. Anal. 51
// (2013); the projection of the strain onto polynomials as in Artioli, Beirão da Veiga, Lovadina, Sacco,
// Comput. Mech. 60 (2017).
//
// Dofs: values at the corners and at the k−1 inner Gauss–Lobatto nodes of each edge, and the means of v m_α
// over the cell for all m_α of degree ≤ k−2. Polynomials are written in ξ = L⁻¹ (x − c), L Lᵀ the cell's
// second moments over its area: in these coordinates each cell is as long as wide, whatever its aspect.
//
//   strain:  ⟨Π∂_d v, m_β⟩ = ∮ v m_β n_d − ∫ v ∂_d m_β      for all m_β of degree ≤ k−1
//   rest:    S = Σ (v − Pv)_i d_i (v − Pv)_i                P: least squares of the dofs by polynomials of
//   degree k

#include <memory>

#include <Eigen/Dense>

#include "elasticity/stabilisation.hpp"
#include "model/element.hpp"

namespace ashlar::elasticity {

class VemHigh final : public model::Element {
 public:
  /// `order`: 2 or 3.
  VemHigh(int order, std::shared_ptr<const Stabilisation> stabilisation);

  model::NodeCounts nodes() const override { return {1, order_ - 1, order_ * (order_ - 1) / 2}; }
  int order() const override { return order_; }
  int point_count(std::size_t corners) const override;
  void integrate(const model::Cell& cell, model::IntegrationPoints& points) const override;
  void add_stabilisation(const model::Cell& cell, const model::Material& law,
                         std::span<double> packed) const override;
  bool stabilised() const override { return true; }
  void stiffness(const model::Cell& cell, const model::Material& law,
                 std::span<double> packed) const override;
  void add_internal_force(const model::Cell& cell, const model::Material& law, std::span<const double> u,
                          std::span<double> force) const override;
  void add_body_force(const model::Cell& cell, Point b, std::span<double> force) const override;
  void edge_shape(double t, std::span<double> values) const override;
  double edge_node(int node) const override;
  void rigid_values(const model::Cell& cell, std::span<model::RigidValue> values) const override;

 private:
  int order_;
  std::shared_ptr<const Stabilisation> stabilisation_;
};

}  // namespace ashlar::elasticity
