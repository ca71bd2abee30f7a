#include "elasticity/vem.hpp"

#include <cassert>

#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

using model::Cell;
using model::Material;
using model::Tangent;
using model::Voigt;

namespace {

Point displacement(std::span<const double> u, std::size_t i) {
  return {u[2 * i], u[2 * i + 1]};
}

/// ε(Πu) = Σ B_i u_i.
Voigt mean_strain(const CellShape& shape, std::span<const double> u) {
  Voigt strain{};
  for (std::size_t i = 0; i < shape.slope.size(); ++i) {
    const Point g = shape.slope[i], v = displacement(u, i);
    strain[0] += g.x * v.x;
    strain[1] += g.y * v.y;
    strain[2] += g.y * v.x + g.x * v.y;
  }
  return strain;
}

/// A row of X or W: (1, x − x̄) or (w, g).
struct Row {
  double mean = 0;
  Point slope;
};

double operator*(const Row& a, const Row& b) {
  return a.mean * b.mean + dot(a.slope, b.slope);
}

/// Rows of Y = diag(d) X − ½ W M with M = Xᵀ diag(d) X. With P = X Wᵀ this gives
/// (I−P)ᵀ diag(d) (I−P) = diag(d) − Y Wᵀ − W Yᵀ: six products an entry instead of matrix products.
void residual_rows(const CellShape& shape, std::span<const double> d, std::span<Row> rows) {
  const std::size_t n = d.size();
  double m = 0, mxx = 0, mxy = 0, myy = 0;
  Point mx;
  for (std::size_t i = 0; i < n; ++i) {
    const Point x = shape.offset[i];
    m += d[i];
    mx = mx + d[i] * x;
    mxx += d[i] * x.x * x.x;
    mxy += d[i] * x.x * x.y;
    myy += d[i] * x.y * x.y;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point x = shape.offset[i], g = shape.slope[i];
    const double w = shape.mean[i];
    rows[i].mean = d[i] - 0.5 * (m * w + dot(mx, g));
    rows[i].slope.x = d[i] * x.x - 0.5 * (mx.x * w + mxx * g.x + mxy * g.y);
    rows[i].slope.y = d[i] * x.y - 0.5 * (mx.y * w + mxy * g.x + myy * g.y);
  }
}

/// t (I−P)ᵀ diag(d)⊗T (I−P), entry by entry: at(i, k) t.
struct Residual {
  Residual(const CellShape& cell_shape, const Material& material, double thickness,
           const Stabilisation& stabilisation)
      : shape(cell_shape), d(cell_shape.slope.size()), y(d.size()) {
    t = stabilisation.weigh(shape, material, d);
    t = {thickness * t.xx, thickness * t.xy, thickness * t.yy};
    residual_rows(shape, d, y);
  }
  double at(std::size_t i, std::size_t k) const {
    const Row w_i{shape.mean[i], shape.slope[i]}, w_k{shape.mean[k], shape.slope[k]};
    return (i == k ? d[i] : 0) - y[i] * w_k - w_i * y[k];
  }

  const CellShape& shape;
  Scratch<double> d;
  Scratch<Row> y;
  Tensor2 t;
};

/// Columns of D B_k, times |E| t: (xx, yy, xy).
struct StressOf {
  std::array<double, 3> x, y;
};

StressOf stress_of(const Tangent& d, Point g, double volume) {
  StressOf s;
  for (std::size_t r = 0; r < 3; ++r) {
    s.x[r] = volume * (d[4 * r] * g.x + d[4 * r + 2] * g.y);
    s.y[r] = volume * (d[4 * r + 1] * g.y + d[4 * r + 2] * g.x);
  }
  return s;
}

}  // namespace

void VemElement::stiffness(const Cell& cell, const Material& material, std::span<double> packed) const {
  const std::size_t n = cell.corners.size();
  assert(packed.size() == n * (2 * n + 1));
  const CellShape shape(cell.corners);
  const Tangent tangent = material.respond({}, {}, {}).tangent;
  const Residual residual(shape, material, cell.thickness, *stabilisation_);
  const Tensor2& t = residual.t;
  Scratch<StressOf> stress(n);
  for (std::size_t k = 0; k < n; ++k)
    stress[k] = stress_of(tangent, shape.slope[k], shape.area * cell.thickness);

  double* row_x = packed.data();
  for (std::size_t i = 0; i < n; ++i) {
    double* row_y = row_x + 2 * i + 1;
    const Point g = shape.slope[i];
    for (std::size_t k = 0; k <= i; ++k) {
      const double s = residual.at(i, k);
      const StressOf& of = stress[k];
      row_x[2 * k] = g.x * of.x[0] + g.y * of.x[2] + s * t.xx;
      if (k < i) row_x[2 * k + 1] = g.x * of.y[0] + g.y * of.y[2] + s * t.xy;
      row_y[2 * k] = g.y * of.x[1] + g.x * of.x[2] + s * t.xy;
      row_y[2 * k + 1] = g.y * of.y[1] + g.x * of.y[2] + s * t.yy;
    }
    row_x = row_y + 2 * i + 2;
  }
}

