#include "elasticity/strain_projection.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "elasticity/triangle_rule.hpp"
#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::elasticity {

namespace {

/// Degree for which the rule must be exact.
int exactness(int order, int degree, bool axisymmetric) {
  return degree + order - 1 + (axisymmetric ? 1 : 0);
}

/// Points in each of so many triangles: enough for the degree, and to tell the polynomials apart.
int points_each(int triangles, int exact, int degree) {
  const double least = triangles == 1 ? monomials(degree) : 1.5 * monomials(degree);
  if (exact <= 2 && 3 * triangles >= least) return 3;
  if (exact <= 4 && 6 * triangles >= least) return 6;
  if (exact <= 6 && 12 * triangles >= least) return 12;
  int n = 4;
  while (2 * n - 2 < exact || n * n * triangles < least) ++n;
  return n * n;
}

std::array<Point, 3> triangle(std::span<const Point> corners, int a, int b, int c) {
  return {corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)],
          corners[static_cast<std::size_t>(c)]};
}

/// Quadrilaterals of order 1: four points that turn with the cell have its moments up to degree 2.
bool four_points(std::size_t corners, int order, int degree) {
  return order == 1 && corners == 4 && degree == 1;
}

}  // namespace

int projection_points(std::size_t corners, int order, int degree, bool axisymmetric) {
  if (order == 1 && degree == 0) return 1;
  if (four_points(corners, order, degree)) return 4;
  const int exact = exactness(order, degree, axisymmetric), triangles = static_cast<int>(corners) - 2;
  int most = 0;
  for (int fat = 1; fat <= triangles; ++fat)
    most =
        std::max(most, fat * points_each(fat, exact, degree) + (triangles - fat) * points_each(1, exact, 0));
  return most;
}

// Strains have 3 monomials(l) coefficients; what they must see is all dofs less three rigid motions. Regular
// cells hide some deformations by their symmetry: a quarter to spare, and more for corners alone.
int seeing_degree(std::size_t corners, int order) {
  if (corners == 3 && order == 1) return 0;
  const int n = static_cast<int>(corners), needed = 2 * (n * order + monomials(order - 2)) - 3;
  int degree = order;
  while (3 * monomials(degree) < (order == 1 ? 1.4 : 1.25) * needed) ++degree;
  return degree;
}

StrainProjection::StrainProjection(const model::Cell& cell, int order, int degree)
    : cell_(cell), order_(order), degree_(degree), frame_(cell.corners) {
  assert(order + degree <= highest_degree);
  for (const Point corner : cell.corners) local_.push_back(frame_.to_local(corner));
  integral_ = geometry::monomial_integrals(local_, {}, order + std::max(degree, 1));
  place_points();
  orthonormalise();
  project_values();
  find_moments();
  gradient_ = project_gradient();
}

int StrainProjection::scalar_dofs() const {
  return static_cast<int>(local_.size()) * order_ + monomials(order_ - 2);
}

void StrainProjection::place_points() {
  const std::size_t n = cell_.corners.size();
  if (order_ == 1 && degree_ == 0) {
    at_.push_back({frame_.centre, {}, frame_.area});
    return;
  }
  if (four_points(n, order_, degree_)) {
    // The square's four corners in ξ, turned towards the cell's: arg Σ ξ⁴ knows no first corner.
    double re = 0, im = 0;
    for (const Point xi : local_) {
      const double angle = 4 * std::atan2(xi.y, xi.x), r = dot(xi, xi);
      re += r * std::cos(angle);
      im += r * std::sin(angle);
    }
    const double turn = std::atan2(im, re) / 4;
    for (int q = 0; q < 4; ++q) {
      const double angle = turn + q * std::numbers::pi / 2;
      const Point xi{std::numbers::sqrt2 * std::cos(angle), std::numbers::sqrt2 * std::sin(angle)};
      at_.push_back({frame_.to_global(xi), xi, frame_.area / 4});
    }
    return;
  }
  const auto triangles = geometry::triangulate(cell_.corners);
  std::vector<double> areas;
  int fat = 0;  // slivers along short edges tell no polynomials apart
  for (const auto& [a, b, c] : triangles) {
    areas.push_back(geometry::signed_area(triangle(cell_.corners, a, b, c)));
    fat += areas.back() > 0.01 * frame_.area;
  }
  const int exact = exactness(order_, degree_, cell_.axisymmetric);
  const std::vector<TrianglePoint> rule = triangle_rule(points_each(fat, exact, degree_)),
                                   thin = triangle_rule(points_each(1, exact, 0));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const std::array<Point, 3> corners = triangle(cell_.corners, a, b, c);
    const double area = areas[t];
    for (const TrianglePoint& p : area > 0.01 * frame_.area ? rule : thin) {
      const Point x = p.a * corners[0] + p.b * corners[1] + (1 - p.a - p.b) * corners[2];
      at_.push_back({x, frame_.to_local(x), p.weight * area});
    }
  }
}

