#include "elasticity/projection.hpp"

#include <cassert>
#include <cmath>

#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

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
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(size, moments + monomials(k - 2)), y = x;
  const EdgeRule rule = edge_rule(k);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const Point edge = corners[j] - corners[i];
    for (int g = 0; g <= k; ++g) {
      const int dof = g == 0 ? i : g == k ? j : n + i * (k - 1) + g - 1;
      const Point xi = (1 - rule.at[g]) * local[i] + rule.at[g] * local[j];
      const double w = rule.weight[g] / frame.area;
      for (int b = 0; b < size; ++b) {
        const double m = w * monomial(b, xi);
        x(b, dof) += m * edge.y;
        y(b, dof) -= m * edge.x;
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
  along_x = factor_.triangularView<Eigen::Lower>().solve(x);
  along_y = factor_.triangularView<Eigen::Lower>().solve(y);
}

void Projection::project_dofs(std::span<const Point> local) {
  const int n = static_cast<int>(local.size()), k = order_, size = monomials(k);
  Eigen::MatrixXd dofs(n * k + monomials(k - 2), size);
  const EdgeRule rule = edge_rule(k);
  for (int i = 0; i < n; ++i)
    for (int g = 0; g < k; ++g) {
      const Point xi = (1 - rule.at[g]) * local[i] + rule.at[g] * local[(i + 1) % n];
      for (int a = 0; a < size; ++a) dofs(g == 0 ? i : n + i * (k - 1) + g - 1, a) = monomial(a, xi);
    }
  for (int c = 0; c < monomials(k - 2); ++c)
    for (int a = 0; a < size; ++a) dofs(n * k + c, a) = mass_(a, c);
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(dofs).householderQ() *
                            Eigen::MatrixXd::Identity(dofs.rows(), size);
  rest = Eigen::MatrixXd::Identity(dofs.rows(), dofs.rows()) - q * q.transpose();
}

Eigen::VectorXd Projection::orthonormal(Point xi) const {
  Eigen::VectorXd values(monomials(order_ - 1));
  for (int b = 0; b < values.size(); ++b) values[b] = monomial(b, xi);
  return factor_.triangularView<Eigen::Lower>().solve(values);
}

}  // namespace ashlar::elasticity
