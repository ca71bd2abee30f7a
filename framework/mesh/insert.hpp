#pragma once
// Hanging points in the border of a finished mesh.

#include <span>

#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// A place strictly inside an edge, `t` of the way from its first to its second point.
struct PointOnEdge {
  Index edge = -1;
  double t = 0;
};

/// Puts points on edges of the border; the edges' cells get them as corners. An edge keeps its number for the
/// part at its beginning; groups, arcs and lips of joints between bodies that are meshed apart follow. Places
/// on one edge must differ. Where the edge is a chord of a drawn arc, points go onto the arc if the cell
/// stays simple. Returns the new points' numbers in the order of `places`.
std::vector<Index> insert_points(Mesh& mesh, std::span<const PointOnEdge> places);

}  // namespace ashlar::mesh
