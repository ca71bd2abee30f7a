#pragma once
// An element knows one cell: its operators from the cell's corners. No global numbering, no state; nothing is
// allocated for cells of up to 32 corners. Dofs: (ux, uy) of the corners, then edge nodes, then cell nodes.

#include <memory>
#include <span>

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
};

class Element {
 public:
  virtual ~Element() = default;
  virtual NodeCounts nodes() const = 0;
  int dofs(std::size_t corners) const {
    const NodeCounts n = nodes();
    return 2 * (static_cast<int>(corners) * (n.per_point + n.per_edge) + n.per_cell);
  }
  /// Lower triangle of the stiffness, row by row (0,0) (1,0) (1,1) …, for the law's tangent at rest [N/m].
  virtual void stiffness(const Cell& cell, const Material& material, std::span<double> packed) const = 0;
  /// force += K u. `force` and `u` have dofs(corners) entries.
  virtual void add_internal_force(const Cell& cell, const Material& material, std::span<const double> u,
                                  std::span<double> force) const = 0;
  /// force += ∫ b·φ over the cell for a constant body force b [N/m³]: exact weights.
  virtual void add_body_force(const Cell& cell, Point b, std::span<double> force) const = 0;
  /// Projected strain at a point of the cell (constant for order 1).
  virtual Voigt strain(const Cell& cell, std::span<const double> u, Point at) const = 0;
  /// Order of the displacement's polynomial along an edge.
  virtual int order() const = 0;
  /// Values at t ∈ [0,1] of an edge's shape functions: its start, its end, then its own nodes in the cell's
  /// sense. `values` has order() + 1 entries.
  virtual void edge_shape(double t, std::span<double> values) const = 0;
};

/// A module registers an element as kind "element" with this signature; `order` comes from the scene.
using MakeElement = std::shared_ptr<const Element>(const core::Settings& settings, int order,
                                                   core::Mistakes& mistakes);

}  // namespace ashlar::model
