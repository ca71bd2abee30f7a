#pragma once
// The four sides of a region, and the mesh points on them.

#include <array>
#include <vector>

#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::meshing_structured {

using geometry::Index;
using geometry::Point;

/// A side as a polyline of domain points. `at` is the share of the side's length before each point.
struct Side {
  std::vector<Index> points;
  std::vector<Index> segments;  ///< between successive points
  std::vector<double> at;
  double length = 0;
};

/// Bottom and top run along +x, left and right along +y, in the region's own sense of them.
struct Sides {
  Side bottom, right, top, left;
};

/// Throws InputError if the region has not exactly four corners.
Sides sides_of(const mesh::Domain& domain, Index region, const core::Place& place);

/// A mesh point on a side.
struct SidePoint {
  double at = 0;
  Index point = -1;
};

/// The mesh points on the domain's segments, shared by the regions on both sides.
class BorderPoints {
 public:
  BorderPoints(const mesh::Domain& domain, std::vector<Point>& points);
  /// Divides a side at these shares of its length. Points that are there already are taken if they are near.
  std::vector<SidePoint> divide(const Side& side, const std::vector<double>& shares);
  /// All mesh points on the side, both ends included, in order.
  std::vector<SidePoint> all_on(const Side& side);

 private:
  Index corner(Index domain_point);
  SidePoint make(const Side& side, double at);

  const mesh::Domain& domain_;
  std::vector<Point>& points_;
  std::vector<Index> corners_;                  // mesh points of domain points
  std::vector<std::vector<SidePoint>> inside_;  // of each segment: `at` from its `from`
};

}  // namespace ashlar::meshing_structured
