#include "elasticity/polynomials.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

namespace {

constexpr double s5 = 0.44721359549995793928;  // 1/√5
constexpr std::array<double, 2> at_1 = {0, 1}, weight_1 = {0.5, 0.5};
constexpr std::array<double, 3> at_2 = {0, 0.5, 1}, weight_2 = {1.0 / 6, 4.0 / 6, 1.0 / 6};
constexpr std::array<double, 4> at_3 = {0, (1 - s5) / 2, (1 + s5) / 2, 1},
                                weight_3 = {1.0 / 12, 5.0 / 12, 5.0 / 12, 1.0 / 12};

}  // namespace

EdgeRule edge_rule(int order) {
  assert(1 <= order && order <= 3);
  if (order == 1) return {at_1, weight_1};
  if (order == 2) return {at_2, weight_2};
  return {at_3, weight_3};
}

void lagrange(std::span<const double> nodes, double t, std::span<double> values) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    values[i] = 1;
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) values[i] *= (t - nodes[j]) / (nodes[i] - nodes[j]);
  }
}

void virtual_edge_shape(int order, double t, std::span<double> values) {
  const EdgeRule rule = edge_rule(order);
  std::array<double, 4> along{};
  lagrange(rule.at, t, along);
  const std::size_t last = rule.at.size() - 1;
  values[0] = along[0];
  values[1] = along[last];
  for (std::size_t i = 1; i < last; ++i) values[i + 1] = along[i];
}

// The mean of (a + θ × x) m_α: x = c + L ξ, and in ξ the second moments are 1.
void virtual_rigid_values(std::span<const Point> corners, int order, std::span<model::RigidValue> values) {
  if (order == 1) return;
  const Frame frame(corners);
  values[0] = {1, frame.centre};
  if (order == 2) return;
  values[1] = {0, {frame.xx, frame.yx}};
  values[2] = {0, {0, frame.yy}};
}

Frame::Frame(std::span<const Point> corners)
    : area(geometry::signed_area(corners)), centre(geometry::centroid(corners)) {
  const std::vector<double> moments = geometry::monomial_integrals(corners, centre, 2);
  xx = std::sqrt(moments[3] / area);
  yx = moments[4] / area / xx;
  yy = std::sqrt(std::max(moments[5] / area - yx * yx, 1e-16 * moments[5] / area));
}

Point Frame::to_local(Point x) const {
  const Point d = x - centre;
  const double xi = d.x / xx;
  return {xi, (d.y - yx * xi) / yy};
}

Point Frame::to_global(Point xi) const {
  return centre + Point{xx * xi.x, yx * xi.x + yy * xi.y};
}

}  // namespace ashlar::elasticity
