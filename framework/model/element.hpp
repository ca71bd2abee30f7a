#pragma once
// An element knows one cell: its operators from the cell's corners. No global numbering, no state. Dofs: (ux,
// uy) of the corners, then of the nodes of edge after edge, then of the cell's own nodes.
//
// The law is asked at integration points q: ε_q = B_q u, and
//   force = Σ_q w_q B_qᵀ σ_q + S u,   tangent = Σ_q w_q B_qᵀ D_q B_q + S,
// S: the stabilisation, a constant stiffness of what the strains at the points do not see (zero in finite
// elements).

#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/schema.hpp"
#include "geometry/point.hpp"
#include "model/material.hpp"

namespace ashlar::model {

using geometry::Point;

/// Nodes of the displacement on each entity.
struct NodeCounts {
  int per_point = 1, per_edge = 0, per_cell = 0;
};

/// One cell as its element sees it.
struct Cell {
  std::span<const Point> corners;  ///< counter-clockwise
  double thickness = 1;            ///< [m]
  bool axisymmetric = false;       ///< turned about x = 0; then `thickness` is 1
};

/// What an area stands for out of the plane [m]: the thickness, or the way around the axis.
inline double depth(double thickness, bool axisymmetric, Point at) {
  return axisymmetric ? 2 * std::numbers::pi * at.x : thickness;
}

/// The integration points of one cell. Kept by the caller from cell to cell, so that nothing is allocated.
class IntegrationPoints {
 public:
  void resize(int points, int dofs);
  int size() const { return static_cast<int>(weight.size()); }
  int dofs() const { return dofs_; }
  /// Row r of B_q (r: xx, yy, xy, zz), as long as the dofs.
  std::span<double> row(int q, int r) { return {b_.data() + offset(q, r), static_cast<std::size_t>(dofs_)}; }
  std::span<const double> row(int q, int r) const {
    return {b_.data() + offset(q, r), static_cast<std::size_t>(dofs_)};
  }
  Voigt strain(int q, std::span<const double> u) const;

  std::vector<double> weight;  ///< ∫ over the cell and its depth ≈ Σ weight[q] f(at[q]) [m³]
  std::vector<Point> at;

 private:
  std::size_t offset(int q, int r) const {
    return (static_cast<std::size_t>(q) * 4 + static_cast<std::size_t>(r)) * static_cast<std::size_t>(dofs_);
  }
  int dofs_ = 0;
  std::vector<double> b_;
};

/// What a rigid motion v(x) = a + θ × x gives a node: translation·a + θ × place.
struct RigidValue {
  double translation = 1;
  Point place;
};

class Element {
 public:
  virtual ~Element() = default;
  virtual NodeCounts nodes() const = 0;
  /// Order of the displacement's polynomial along an edge.
  virtual int order() const = 0;
  /// Why it cannot take a cell; empty if it can.
  virtual std::string refuses(const Cell& /*cell*/) const { return {}; }
  int dofs(std::size_t corners) const {
    const NodeCounts n = nodes();
    return 2 * (static_cast<int>(corners) * (n.per_point + n.per_edge) + n.per_cell);
  }

  /// Integration points of a cell.
  virtual int point_count(std::size_t corners) const = 0;
  virtual void integrate(const Cell& cell, IntegrationPoints& points) const = 0;
  /// packed += S, lower triangle row by row (0,0) (1,0) (1,1) …, scaled by the law's elastic moduli [N/m].
  virtual void add_stabilisation(const Cell& /*cell*/, const Material& /*law*/,
                                 std::span<double> /*packed*/) const {}
  /// Whether `add_stabilisation` adds anything.
  virtual bool stabilised() const { return false; }

  /// The packed stiffness and the force for the law's tangent at rest. By default from the points above; an
  /// element that has them in closed form overrides them.
  virtual void stiffness(const Cell& cell, const Material& law, std::span<double> packed) const;
  virtual void add_internal_force(const Cell& cell, const Material& law, std::span<const double> u,
                                  std::span<double> force) const;

  /// force += ∫ b·φ over the cell for a constant body force b [N/m³]: exact weights.
  virtual void add_body_force(const Cell& cell, Point b, std::span<double> force) const = 0;
  /// Values at t ∈ [0,1] of an edge's shape functions: its start, its end, then its own nodes in the cell's
  /// sense. `values` has order() + 1 entries.
  virtual void edge_shape(double t, std::span<double> values) const = 0;
  /// Place t ∈ (0, 1) of an edge's own node.
  virtual double edge_node(int node) const { return (node + 1.0) / (nodes().per_edge + 1); }
  /// What rigid motions give the cell's own nodes: `values` has nodes().per_cell entries.
  virtual void rigid_values(const Cell& /*cell*/, std::span<RigidValue> /*values*/) const {}
};

/// What a scene asks of its element besides its settings.
struct ElementRequest {
  int order = 1;
  Plane plane = Plane::strain;
  bool yielding = false;  ///< some law is nonlinear
};

/// A module registers an element as kind "element" with this signature.
using MakeElement = std::shared_ptr<const Element>(const core::Settings& settings,
                                                   const ElementRequest& request, core::Mistakes& mistakes);

/// packed += w Bᵀ D B of one integration point.
void add_tangent(const IntegrationPoints& points, int q, const Tangent& tangent, std::span<double> packed);
/// force += w Bᵀ σ of one integration point.
void add_stress(const IntegrationPoints& points, int q, const Voigt& stress, std::span<double> force);
/// force += A u, A given by its packed lower triangle.
void add_packed_product(std::span<const double> packed, std::span<const double> u, std::span<double> force);

}  // namespace ashlar::model