void VemElement::add_internal_force(const Cell& cell, const Material& material, std::span<const double> u,
                                    std::span<double> force) const {
  const std::size_t n = cell.corners.size();
  assert(u.size() == 2 * n && force.size() == 2 * n);
  const CellShape shape(cell.corners);
  const Voigt stress = material.respond(mean_strain(shape, u), {}, {}).stress;
  Scratch<double> d(n);
  const Tensor2 t = stabilisation_->weigh(shape, material, d);

  Point mean, along_x, along_y;  // Πu = mean + along_x (x−x̄) + along_y (y−ȳ)
  for (std::size_t i = 0; i < n; ++i) {
    const Point v = displacement(u, i), g = shape.slope[i];
    mean = mean + shape.mean[i] * v;
    along_x = along_x + g.x * v;
    along_y = along_y + g.y * v;
  }
  Scratch<Point> s(n);  // d_j T (u − Πu)_j
  Point sum, sum_x, sum_y;
  for (std::size_t j = 0; j < n; ++j) {
    const Point x = shape.offset[j];
    s[j] = d[j] * (t * (displacement(u, j) - mean - x.x * along_x - x.y * along_y));
    sum = sum + s[j];
    sum_x = sum_x + x.x * s[j];
    sum_y = sum_y + x.y * s[j];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point g = shape.slope[i];
    const Point rest = s[i] - shape.mean[i] * sum - g.x * sum_x - g.y * sum_y;
    force[2 * i] += cell.thickness * (shape.area * (g.x * stress[0] + g.y * stress[2]) + rest.x);
    force[2 * i + 1] += cell.thickness * (shape.area * (g.y * stress[1] + g.x * stress[2]) + rest.y);
  }
}

void VemElement::add_body_force(const Cell& cell, Point b, std::span<double> force) const {
  assert(force.size() == 2 * cell.corners.size());
  // ∫ Πφ_i = |E| (Πφ_i)(centroid).
  const CellShape shape(cell.corners);
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const double weight = cell.thickness * shape.area * (shape.mean[i] + dot(shape.slope[i], shape.centroid));
    force[2 * i] += weight * b.x;
    force[2 * i + 1] += weight * b.y;
  }
}

void VemElement::integrate(const Cell& cell, model::IntegrationPoints& points) const {
  const CellShape shape(cell.corners);
  points.resize(1, dofs(cell.corners.size()));
  points.weight[0] = shape.area * cell.thickness;
  points.at[0] = geometry::centroid(cell.corners);
  const std::span<double> xx = points.row(0, 0), yy = points.row(0, 1), xy = points.row(0, 2);
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const Point g = shape.slope[i];
    xx[2 * i] = xy[2 * i + 1] = g.x;
    yy[2 * i + 1] = xy[2 * i] = g.y;
  }
}

void VemElement::add_stabilisation(const Cell& cell, const Material& material,
                                   std::span<double> packed) const {
  const CellShape shape(cell.corners);
  const Residual residual(shape, material, cell.thickness, *stabilisation_);
  double* row = packed.data();
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    double* row_y = row + 2 * i + 1;
    for (std::size_t k = 0; k <= i; ++k) {
      const double s = residual.at(i, k);
      row[2 * k] += s * residual.t.xx;
      if (k < i) row[2 * k + 1] += s * residual.t.xy;
      row_y[2 * k] += s * residual.t.xy;
      row_y[2 * k + 1] += s * residual.t.yy;
    }
    row = row_y + 2 * i + 2;
  }
}

void VemElement::edge_shape(double t, std::span<double> values) const {
  assert(values.size() == 2);
  values[0] = 1 - t;
  values[1] = t;
}

}  // namespace ashlar::elasticity
