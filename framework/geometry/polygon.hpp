#pragma once
// Measures and tests of simple polygons given by their corners, counter-clockwise. Corners may be collinear.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/point.hpp"

namespace ashlar::geometry {

using Ring = std::vector<Point>;

/// ½ Σ x_i × x_{i+1}, about the first corner (so that far-away polygons keep their digits). Positive: ccw.
double signed_area(std::span<const Point> ring);
/// Centroid of the area.
Point centroid(std::span<const Point> ring);
/// Greatest distance between two corners.
double diameter(std::span<const Point> ring);
/// ∫ (x−c)^p (y−c)^q over the polygon for all p+q ≤ degree, ordered 1, x, y, x², xy, y², … Exact, from
/// edge integrals (Green, Gauss–Legendre of sufficient order).
std::vector<double> monomial_integrals(std::span<const Point> ring, Point center, int degree);
/// Point in polygon by winding number; points on the border count as inside.
bool contains(std::span<const Point> ring, Point p);
/// True if no two edges touch other than neighbours at their shared corner. Exact predicates.
bool is_simple(std::span<const Point> ring);
/// Indices (i, j) of the first two edges that cross or touch; {-1,-1} if the ring is simple.
std::pair<int, int> first_crossing(std::span<const Point> ring);
/// Distance from p to the segment a–b; `parameter` (if given) receives the nearest point's position in [0,
/// 1].
double distance_to_segment(Point p, Point a, Point b, double* parameter = nullptr);
/// Triangles (corner indices) of a simple polygon by ear clipping; skips zero-area ears of collinear corners.
std::vector<std::array<int, 3>> triangulate(std::span<const Point> ring);

}  // namespace ashlar::geometry
