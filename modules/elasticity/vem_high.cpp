#include "elasticity/vem_high.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "elasticity/projection.hpp"
#include "elasticity/triangle_rule.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

using model::Cell;
using model::IntegrationPoints;
using model::Material;

namespace {

/// Rows of B for the strain whose coefficients are `at` of the orthonormal polynomials.
void set_rows(const Projection& projection, const Eigen::VectorXd& at, IntegrationPoints& points, int q) {
  const Eigen::RowVectorXd x = at.transpose() * projection.along_x, y = at.transpose() * projection.along_y;
  const std::span<double> xx = points.row(q, 0), yy = points.row(q, 1), xy = points.row(q, 2);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto ux = static_cast<std::size_t>(2 * i), uy = ux + 1;
    xx[ux] = xy[uy] = x[i];
    yy[uy] = xy[ux] = y[i];
  }
}

/// One "point" for each orthonormal polynomial: Σ area t B_βᵀ D B_β is then the exact integral for a constant
/// D.
void coefficients(const Projection& projection, double thickness, IntegrationPoints& points) {
  const auto size = static_cast<int>(projection.along_x.rows());
  points.resize(size, static_cast<int>(2 * projection.along_x.cols()));
  for (int b = 0; b < size; ++b) {
    points.weight[static_cast<std::size_t>(b)] = projection.frame.area * thickness;
    set_rows(projection, Eigen::VectorXd::Unit(size, b), points, b);
  }
}

IntegrationPoints& scratch() {
  thread_local IntegrationPoints points;
  return points;
}

void add_rest(const Projection& projection, const Stabilisation& stabilisation, const Material& law,
              double thickness, std::span<double> packed) {
  const Eigen::VectorXd slope =
      (projection.along_x.colwise().squaredNorm() + projection.along_y.colwise().squaredNorm()).transpose() *
      projection.frame.area;
  std::vector<double> d(static_cast<std::size_t>(slope.size()));
  stabilisation.weigh_dofs(law, {slope.data(), d.size()}, d);
  const Eigen::Map<const Eigen::VectorXd> weight(d.data(), slope.size());
  const Eigen::MatrixXd s = thickness * projection.rest.transpose() * weight.asDiagonal() * projection.rest;
  // Row 2i+c of the packed triangle begins at (2i+c)(2i+c+1)/2; only equal components couple.
  for (Eigen::Index i = 0; i < s.rows(); ++i)
    for (Eigen::Index c = 0; c < 2; ++c) {
      const Eigen::Index row = 2 * i + c;
      double* entries = packed.data() + row * (row + 1) / 2;
      for (Eigen::Index k = 0; k <= i; ++k) entries[2 * k + c] += s(i, k);
    }
}

}  // namespace

VemHigh::VemHigh(int order, std::shared_ptr<const Stabilisation> stabilisation)
    : order_(order), stabilisation_(std::move(stabilisation)) {
  assert(order == 2 || order == 3);
}

int VemHigh::point_count(std::size_t corners) const {
  return order_ == 2 ? 3 : 6 * (static_cast<int>(corners) - 2);
}

// Order 2: strains are linear and need a rule of degree 2. Three points on the circle of radius √2 around the
// centroid in ξ have the area, centroid and second moments of any cell. Order 3: a rule of degree 4 in
// triangles.
void VemHigh::integrate(const Cell& cell, IntegrationPoints& points) const {
  const Projection projection(cell.corners, order_);
  const double volume = projection.frame.area * cell.thickness;
  const int dofs = this->dofs(cell.corners.size());
  if (order_ == 2) {
    points.resize(3, dofs);
    for (int q = 0; q < 3; ++q) {
      const double angle = (0.5 + 4.0 / 3 * q) * std::numbers::pi;
      const Point xi{std::numbers::sqrt2 * std::cos(angle), std::numbers::sqrt2 * std::sin(angle)};
      points.weight[static_cast<std::size_t>(q)] = volume / 3;
      points.at[static_cast<std::size_t>(q)] = projection.frame.to_global(xi);
      set_rows(projection, projection.orthonormal(xi), points, q);
    }
    return;
  }
  const auto triangles = geometry::triangulate(cell.corners);
  // Fewer triangles where corners are collinear: the last points then weigh nothing.
  points.resize(point_count(cell.corners.size()), dofs);
  int q = 0;
  for (const auto& [a, b, c] : triangles) {
    const std::array<Point, 3> corners{cell.corners[static_cast<std::size_t>(a)],
                                       cell.corners[static_cast<std::size_t>(b)],
                                       cell.corners[static_cast<std::size_t>(c)]};
    const double part = geometry::signed_area(corners) * cell.thickness;
    for (const TrianglePoint& p : triangle_rule_4) {
      const Point at = p.a * corners[0] + p.b * corners[1] + (1 - p.a - p.b) * corners[2];
      points.weight[static_cast<std::size_t>(q)] = p.weight * part;
      points.at[static_cast<std::size_t>(q)] = at;
      set_rows(projection, projection.orthonormal(projection.frame.to_local(at)), points, q++);
    }
  }
}

void VemHigh::add_stabilisation(const Cell& cell, const Material& law, std::span<double> packed) const {
  add_rest(Projection(cell.corners, order_), *stabilisation_, law, cell.thickness, packed);
}

void VemHigh::stiffness(const Cell& cell, const Material& law, std::span<double> packed) const {
  const Projection projection(cell.corners, order_);
  IntegrationPoints& points = scratch();
  coefficients(projection, cell.thickness, points);
  std::fill(packed.begin(), packed.end(), 0.0);
  const model::Tangent tangent = law.respond({}, {}, {}).tangent;
  for (int b = 0; b < points.size(); ++b) model::add_tangent(points, b, tangent, packed);
  add_rest(projection, *stabilisation_, law, cell.thickness, packed);
}

void VemHigh::add_internal_force(const Cell& cell, const Material& law, std::span<const double> u,
                                 std::span<double> force) const {
  thread_local std::vector<double> packed;
  packed.resize(u.size() * (u.size() + 1) / 2);
  stiffness(cell, law, packed);
  model::add_packed_product(packed, u, force);
}

// ∫ v is a dof times the area.
void VemHigh::add_body_force(const Cell& cell, Point b, std::span<double> force) const {
  const double volume = geometry::signed_area(cell.corners) * cell.thickness;
  const std::size_t mean = 2 * cell.corners.size() * static_cast<std::size_t>(order_);
  force[mean] += volume * b.x;
  force[mean + 1] += volume * b.y;
}

void VemHigh::edge_shape(double t, std::span<double> values) const {
  virtual_edge_shape(order_, t, values);
}

double VemHigh::edge_node(int node) const {
  return edge_rule(order_).at[static_cast<std::size_t>(node) + 1];
}

void VemHigh::rigid_values(const Cell& cell, std::span<model::RigidValue> values) const {
  virtual_rigid_values(cell.corners, order_, values);
}

}  // namespace ashlar::elasticity
