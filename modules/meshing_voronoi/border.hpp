#pragma once
// Sites that make a Voronoi diagram conform to the domain's segments: balls around points of the segments;
// where circles of neighbouring balls cross lies a pair of sites mirrored over the segment.

#include <array>
#include <vector>

#include "mesh/size_field.hpp"

namespace ashlar::meshing_voronoi {

using geometry::Index;
using geometry::Point;

/// A ball around a point of a segment; the point becomes a Voronoi vertex.
struct Ball {
  Point center;
  double radius = 0;
};

struct Site {
  Point at;
  Index face = -1;                                ///< -1: outside, its cell is thrown away
  std::array<Index, 4> balls = {-1, -1, -1, -1};  ///< whose circles it lies on
};

/// One piece of a domain segment between neighbouring balls, in the segment's direction.
struct Piece {
  Index from = -1, to = -1;     ///< balls
  Index left = -1, right = -1;  ///< faces
};

struct Border {
  std::vector<Ball> balls;
  std::vector<Site> sites;
  std::vector<Piece> pieces;
};

/// Places balls and sites along all segments. Where balls would be in each other's way, spots with a smaller
/// size are added to `sizes`. Throws InputError naming the place if that does not settle.
Border protect(const mesh::Domain& domain, mesh::SizeField& sizes);

}  // namespace ashlar::meshing_voronoi
