#pragma once
// Mesh edges of borders and joints, before joints are opened.

#include "mesh/domain.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// A mesh edge on a joint, in the joint's direction.
struct JointEdge {
  Index joint = -1;
  Index edge = -1;
  Index from = -1, to = -1;
  double s_from = 0, s_to = 0;
};

/// What the domain's segments are in the mesh.
struct FollowedSegments {
  std::vector<JointEdge> joint_edges;
  std::vector<std::pair<Index, Index>> border_edges;  ///< domain segment, mesh edge
  std::vector<Index> missing;                         ///< segments that no chain of mesh edges follows
};

FollowedSegments follow_segments(const Domain& domain, const std::vector<Point>& points,
                                 const EdgeTable& edges, double tolerance);

/// Joints between two regions of a mesh that has no domain: their common mesh edges. Throws InputError if
/// there are none or a region is not there.
void add_joints_between_regions(const Domain& domain, const RawMesh& raw, const EdgeTable& edges,
                                std::vector<JointEdge>& joint_edges);

}  // namespace ashlar::mesh
