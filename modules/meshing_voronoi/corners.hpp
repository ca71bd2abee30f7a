#pragma once
// The domain's points as corners: the segments that leave them, in order of angle, and the sites around them.

#include <vector>

#include "border.hpp"

namespace ashlar::meshing_voronoi {

/// One segment as it leaves a corner.
struct Spoke {
  Index segment = -1;
  bool outward = true;  ///< the segment starts here
  double angle = 0;     ///< direction
  double length = 0;    ///< of the segment
  Index face = -1;      ///< of the sector that begins here, counter-clockwise
  double sector = 0;    ///< its angle
  double half = 0;      ///< angle between the spoke and the sites beside it
};

struct Corner {
  std::vector<Spoke> spokes;
  bool smooth = false;  ///< two nearly straight spokes: an ordinary point of a curve
  double radius = 0;    ///< of its ball, unless smooth
};

/// Region of a face; -1 outside.
Index region_of(const mesh::Domain& domain, Index face);

/// Spokes, sectors and the half-angles of all points.
std::vector<Corner> find_corners(const mesh::Domain& domain);

/// Greatest radius that a ball at p on `segment` may have, if that is less than `enough`: it must keep off
/// segments that are not joined to its own, and stay in its half of the sectors at its segment's ends.
double room_at(const mesh::Domain& domain, const std::vector<Corner>& corners, Index segment, Point p,
               double enough);

/// Chooses the radius of every corner's ball.
void size_corners(const mesh::Domain& domain, const mesh::SizeField& sizes, std::vector<Corner>& corners);

}  // namespace ashlar::meshing_voronoi
