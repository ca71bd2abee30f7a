#pragma once
// What is to be meshed: regions as faces of one exact planar arrangement, borders and joints as its segments.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "geometry/arrangement.hpp"
#include "geometry/shape.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/edge_arc.hpp"

namespace ashlar::mesh {

struct RegionShape {
  std::string name;
  geometry::Shape shape;
  core::Place place;
};

/// A joint along a polyline, along the common border of two regions, or where two bodies that are meshed
/// apart meet.
struct JointLine {
  std::string name;
  std::vector<Point> path;           ///< empty for a joint of another kind
  std::vector<std::string> between;  ///< two regions, or empty
  std::vector<std::string> faces;    ///< two borders of bodies that are meshed apart ("disc.rim"), or empty
  std::array<std::string, 2> sides = {"left",
                                      "right"};  ///< lip names: left of the path's direction, then right;
                                                 ///< otherwise: the first region's lip, the second's
  std::array<bool, 2> weld = {false, false};     ///< keep the first/last end closed where it could open
  core::Place place;
};

/// The planar partition that every mesh generator must respect exactly.
struct Domain {
  struct Segment {
    Index from = -1, to = -1;     ///< into `points`
    Index left = -1, right = -1;  ///< faces (-1: outside every region)
    std::vector<std::string>
        borders;       ///< names it carries: "rock.bottom"; a shared border bears both sides' names
    Index joint = -1;  ///< into `joints`
    bool joint_reversed = false;      ///< runs against the joint's direction
    double joint_position = 0;        ///< arc length of its earlier end along the joint [m]
    std::optional<EdgeArc> arc = {};  ///< the drawn arc that it is a chord of
  };
  struct Face {
    Index region = -1;         ///< into `regions`
    std::vector<Index> outer;  ///< as in Arrangement::Face
    std::vector<std::vector<Index>> inner;
    Point inside;
  };
  std::vector<std::string> regions;
  std::vector<JointLine> joints;
  std::vector<Point> points;
  std::vector<Segment> segments;
  std::vector<Face> faces;
  std::map<std::string, Point> named_points;  ///< probes: meshes may refine toward them
  double length = 0;                          ///< diagonal of the bounding box [m]
  double arc_chord = 0;                       ///< longest chord arcs were replaced by [m]

  /// Faces' rings as points, for tests of containment: outer first.
  std::vector<std::vector<Point>> rings(Index face) const;
  /// The face that contains p (borders count as inside of one of them); -1 if none.
  Index face_at(Point p) const;
  /// Of all faces [m²].
  double area() const;
};

/// Arranges regions and joints. Arcs are replaced by chords no longer than `chord` (turning at most 7.5°).
/// Mistakes found: self-crossing or empty region, regions that overlap, joint outside every region, joint
/// between regions that do not touch, joint of no length, two borders of one name in a region that is not
/// one. Joints that have `faces` are left alone: here no body is meshed apart.
Domain make_domain(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints,
                   double chord, core::Mistakes& mistakes);

}  // namespace ashlar::mesh
