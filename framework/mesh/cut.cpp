#include "mesh/cut.hpp"

#include <algorithm>

#include "mesh/cutter.hpp"
#include "mesh/flatten.hpp"
#include "mesh/segment_points.hpp"

namespace ashlar::mesh {

namespace {

// The domain segments of a joint as connected polylines along its direction.
std::vector<std::vector<Point>> paths_of(const Domain& domain, Index joint) {
  std::vector<const Domain::Segment*> own;
  for (const auto& s : domain.segments) {
    if (s.joint == joint) own.push_back(&s);
  }
  std::sort(own.begin(), own.end(), [](auto a, auto b) { return a->joint_position < b->joint_position; });
  std::vector<std::vector<Point>> paths;
  Index end = -1;
  for (const auto* s : own) {
    const Index start = s->joint_reversed ? s->to : s->from;
    if (start != end) paths.push_back({domain.points[start]});
    end = s->joint_reversed ? s->from : s->to;
    paths.back().push_back(domain.points[end]);
  }
  return paths;
}

}  // namespace

void cut_along_joints(RawMesh& raw, const Domain& domain, const std::vector<Index>& joints,
                      double tolerance) {
  if (joints.empty()) return;
  Cutter cutter(raw, tolerance);
  const auto on_segments = points_on_segments(domain, raw.points, tolerance);
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const bool free = std::find(joints.begin(), joints.end(), domain.segments[s].joint) != joints.end();
    for (const auto& entry : on_segments[s]) {
      if (!free) cutter.fix(entry.point);
    }
  }
  for (const Index j : joints) {
    for (const auto& path : paths_of(domain, j)) {
      if (cutter.follow(path)) continue;
      const auto& joint = domain.joints[j];
      throw core::InputError(core::Mistake{
          joint.place,
          "the mesh cannot follow joint '" + joint.name + "' around " + to_text(cutter.failed_at()),
          "keep the joint inside the mesh, refine the mesh there, or use a mesh that conforms to joints"});
    }
  }
  cutter.finish();
}

}  // namespace ashlar::mesh
