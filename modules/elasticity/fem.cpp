#include "elasticity/fem.hpp"

#include <array>
#include <cassert>
#include <cmath>

#include "elasticity/triangle_rule.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::elasticity {

using model::Cell;
using model::IntegrationPoints;

namespace {

/// A shape function's value and its derivatives by the reference coordinates.
struct Shape {
  double n = 0, r = 0, s = 0;
};

struct Shapes {
  std::array<Shape, 10> of;  ///< corners, nodes of the edges, incompatible modes
  std::size_t size = 0;
  void add(Shape shape) { of[size++] = shape; }
};

/// A place in the reference cell and its weight there.
struct Sample {
  double r, s, weight;
};

// Area coordinates L1 = 1 − r − s, L2 = r, L3 = s.
Shapes triangle(double r, double s, int order) {
  const std::array<Shape, 3> l = {{{1 - r - s, -1, -1}, {r, 1, 0}, {s, 0, 1}}};
  Shapes shapes;
  for (const Shape& a : l)
    shapes.add(order == 1 ? a : Shape{a.n * (2 * a.n - 1), (4 * a.n - 1) * a.r, (4 * a.n - 1) * a.s});
  for (std::size_t i = 0; i < 3 && order == 2; ++i) {
    const Shape &a = l[i], &b = l[(i + 1) % 3];
    shapes.add({4 * a.n * b.n, 4 * (a.r * b.n + a.n * b.r), 4 * (a.s * b.n + a.n * b.s)});
  }
  return shapes;
}

constexpr std::array<double, 4> corner_r = {-1, 1, 1, -1}, corner_s = {-1, -1, 1, 1};

Shapes quadrilateral(double r, double s, int order, bool incompatible) {
  Shapes shapes;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = corner_r[i], b = corner_s[i], fr = 1 + a * r, fs = 1 + b * s, rest = a * r + b * s - 1;
    if (order == 1)
      shapes.add({fr * fs / 4, a * fs / 4, b * fr / 4});
    else
      shapes.add({fr * fs * rest / 4, a * fs * (rest + fr) / 4, b * fr * (rest + fs) / 4});
  }
  // Nodes of the edges s = −1, r = 1, s = 1, r = −1.
  for (int edge = 0; edge < 4 && order == 2; ++edge) {
    const double side = edge == 0 || edge == 3 ? -1 : 1;
    if (edge % 2 == 0)
      shapes.add({(1 - r * r) * (1 + side * s) / 2, -r * (1 + side * s), side * (1 - r * r) / 2});
    else
      shapes.add({(1 + side * r) * (1 - s * s) / 2, side * (1 - s * s) / 2, -s * (1 + side * r)});
  }
  if (incompatible) {
    shapes.add({1 - r * r, -2 * r, 0});
    shapes.add({1 - s * s, 0, -2 * s});
  }
  return shapes;
}

Shapes shapes_at(std::size_t corners, double r, double s, int order, bool incompatible) {
  return corners == 3 ? triangle(r, s, order) : quadrilateral(r, s, order, incompatible);
}

/// x_r, x_s of the corners' linear or bilinear map.
struct Jacobian {
  Point r, s;
  double determinant() const { return cross(r, s); }
  /// ∂/∂x and ∂/∂y from ∂/∂r and ∂/∂s.
  Point global(double by_r, double by_s) const {
    const double d = determinant();
    return {(by_r * s.y - by_s * r.y) / d, (by_s * r.x - by_r * s.x) / d};
  }
};

Jacobian jacobian(std::span<const Point> corners, double r, double s) {
  const Shapes map = shapes_at(corners.size(), r, s, 1, false);
  Jacobian j;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point x = corners[i] - corners[0];
    j.r = j.r + map.of[i].r * x;
    j.s = j.s + map.of[i].s * x;
  }
  return j;
}

/// Rules that give the stiffness of parallelograms and straight triangles exactly.
std::vector<Sample> samples(std::size_t corners, int order) {
  if (corners == 3 && order == 1) return {{1.0 / 3, 1.0 / 3, 0.5}};
  std::vector<Sample> all;
  if (corners == 3) {
    for (const TrianglePoint& p : triangle_rule_2) all.push_back({p.a, p.b, 0.5 * p.weight});
    return all;
  }
  const geometry::Rule& rule = geometry::gauss_legendre(2 * order + 1);
  for (std::size_t j = 0; j < rule.at.size(); ++j)
    for (std::size_t i = 0; i < rule.at.size(); ++i)
      all.push_back({2 * rule.at[i] - 1, 2 * rule.at[j] - 1, 4 * rule.weight[i] * rule.weight[j]});
  return all;
}

