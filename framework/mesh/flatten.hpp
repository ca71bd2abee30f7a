#pragma once
// Regions as users drew them, turned into straight named edges and a test of containment.

#include "mesh/domain.hpp"

namespace ashlar::mesh {

/// One straight edge of a region's shape, or of an operand of it.
struct FlatEdge {
  Point from, to;
  Index region = -1;
  std::string name;
};

/// A shape with its arcs replaced by chords.
struct FlatShape {
  geometry::Shape::Kind kind = geometry::Shape::Kind::rings;
  std::vector<std::vector<Point>> rings;
  std::vector<FlatShape> operands;
  bool contains(Point p) const;
};

struct FlatRegions {
  std::vector<FlatShape> shapes;  ///< one a region
  std::vector<FlatEdge> edges;
  double length = 0;  ///< diagonal of the bounding box
};

/// Arcs become chords (≤ chord, ≤ 7.5°); corners of other regions that lie on an arc become points of it.
/// Reports rings that cross themselves or have no area, wrong arcs, holes outside, split border names.
FlatRegions flatten(const std::vector<RegionShape>& regions, double chord, core::Mistakes& mistakes);

/// "(12.5, 3)": for messages.
std::string to_text(Point p);

}  // namespace ashlar::mesh