double StrainProjection::mean_product(int a, int b) const {
  const auto [p, q] = powers_of(a);
  const auto [r, s] = powers_of(b);
  return integral_[static_cast<std::size_t>(number_of(p + r, q + s))] / integral_[0];
}

// √w m_β(ξ_q) = basis · factorᵀ, basis orthonormal columns: Householder.
void StrainProjection::orthonormalise() {
  const auto count = static_cast<Eigen::Index>(at_.size());
  const int size = monomials(degree_);
  Eigen::MatrixXd values(count, size);
  for (Eigen::Index q = 0; q < count; ++q) {
    const At& at = at_[static_cast<std::size_t>(q)];
    const double root = std::sqrt(std::max(weight(at), 0.0));
    for (int b = 0; b < size; ++b) values(q, b) = root * monomial(b, at.xi);
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(values);
  basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(count, size);
  factor_ = qr.matrixQR().topRows(size).transpose();
}

// Least squares of the dofs: nodes on the edges, and means of v m_γ.
void StrainProjection::project_values() {
  const int n = static_cast<int>(local_.size()), k = order_, size = monomials(k), own = monomials(k - 2);
  dofs_.resize(scalar_dofs(), size);
  const EdgeRule rule = edge_rule(k);
  for (int i = 0; i < n; ++i)
    for (int g = 0; g < k; ++g) {
      const double t = rule.at[static_cast<std::size_t>(g)];
      const Point xi =
          (1 - t) * local_[static_cast<std::size_t>(i)] + t * local_[static_cast<std::size_t>((i + 1) % n)];
      for (int a = 0; a < size; ++a) dofs_(g == 0 ? i : n + i * (k - 1) + g - 1, a) = monomial(a, xi);
    }
  for (int c = 0; c < own; ++c)
    for (int a = 0; a < size; ++a) dofs_(n * k + c, a) = mean_product(a, c);
  value_ = Eigen::HouseholderQR<Eigen::MatrixXd>(dofs_).solve(
      Eigen::MatrixXd::Identity(scalar_dofs(), scalar_dofs()));
}

void StrainProjection::find_moments() {
  const int known = monomials(order_ - 2), size = monomials(std::max(degree_, 1));
  moment_ = Eigen::MatrixXd::Zero(size, scalar_dofs());
  const int n = static_cast<int>(local_.size());
  for (int c = 0; c < known; ++c) moment_(c, n * order_ + c) = frame_.area;
  Eigen::MatrixXd mass(size - known, monomials(order_));
  for (int c = known; c < size; ++c)
    for (int a = 0; a < mass.cols(); ++a) mass(c - known, a) = frame_.area * mean_product(a, c);
  moment_.bottomRows(size - known) = mass * value_;
}

// ∮ ω v m_β n_d: Gauss points, as m_β may be of any degree.
void StrainProjection::add_border(Gradient& g) const {
  const int n = static_cast<int>(local_.size()), k = order_;
  const EdgeRule nodes = edge_rule(k);
  const geometry::Rule& rule = geometry::gauss_legendre(k + degree_ + (cell_.axisymmetric ? 1 : 0));
  std::array<double, 4> shape{};
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const Point start = cell_.corners[static_cast<std::size_t>(i)];
    const Point edge = cell_.corners[static_cast<std::size_t>(j)] - start;
    for (std::size_t p = 0; p < rule.at.size(); ++p) {
      const Point at = start + rule.at[p] * edge, xi = frame_.to_local(at);
      const double w = rule.weight[p] * depth(at);
      lagrange(nodes.at, rule.at[p], shape);
      for (int b = 0; b < g.x.rows(); ++b) {
        const double m = w * monomial(b, xi);
        for (int e = 0; e <= k; ++e) {
          const int dof = e == 0 ? i : e == k ? j : n + i * (k - 1) + e - 1;
          g.x(b, dof) += m * shape[static_cast<std::size_t>(e)] * edge.y;
          g.y(b, dof) -= m * shape[static_cast<std::size_t>(e)] * edge.x;
        }
      }
    }
  }
}

