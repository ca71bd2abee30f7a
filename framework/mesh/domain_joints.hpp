#pragma once
// Joints in the making of a domain: their input segments, and the domain segments they own.

#include "mesh/domain.hpp"

namespace ashlar::mesh {

/// Where an input segment of the arrangement lies on its joint.
struct JointSource {
  Index input = -1;
  Index joint = -1;
  Point from;
  double position = 0;  ///< arc length of `from`
};

/// Appends the joints' polylines to `inputs`, numbered from `first` on.
std::vector<JointSource> joint_sources(const std::vector<JointLine>& joints, Index first,
                                       std::vector<geometry::InputSegment>& inputs, core::Mistakes& mistakes);

/// Marks the segments of joints that have a path. Outside every region, or along an outer border: mistakes.
void mark_path_joints(Domain& domain, const geometry::Arrangement& arrangement,
                      const std::vector<JointSource>& sources, core::Mistakes& mistakes);

/// Marks the common border of the two regions of each `between` joint, ordered with the first region on the
/// left.
void mark_border_joints(Domain& domain, core::Mistakes& mistakes);

}  // namespace ashlar::mesh
