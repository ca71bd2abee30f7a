#pragma once
// Merging of nearly equal points before an arrangement is computed.

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ashlar::geometry {

/// A straight piece of one or more input segments (−1−s: it runs against input s).
struct Piece {
  Point from;
  Point to;
  std::vector<Index> sources;
};

/// Makes end points nearer than `snap` one point (the first of them) and bends pieces that pass an end point
/// nearer than `snap` through it. Pieces shorter than `snap` vanish.
void snap_pieces(std::vector<Piece>& pieces, double snap);

/// Two of the points are nearer than `snap`.
bool has_close_points(std::span<const Point> points, double snap);

}  // namespace ashlar::geometry
