#pragma once
// The exact planar arrangement of straight segments: where they cross, they share a point; where they
// overlap, they share a segment. Computed with exact arithmetic (CGAL), returned rounded to doubles.

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ashlar::geometry {

/// A straight input segment. `source` is the caller's own number for it.
struct InputSegment {
  Point from;
  Point to;
  Index source = -1;
};

struct Arrangement {
  struct Segment {
    Index from = -1, to = -1;     ///< points
    Index left = -1, right = -1;  ///< faces; face 0 is the unbounded one
    std::vector<Index> sources;   ///< input segments it lies on; negative −1−s: it runs against input s
  };
  /// A face: its outer ring (ccw, empty for face 0) and the rings inside it (holes cw; antennas go out and
  /// back). Ring entries are segment numbers, −1−s if traversed from `to` to `from`.
  struct Face {
    std::vector<Index> outer;
    std::vector<std::vector<Index>> inner;
    Point inside;  ///< a point strictly inside (not meaningful for face 0)
  };
  std::vector<Point> points;
  std::vector<Segment> segments;
  std::vector<Face> faces;
};

/// Points of different segments nearer than `snap` are made one before arranging (0: exact input).
Arrangement arrange(std::span<const InputSegment> segments, double snap = 0);

}  // namespace ashlar::geometry
