#include "model/element.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace ashlar::model {

void IntegrationPoints::resize(int points, int dofs) {
  dofs_ = dofs;
  weight.assign(static_cast<std::size_t>(points), 0.0);
  at.assign(static_cast<std::size_t>(points), {});
  b_.assign(static_cast<std::size_t>(points) * 4 * static_cast<std::size_t>(dofs), 0.0);
}

Voigt IntegrationPoints::strain(int q, std::span<const double> u) const {
  Voigt strain{};
  for (int r = 0; r < 4; ++r) {
    const std::span<const double> b = row(q, r);
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += b[i] * u[i];
    strain[static_cast<std::size_t>(r)] = sum;
  }
  return strain;
}

void add_tangent(const IntegrationPoints& points, int q, const Tangent& tangent, std::span<double> packed) {
  const auto n = static_cast<std::size_t>(points.dofs());
  assert(packed.size() == n * (n + 1) / 2);
  const double w = points.weight[static_cast<std::size_t>(q)];
  const std::array<std::span<const double>, 4> b{points.row(q, 0), points.row(q, 1), points.row(q, 2),
                                                 points.row(q, 3)};
  double* row = packed.data();
  for (std::size_t i = 0; i < n; row += ++i) {
    std::array<double, 4> left{};  // w Dᵀ b_i
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c < 4; ++c) left[c] += w * b[r][i] * tangent[4 * r + c];
    for (std::size_t k = 0; k <= i; ++k)
      row[k] += left[0] * b[0][k] + left[1] * b[1][k] + left[2] * b[2][k] + left[3] * b[3][k];
  }
}

void add_stress(const IntegrationPoints& points, int q, const Voigt& stress, std::span<double> force) {
  const double w = points.weight[static_cast<std::size_t>(q)];
  for (int r = 0; r < 4; ++r) {
    const std::span<const double> b = points.row(q, r);
    const double s = w * stress[static_cast<std::size_t>(r)];
    for (std::size_t i = 0; i < force.size(); ++i) force[i] += b[i] * s;
  }
}

void add_packed_product(std::span<const double> packed, std::span<const double> u, std::span<double> force) {
  const double* row = packed.data();
  for (std::size_t i = 0; i < u.size(); row += ++i) {
    double sum = row[i] * u[i];
    for (std::size_t k = 0; k < i; ++k) {
      sum += row[k] * u[k];
      force[k] += row[k] * u[i];
    }
    force[i] += sum;
  }
}

namespace {

/// Kept from cell to cell.
struct Work {
  IntegrationPoints points;
  std::vector<double> packed;
};

Work& work() {
  thread_local Work work;
  return work;
}

}  // namespace

void Element::stiffness(const Cell& cell, const Material& law, std::span<double> packed) const {
  IntegrationPoints& points = work().points;
  integrate(cell, points);
  std::fill(packed.begin(), packed.end(), 0.0);
  const Tangent tangent = law.respond({}, {}, {}).tangent;
  for (int q = 0; q < points.size(); ++q) add_tangent(points, q, tangent, packed);
  add_stabilisation(cell, law, packed);
}

void Element::add_internal_force(const Cell& cell, const Material& law, std::span<const double> u,
                                 std::span<double> force) const {
  auto& [points, packed] = work();
  integrate(cell, points);
  for (int q = 0; q < points.size(); ++q)
    add_stress(points, q, law.respond(points.strain(q, u), {}, {}).stress, force);
  if (!stabilised()) return;
  packed.assign(u.size() * (u.size() + 1) / 2, 0.0);
  add_stabilisation(cell, law, packed);
  add_packed_product(packed, u, force);
}

}  // namespace ashlar::model