// − ∫ v ∂_d(ω m_β): ω is constant, or 2π (c_x + L_xx ξ). ∂_x = 1/L_xx ∂_ξ − L_yx/(L_xx L_yy) ∂_η, ∂_y =
// 1/L_yy ∂_η.
void StrainProjection::add_inside(Gradient& g) const {
  const double turn = 2 * std::numbers::pi;
  const auto subtract = [&](Eigen::MatrixXd& from, int b, double factor, int p, int q) {
    if (!cell_.axisymmetric)
      from.row(b) -= factor * cell_.thickness * moment_.row(number_of(p, q));
    else
      from.row(b) -=
          factor * turn *
          (frame_.centre.x * moment_.row(number_of(p, q)) + frame_.xx * moment_.row(number_of(p + 1, q)));
  };
  for (int b = 0; b < g.x.rows(); ++b) {
    const auto [p, q] = powers_of(b);
    if (p > 0) subtract(g.x, b, p / frame_.xx, p - 1, q);
    if (q > 0) subtract(g.x, b, -q * frame_.yx / (frame_.xx * frame_.yy), p, q - 1);
    if (q > 0) subtract(g.y, b, q / frame_.yy, p, q - 1);
    if (!cell_.axisymmetric) continue;
    g.around.row(b) = turn * moment_.row(b);
    g.x.row(b) -= turn * moment_.row(b);
  }
}

StrainProjection::Gradient StrainProjection::project_gradient() const {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(monomials(degree_), scalar_dofs());
  Gradient g{none, none, none};
  add_border(g);
  add_inside(g);
  const auto lower = factor_.triangularView<Eigen::Lower>();
  return {lower.solve(g.x), lower.solve(g.y), lower.solve(g.around)};
}

void StrainProjection::fill(model::IntegrationPoints& points) const {
  const std::size_t corners = local_.size();
  points.resize(projection_points(corners, order_, degree_, cell_.axisymmetric), 2 * scalar_dofs());
  const int low = monomials(order_ - 1);
  // Too-high part of the volume strain, from u_x and u_y.
  Eigen::MatrixXd high_x = gradient_.x + gradient_.around, high_y = gradient_.y;
  high_x.topRows(low).setZero();
  high_y.topRows(low).setZero();
  for (std::size_t q = 0; q < at_.size(); ++q) {
    const double w = weight(at_[q]);
    points.at[q] = at_[q].x;
    if (w <= 0) continue;
    points.weight[q] = w;
    const Eigen::RowVectorXd psi = basis_.row(static_cast<Eigen::Index>(q)) / std::sqrt(w);
    const Eigen::RowVectorXd x = psi * gradient_.x, y = psi * gradient_.y, turn = psi * gradient_.around;
    const Eigen::RowVectorXd hx = psi * high_x / 3, hy = psi * high_y / 3;
    const int at = static_cast<int>(q);
    const std::span<double> xx = points.row(at, 0), yy = points.row(at, 1), xy = points.row(at, 2),
                            zz = points.row(at, 3);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const auto ux = static_cast<std::size_t>(2 * i), uy = ux + 1;
      xx[ux] = x[i] - hx[i];
      xx[uy] = -hy[i];
      yy[ux] = -hx[i];
      yy[uy] = y[i] - hy[i];
      xy[ux] = y[i];
      xy[uy] = x[i];
      zz[ux] = turn[i] - hx[i];
      zz[uy] = -hy[i];
    }
  }
  // Rules shorter than the longest: the last points weigh nothing.
  for (std::size_t q = at_.size(); q < points.at.size(); ++q) points.at[q] = frame_.centre;
}

double StrainProjection::least_seen() const {
  assert(!cell_.axisymmetric);
  model::IntegrationPoints points;
  fill(points);
  const Eigen::Index size = 2 * scalar_dofs();
  Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(size, size);
  for (int q = 0; q < points.size(); ++q)
    for (int r = 0; r < 4; ++r) {
      const Eigen::Map<const Eigen::VectorXd> b(points.row(q, r).data(), size);
      seen += points.weight[static_cast<std::size_t>(q)] / cell_.thickness * (r == 2 ? 0.5 : 1) * b *
              b.transpose();
    }
  const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(scalar_dofs(), scalar_dofs()) - dofs_ * value_;
  const Eigen::MatrixXd left = rest.transpose() * rest;
  Eigen::MatrixXd all = seen;
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = i % 2; j < size; j += 2) all(i, j) += left(i / 2, j / 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(all);
  const Eigen::MatrixXd to_unit = modes.eigenvectors().rightCols(size - 3) *
                                  modes.eigenvalues().tail(size - 3).cwiseSqrt().cwiseInverse().asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(to_unit.transpose() * seen * to_unit)
      .eigenvalues()[0];
}

void StrainProjection::add_body_force(Point b, std::span<double> force) const {
  const double turn = 2 * std::numbers::pi;
  for (int i = 0; i < scalar_dofs(); ++i) {
    const double volume = cell_.axisymmetric
                              ? turn * (frame_.centre.x * moment_(0, i) + frame_.xx * moment_(1, i))
                              : cell_.thickness * moment_(0, i);
    const std::size_t x = 2 * static_cast<std::size_t>(i);
    force[x] += volume * b.x;
    force[x + 1] += volume * b.y;
  }
}

}  // namespace ashlar::elasticity
