#pragma once
// The virtual element of order 1 for plane elasticity on any simple polygon.
// Beirão da Veiga, Brezzi, Marini: Virtual elements for linear elasticity problems, SIAM J. Numer. Anal. 51
// (2013); lowest order as in Gain, Talischi, Paulino, Comput. Methods Appl. Mech. Engrg. 282 (2014).
//
//   K = |E| t Bᵀ D B + t (I−P)ᵀ diag(d)⊗T (I−P)
//   B_i = [g_x 0; 0 g_y; g_y g_x]     strain of Πu: ε = Σ B_i u_i
//   P_ji = w_i + g_i·(x_j − x̄)        Πu at the corners

#include <memory>

#include "elasticity/stabilisation.hpp"
#include "model/element.hpp"

namespace ashlar::elasticity {

class VemElement final : public model::Element {
 public:
  explicit VemElement(std::shared_ptr<const Stabilisation> stabilisation)
      : stabilisation_(std::move(stabilisation)) {}

  model::NodeCounts nodes() const override { return {}; }
  int point_count(std::size_t) const override { return 1; }
  void integrate(const model::Cell& cell, model::IntegrationPoints& points) const override;
  void add_stabilisation(const model::Cell& cell, const model::Material& material,
                         std::span<double> packed) const override;
  bool stabilised() const override { return true; }
  void stiffness(const model::Cell& cell, const model::Material& material,
                 std::span<double> packed) const override;
  void add_internal_force(const model::Cell& cell, const model::Material& material, std::span<const double> u,
                          std::span<double> force) const override;
  void add_body_force(const model::Cell& cell, Point b, std::span<double> force) const override;
  int order() const override { return 1; }
  void edge_shape(double t, std::span<double> values) const override;

 private:
  std::shared_ptr<const Stabilisation> stabilisation_;
};

}  // namespace ashlar::elasticity
