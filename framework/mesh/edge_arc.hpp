#pragma once
// Arcs of drawn shapes that straight mesh edges stand for.

#include "geometry/point.hpp"

namespace ashlar::mesh {

/// The circle that a straight edge is a chord of.
struct EdgeArc {
  geometry::Point center;
  double radius = 0;              ///< [m]
  bool counter_clockwise = true;  ///< from the edge's first point to its second

  /// The point of the circle nearest to p.
  geometry::Point nearest(geometry::Point p) const {
    const geometry::Point out = p - center;
    return center + (radius / norm(out)) * out;
  }
};

}  // namespace ashlar::mesh
