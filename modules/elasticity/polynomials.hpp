#pragma once
// Monomials of a cell's own coordinates ξ, in the order 1, ξ, η, ξ², ξη, η² …, and the nodes of its edges.

#include <array>
#include <span>

#include "geometry/point.hpp"
#include "model/element.hpp"

namespace ashlar::elasticity {

using geometry::Point;

/// Number of monomials of degree ≤ d.
constexpr int monomials(int d) {
  return (d + 1) * (d + 2) / 2;
}

/// Number of ξ^p η^q in the order above.
constexpr int number_of(int p, int q) {
  return (p + q) * (p + q + 1) / 2 + q;
}

struct Powers {
  int p, q;
};

inline constexpr int highest_degree = 16;

inline constexpr auto powers = [] {
  std::array<Powers, static_cast<std::size_t>(monomials(highest_degree))> all{};
  for (int d = 0; d <= highest_degree; ++d)
    for (int q = 0; q <= d; ++q) all[static_cast<std::size_t>(number_of(d - q, q))] = {d - q, q};
  return all;
}();

constexpr Powers powers_of(int m) {
  return powers[static_cast<std::size_t>(m)];
}

inline double monomial(int m, Point xi) {
  const auto [p, q] = powers_of(m);
  double v = 1;
  for (int i = 0; i < p; ++i) v *= xi.x;
  for (int i = 0; i < q; ++i) v *= xi.y;
  return v;
}

/// Nodes of an edge, ends included, and their weights: the Gauss–Lobatto rule with order + 1 points on [0,
/// 1], order 1 to 3.
struct EdgeRule {
  std::span<const double> at, weight;
};
EdgeRule edge_rule(int order);

/// Element::edge_shape and Element::rigid_values of virtual elements: nodes of the rule above, and means of
/// v m_γ for all γ of degree ≤ order − 2.
void virtual_edge_shape(int order, double t, std::span<double> values);
void virtual_rigid_values(std::span<const Point> corners, int order, std::span<model::RigidValue> values);

/// Lagrange's polynomials of the nodes of an edge at t; `values` in the nodes' order along the edge.
void lagrange(std::span<const double> nodes, double t, std::span<double> values);

/// ξ = L⁻¹ (x − c), c the centroid, L Lᵀ the second moments over the area: a cell of any aspect is round in
/// ξ.
struct Frame {
  explicit Frame(std::span<const Point> corners);
  Point to_local(Point x) const;
  Point to_global(Point xi) const;

  double area = 0;
  Point centre;
  double xx = 1, yx = 0, yy = 1;  ///< L, lower triangle
};

}  // namespace ashlar::elasticity
