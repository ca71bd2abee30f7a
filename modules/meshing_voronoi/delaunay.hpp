#pragma once
// Delaunay triangulation as plain arrays (CGAL stays in the .cpp).

#include <array>
#include <vector>

#include "geometry/point.hpp"

namespace ashlar::meshing_voronoi {

using geometry::Index;
using geometry::Point;

struct Triangle {
  std::array<Index, 3> sites;       ///< counter-clockwise
  std::array<Index, 3> neighbours;  ///< across the side opposite to site k; -1 on the hull
};

/// Triangulates distinct points; `order` is the order of insertion (neighbours in it should be near).
std::vector<Triangle> triangulate(const std::vector<Point>& points, const std::vector<Index>& order);

/// An order that follows a Hilbert curve.
std::vector<Index> curve_order(const std::vector<Point>& points);

Point circumcentre(Point a, Point b, Point c);

}  // namespace ashlar::meshing_voronoi
