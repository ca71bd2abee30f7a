#pragma once
// The shape of a region: rings of named edges, straight or circular, and set operations on shapes.

#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "geometry/point.hpp"

namespace ashlar::geometry {

/// A circular edge about `center`; the radius is the distance to the edge's first point.
struct Arc {
  Point center;
  bool counter_clockwise = true;
};

/// One edge of a ring: it starts at `start` and ends at the next edge's start.
struct ShapeEdge {
  Point start;
  std::string name;        ///< may be empty
  std::optional<Arc> arc;  ///< straight if absent
  core::Place place;
};

/// A region as the user drew it: an outer ring and holes, or an operation on other shapes.
struct Shape {
  enum class Kind { rings, difference, unite, intersection };
  Kind kind = Kind::rings;
  std::vector<std::vector<ShapeEdge>> rings;  ///< the first is the outer one; either sense of turning
  std::vector<Shape> operands;
  core::Place place;
};

/// An arc's points, both ends exact, chords no longer than `chord` and turning at most `turn` radians each.
std::vector<Point> points_on_arc(Point start, Point end, const Arc& arc, double chord, double turn);
/// The arc through three points; nothing if they are collinear.
std::optional<Arc> arc_through(Point start, Point middle, Point end);

}  // namespace ashlar::geometry