Point place(std::span<const Point> corners, double r, double s) {
  const Shapes map = shapes_at(corners.size(), r, s, 1, false);
  Point x = corners[0];
  for (std::size_t i = 0; i < corners.size(); ++i) x = x + map.of[i].n * (corners[i] - corners[0]);
  return x;
}

}  // namespace

std::string FiniteElement::refuses(const Cell& cell) const {
  const std::size_t n = cell.corners.size();
  if (incompatible_ && n != 4) return "incompatible modes are for quadrilaterals";
  if (n != 3 && n != 4) return "finite elements are triangles and quadrilaterals";
  for (std::size_t i = 0; i < n && n == 4; ++i)
    if (jacobian(cell.corners, corner_r[i], corner_s[i]).determinant() <= 0)
      return "finite elements need convex cells";
  return {};
}

int FiniteElement::point_count(std::size_t corners) const {
  if (corners == 3) return order_ == 1 ? 1 : 3;
  return order_ == 1 ? 4 : 9;
}

void FiniteElement::integrate(const Cell& cell, IntegrationPoints& points) const {
  const std::size_t n = cell.corners.size();
  const std::vector<Sample> all = samples(n, order_);
  points.resize(static_cast<int>(all.size()), dofs(n));
  const Jacobian centre = jacobian(cell.corners, 0, 0);
  const std::size_t compatible = n * static_cast<std::size_t>(order_);
  for (int q = 0; q < points.size(); ++q) {
    const Sample& sample = all[static_cast<std::size_t>(q)];
    const Jacobian j = jacobian(cell.corners, sample.r, sample.s);
    const Shapes shapes = shapes_at(n, sample.r, sample.s, order_, incompatible_);
    const Point at = place(cell.corners, sample.r, sample.s);
    points.weight[static_cast<std::size_t>(q)] =
        sample.weight * j.determinant() * model::depth(cell.thickness, cell.axisymmetric, at);
    points.at[static_cast<std::size_t>(q)] = at;
    const std::span<double> xx = points.row(q, 0), yy = points.row(q, 1), xy = points.row(q, 2),
                            zz = points.row(q, 3);
    for (std::size_t i = 0; i < shapes.size; ++i) {
      const Shape& shape = shapes.of[i];
      Point g = j.global(shape.r, shape.s);
      // |J₀|/|J| J₀⁻ᵀ: a constant stress then does no work on the modes.
      if (i >= compatible) g = centre.determinant() / j.determinant() * centre.global(shape.r, shape.s);
      xx[2 * i] = xy[2 * i + 1] = g.x;
      yy[2 * i + 1] = xy[2 * i] = g.y;
      if (cell.axisymmetric) zz[2 * i] = shape.n / at.x;
    }
  }
}

// The modes take no load: the patch test with body forces then holds, too.
void FiniteElement::add_body_force(const Cell& cell, Point b, std::span<double> force) const {
  const std::size_t n = cell.corners.size();
  for (const Sample& sample : samples(n, order_)) {
    const Point at = place(cell.corners, sample.r, sample.s);
    const double w = sample.weight * jacobian(cell.corners, sample.r, sample.s).determinant() *
                     model::depth(cell.thickness, cell.axisymmetric, at);
    const Shapes shapes = shapes_at(n, sample.r, sample.s, order_, false);
    for (std::size_t i = 0; i < shapes.size; ++i) {
      force[2 * i] += w * shapes.of[i].n * b.x;
      force[2 * i + 1] += w * shapes.of[i].n * b.y;
    }
  }
}

void FiniteElement::edge_shape(double t, std::span<double> values) const {
  if (order_ == 1) {
    values[0] = 1 - t;
    values[1] = t;
    return;
  }
  values[0] = (1 - t) * (1 - 2 * t);
  values[1] = t * (2 * t - 1);
  values[2] = 4 * t * (1 - t);
}

void FiniteElement::rigid_values(const Cell&, std::span<model::RigidValue> values) const {
  for (model::RigidValue& value : values) value = {0, {}};
}

}  // namespace ashlar::elasticity
