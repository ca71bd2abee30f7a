#pragma once
// Regions as users drew them, turned into straight named edges and a test of containment.

#include <set>

#include "mesh/domain.hpp"

namespace ashlar::mesh {

/// One straight edge of a region's shape, or of an operand of it.
struct FlatEdge {
  Point from, to;
  Index region = -1;
  std::string name;
  std::optional<EdgeArc> arc = {};
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

/// Arcs become chords (≤ chord, ≤ 7.5°); those of `faces` ("disc.rim") may be longer, as points of the mesh
/// in their middle are put on the arc later: by no more than a twentieth of `chord`, taken as the least
/// cell's size. Corners of other regions that lie on an arc become points of it. Reports rings that cross
/// themselves or have no area, wrong arcs, holes outside, split border names.
FlatRegions flatten(const std::vector<RegionShape>& regions, const std::set<std::string>& faces, double chord,
                    core::Mistakes& mistakes);
/// The borders of all `faces` joints.
std::set<std::string> faces_of(const std::vector<JointLine>& joints);

/// "(12.5, 3)": for messages.
std::string to_text(Point p);

}  // namespace ashlar::mesh
