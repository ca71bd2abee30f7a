#include "elasticity/vem_projected.hpp"

#include "elasticity/strain_projection.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

using model::Cell;

namespace {

/// A deformation of which less is seen is as good as free.
constexpr double least_share = 1e-4;

/// Convex cells of few corners and no short edges are seen whole; only others are looked at.
bool is_plain(std::span<const geometry::Point> corners) {
  const std::size_t n = corners.size();
  const double size = geometry::diameter(corners);
  for (std::size_t i = 0; i < n; ++i) {
    const geometry::Point a = corners[i], b = corners[(i + 1) % n], c = corners[(i + 2) % n];
    if (distance(a, b) < 0.05 * size || cross(b - a, c - b) < 0) return false;
  }
  return n <= 12;
}

}  // namespace

int VemProjected::degree(std::size_t corners) const {
  return rest_ ? order_ - 1 : seeing_degree(corners, order_);
}

std::string VemProjected::refuses(const Cell& cell) const {
  if (rest_ || is_plain(cell.corners)) return {};
  const int l = degree(cell.corners.size());
  if (order_ + l <= highest_degree && StrainProjection({cell.corners}, order_, l).least_seen() > least_share)
    return {};
  return "stabilisation \"none\" does not see all deformations of so odd a cell: choose \"bending\" or order "
         "1";
}

int VemProjected::point_count(std::size_t corners) const {
  return projection_points(corners, order_, degree(corners), axisymmetric_);
}

void VemProjected::integrate(const Cell& cell, model::IntegrationPoints& points) const {
  StrainProjection(cell, order_, degree(cell.corners.size())).fill(points);
}

void VemProjected::add_stabilisation(const Cell& cell, const model::Material& law,
                                     std::span<double> packed) const {
  if (!rest_) return;
  const double around = model::depth(cell.thickness, cell.axisymmetric, geometry::centroid(cell.corners));
  rest_->add_stabilisation({cell.corners, around}, law, packed);
}

void VemProjected::add_body_force(const Cell& cell, geometry::Point b, std::span<double> force) const {
  StrainProjection(cell, order_, degree(cell.corners.size())).add_body_force(b, force);
}

void VemProjected::edge_shape(double t, std::span<double> values) const {
  virtual_edge_shape(order_, t, values);
}

double VemProjected::edge_node(int node) const {
  return edge_rule(order_).at[static_cast<std::size_t>(node) + 1];
}

void VemProjected::rigid_values(const Cell& cell, std::span<model::RigidValue> values) const {
  virtual_rigid_values(cell.corners, order_, values);
}

}  // namespace ashlar::elasticity
