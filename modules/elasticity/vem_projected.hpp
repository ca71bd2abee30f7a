#pragma once
// The virtual element from projected strains (strain_projection.hpp): without stabilisation in all scenes,
// and with it around an axis. Any simple polygon, order 1 to 3.
//
// Without stabilisation, strains are projected onto a degree that sees every deformation of the cell, and the
// law is asked at so many more points: what yields, yields everywhere. With it, the degree is k−1 as usual,
// and a plane element adds what that does not see, as thick as the way around the axis at the cell's
// centroid.

#include <memory>

#include "model/element.hpp"

namespace ashlar::elasticity {

class VemProjected final : public model::Element {
 public:
  /// `rest`: the plane element whose stabilisation is added; null: none.
  VemProjected(int order, bool axisymmetric, std::shared_ptr<const model::Element> rest)
      : order_(order), axisymmetric_(axisymmetric), rest_(std::move(rest)) {}

  model::NodeCounts nodes() const override { return {1, order_ - 1, order_ * (order_ - 1) / 2}; }
  int order() const override { return order_; }
  std::string refuses(const model::Cell& cell) const override;
  int point_count(std::size_t corners) const override;
  void integrate(const model::Cell& cell, model::IntegrationPoints& points) const override;
  void add_stabilisation(const model::Cell& cell, const model::Material& law,
                         std::span<double> packed) const override;
  bool stabilised() const override { return rest_ != nullptr; }
  void add_body_force(const model::Cell& cell, geometry::Point b, std::span<double> force) const override;
  void edge_shape(double t, std::span<double> values) const override;
  double edge_node(int node) const override;
  void rigid_values(const model::Cell& cell, std::span<model::RigidValue> values) const override;

 private:
  int degree(std::size_t corners) const;

  int order_;
  bool axisymmetric_;
  std::shared_ptr<const model::Element> rest_;
};

}  // namespace ashlar::elasticity
