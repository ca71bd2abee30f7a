#pragma once
// Opening of joints: points on them become one point for each sector of cells that joints separate.

#include "mesh/joint_edges.hpp"

namespace ashlar::mesh {

struct Copy {
  Index cell = -1;
  Index point = -1;  ///< the cell's corner that is replaced
  Index made = -1;   ///< by this one
};

/// The copies to make, ordered by point, then by the sectors' lowest cells; the first sector keeps the point.
/// Sectors of a point are cells joined by edges there that no joint follows. Where a joint's end is welded,
/// its edges there do not separate. New points are numbered from `points` on.
std::vector<Copy> open_joints(const Adjacency& cell_points, const EdgeTable& edges,
                              const std::vector<JointEdge>& joint_edges, const std::vector<JointLine>& joints,
                              Index points);

}  // namespace ashlar::mesh
