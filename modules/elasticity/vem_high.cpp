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

/// t (I−P)ᵀ diag(d) (I−P) of the scalar dofs, entry by entry. With P = QᵀQ and Y = Q diag(d) − ½ (Q diag(d)
/// Qᵀ) Q it is diag(d) − YᵀQ − QᵀY.
template <int size>
class Rest {
 public:
  Rest(const Projection& projection, const Stabilisation& stabilisation, const Material& law,
       double thickness)
      : q_(projection.range), d_(q_.cols()) {
    Eigen::VectorXd slope =
        projection.frame.area *
        (projection.along_x.colwise().squaredNorm() + projection.along_y.colwise().squaredNorm()).transpose();
    // The means of v ξ and v η turn with the axes: only what they have together belongs to the cell.
    if (size == monomials(3)) slope.tail<2>().setConstant(slope.tail<2>().mean());
    const auto dofs = static_cast<std::size_t>(slope.size());
    stabilisation.weigh_dofs(law, {slope.data(), dofs}, {d_.data(), dofs});
    d_ *= thickness;
    y_ = q_ * d_.asDiagonal();
    const Eigen::Matrix<double, size, size> middle = y_.lazyProduct(q_.transpose());
    y_ -= 0.5 * middle.lazyProduct(q_);
  }
  double at(Eigen::Index i, Eigen::Index k) const {
    return (i == k ? d_[i] : 0) - y_.col(i).dot(q_.col(k)) - q_.col(i).dot(y_.col(k));
  }

 private:
  Eigen::Matrix<double, size, Eigen::Dynamic> q_, y_;
  Eigen::VectorXd d_;
};

/// packed += the rest. Row 2i+c of the packed triangle begins at (2i+c)(2i+c+1)/2; only equal components
/// couple.
template <int size>
void add_rest(const Rest<size>& rest, std::size_t dofs, std::span<double> packed) {
  double* row = packed.data();
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(dofs); ++i) {
    double* row_y = row + 2 * i + 1;
    for (Eigen::Index k = 0; k <= i; ++k) {
      const double s = rest.at(i, k);
      row[2 * k] += s;
      row_y[2 * k + 1] += s;
    }
    row = row_y + 2 * i + 2;
  }
}

/// packed = |E| t Σ_β B_βᵀ D B_β + the rest: β counts the orthonormal polynomials, so this is the exact
/// integral for a constant D.
template <int strains, int displacements>
void fill_stiffness(const Projection& projection, const Rest<displacements>& rest, const model::Tangent& d,
                    double volume, std::span<double> packed) {
  const Eigen::Matrix<double, strains, Eigen::Dynamic> along_x = volume * projection.along_x,
                                                       along_y = volume * projection.along_y;
  double* row_x = packed.data();
  for (Eigen::Index i = 0; i < along_x.cols(); ++i) {
    double* row_y = row_x + 2 * i + 1;
    const Eigen::Matrix<double, strains, 1> x = along_x.col(i), y = along_y.col(i);
    for (Eigen::Index k = 0; k <= i; ++k) {
      const double* x_k = &projection.along_x(0, k);
      const double* y_k = &projection.along_y(0, k);
      double xx = 0, xy = 0, yx = 0, yy = 0;
      for (int b = 0; b < strains; ++b) {
        xx += x[b] * x_k[b];
        xy += x[b] * y_k[b];
        yx += y[b] * x_k[b];
        yy += y[b] * y_k[b];
      }
      const double s = rest.at(i, k);
      row_x[2 * k] = d[0] * xx + d[2] * xy + d[8] * yx + d[10] * yy + s;
      if (k < i) row_x[2 * k + 1] = d[1] * xy + d[2] * xx + d[9] * yy + d[10] * yx;
      row_y[2 * k] = d[4] * yx + d[6] * yy + d[8] * xx + d[10] * xy;
      row_y[2 * k + 1] = d[5] * yy + d[6] * yx + d[9] * xy + d[10] * xx + s;
    }
    row_x = row_y + 2 * i + 2;
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
  const Projection projection(cell.corners, order_);
  const auto dofs = static_cast<std::size_t>(projection.range.cols());
  if (order_ == 2)
    add_rest(Rest<6>(projection, *stabilisation_, law, cell.thickness), dofs, packed);
  else
    add_rest(Rest<10>(projection, *stabilisation_, law, cell.thickness), dofs, packed);
}

void VemHigh::stiffness(const Cell& cell, const Material& law, std::span<double> packed) const {
  const Projection projection(cell.corners, order_);
  const model::Tangent tangent = law.respond({}, {}, {}).tangent;
  const double t = cell.thickness, volume = projection.frame.area * t;
  if (order_ == 2)
    fill_stiffness<3>(projection, Rest<6>(projection, *stabilisation_, law, t), tangent, volume, packed);
  else
    fill_stiffness<6>(projection, Rest<10>(projection, *stabilisation_, law, t), tangent, volume, packed);
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
