#include "elasticity/projection.hpp"

#include <array>
#include <cassert>

#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

namespace {

/// All monomials of degree ≤ 3 at ξ.
std::array<double, most_displacements> monomials_at(Point xi) {
  const double xx = xi.x * xi.x, xy = xi.x * xi.y, yy = xi.y * xi.y;
  return {1, xi.x, xi.y, xx, xy, yy, xx * xi.x, xx * xi.y, xi.x * yy, yy * xi.y};
}

/// rows = lower⁻¹ rows.
template <class Matrix>
void solve_lower(const double* lower, Eigen::Index stride, Matrix& rows) {
  for (Eigen::Index column = 0; column < rows.cols(); ++column) {
    double* x = &rows(0, column);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      for (Eigen::Index j = 0; j < i; ++j) x[i] -= lower[j * stride + i] * x[j];
      x[i] /= lower[i * stride + i];
    }
  }
}

/// Makes the rows orthonormal: Gram and Schmidt, each row twice, which is exact to round-off.
template <class Matrix>
void orthonormalise_rows(Matrix& rows) {
  std::array<double, most_displacements> share{};
  for (Eigen::Index a = 0; a < rows.rows(); ++a) {
    for (int again = 0; again < 2; ++again) {
      share.fill(0);
      for (Eigen::Index j = 0; j < rows.cols(); ++j) {
        const double* column = &rows(0, j);
        for (Eigen::Index b = 0; b < a; ++b) share[static_cast<std::size_t>(b)] += column[b] * column[a];
      }
      for (Eigen::Index j = 0; j < rows.cols(); ++j) {
        double* column = &rows(0, j);
        for (Eigen::Index b = 0; b < a; ++b) column[a] -= share[static_cast<std::size_t>(b)] * column[b];
      }
    }
    rows.row(a) /= rows.row(a).norm();
  }
}

}  // namespace

Projection::Projection(std::span<const Point> corners, int order) : frame(corners), order_(order) {
  std::vector<Point> local(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) local[i] = frame.to_local(corners[i]);
  const std::vector<double> integrals = geometry::monomial_integrals(local, {}, 2 * order - 2);
  mass_.resize(monomials(order), monomials(order - 1));
  for (int a = 0; a < mass_.rows(); ++a)
    for (int b = 0; b < mass_.cols(); ++b) {
      const int p = powers_of(a).p + powers_of(b).p, q = powers_of(a).q + powers_of(b).q;
      mass_(a, b) = p + q <= 2 * order - 2 ? integrals[number_of(p, q)] / integrals[0] : 0;
    }
  factor_ = mass_.topRows(monomials(order - 1)).llt().matrixL();
  project_gradient(local, corners);
  project_dofs(local);
}

void Projection::project_gradient(std::span<const Point> local, std::span<const Point> corners) {
  const int n = static_cast<int>(corners.size()), k = order_, size = monomials(k - 1);
  const int moments = n * k;  // where they begin among the scalar dofs
  auto &x = along_x, &y = along_y;
  x.setZero(size, moments + monomials(k - 2));
  y.setZero(size, moments + monomials(k - 2));
  const EdgeRule rule = edge_rule(k);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const Point edge = corners[j] - corners[i];
    for (int g = 0; g <= k; ++g) {
      const int dof = g == 0 ? i : g == k ? j : n + i * (k - 1) + g - 1;
      const Point xi = (1 - rule.at[g]) * local[i] + rule.at[g] * local[j];
      const double w = rule.weight[g] / frame.area;
      const auto m = monomials_at(xi);
      for (int b = 0; b < size; ++b) {
        x(b, dof) += w * m[static_cast<std::size_t>(b)] * edge.y;
        y(b, dof) -= w * m[static_cast<std::size_t>(b)] * edge.x;
      }
    }
  }
  // ∂_x = 1/L_xx ∂_ξ − L_yx/(L_xx L_yy) ∂_η, ∂_y = 1/L_yy ∂_η; the mean of v m_γ is a dof.
  for (int b = 1; b < size; ++b) {
    const auto [p, q] = powers_of(b);
    if (p > 0) x(b, moments + number_of(p - 1, q)) -= p / frame.xx;
    if (q > 0) {
      x(b, moments + number_of(p, q - 1)) += q * frame.yx / (frame.xx * frame.yy);
      y(b, moments + number_of(p, q - 1)) -= q / frame.yy;
    }
  }
  solve_lower(factor_.data(), factor_.rows(), x);
  solve_lower(factor_.data(), factor_.rows(), y);
}

void Projection::project_dofs(std::span<const Point> local) {
  const int n = static_cast<int>(local.size()), k = order_, size = monomials(k);
  range.resize(size, n * k + monomials(k - 2));
  const EdgeRule rule = edge_rule(k);
  for (int i = 0; i < n; ++i)
    for (int g = 0; g < k; ++g) {
      const Point xi = (1 - rule.at[g]) * local[i] + rule.at[g] * local[(i + 1) % n];
      const auto m = monomials_at(xi);
      const int dof = g == 0 ? i : n + i * (k - 1) + g - 1;
      for (int a = 0; a < size; ++a) range(a, dof) = m[static_cast<std::size_t>(a)];
    }
  for (int c = 0; c < monomials(k - 2); ++c)
    for (int a = 0; a < size; ++a) range(a, n * k + c) = mass_(a, c);
  orthonormalise_rows(range);
}

Eigen::VectorXd Projection::orthonormal(Point xi) const {
  Eigen::VectorXd values(monomials(order_ - 1));
  for (int b = 0; b < values.size(); ++b) values[b] = monomial(b, xi);
  return factor_.triangularView<Eigen::Lower>().solve(values);
}

}  // namespace ashlar::elasticity
