#include "mesh/joint_edges.hpp"

#include <algorithm>

#include "mesh/chain.hpp"
#include "mesh/segment_points.hpp"

namespace ashlar::mesh {

namespace {

using core::InputError;
using core::Mistake;

// The chain of mesh edges through these points, if it is one and reaches both ends of the segment.
bool chain_of(const std::vector<PointOnSegment>& on, const Domain& domain, const Domain::Segment& segment,
              const std::vector<Point>& points, const EdgeTable& edges, double tolerance,
              std::vector<Index>& chain) {
  chain.clear();
  if (on.size() < 2) return false;
  if (geometry::distance(points[on.front().point], domain.points[segment.from]) > tolerance) return false;
  if (geometry::distance(points[on.back().point], domain.points[segment.to]) > tolerance) return false;
  for (std::size_t i = 0; i + 1 < on.size(); ++i) {
    chain.push_back(edges.find(on[i].point, on[i + 1].point));
    if (chain.back() < 0) return false;
  }
  return true;
}

// Arc length along the joint at each point, in proportion to the edges: it grows even over edges shorter than
// the tolerance that stand across the joint.
std::vector<double> positions_on(const std::vector<PointOnSegment>& on, const Domain::Segment& segment,
                                 const Domain& domain, const std::vector<Point>& points) {
  std::vector<double> sum(on.size(), 0.0);
  for (std::size_t k = 1; k < on.size(); ++k) {
    sum[k] = sum[k - 1] + geometry::distance(points[on[k - 1].point], points[on[k].point]);
  }
  const double length = geometry::distance(domain.points[segment.from], domain.points[segment.to]),
               total = sum.back();
  for (double& s : sum)
    s = segment.joint_position + length * ((segment.joint_reversed ? total - s : s) / total);
  return sum;
}

Index region_of(const RawMesh& raw, const JointLine& joint, const std::string& name) {
  const auto found = std::find(raw.regions.begin(), raw.regions.end(), name);
  if (found != raw.regions.end()) return static_cast<Index>(found - raw.regions.begin());
  throw InputError(Mistake{
      joint.place, "joint '" + joint.name + "' names region '" + name + "', which the mesh does not have",
      core::did_you_mean(name, raw.regions)});
}

}  // namespace

FollowedSegments follow_segments(const Domain& domain, const std::vector<Point>& points,
                                 const EdgeTable& edges, double tolerance) {
  FollowedSegments result;
  const auto on_segments = points_on_segments(domain, points, tolerance);
  std::vector<Index> chain;
  for (Index i = 0; i < static_cast<Index>(domain.segments.size()); ++i) {
    const auto& segment = domain.segments[i];
    const auto& on = on_segments[i];
    if (!chain_of(on, domain, segment, points, edges, tolerance, chain)) {
      result.missing.push_back(i);
      continue;
    }
    const auto position = positions_on(on, segment, domain, points);
    for (std::size_t k = 0; k < chain.size(); ++k) {
      result.border_edges.emplace_back(i, chain[k]);
      if (segment.joint < 0) continue;
      JointEdge edge{segment.joint, chain[k], on[k].point, on[k + 1].point, position[k], position[k + 1]};
      if (segment.joint_reversed) {
        std::swap(edge.from, edge.to);
        std::swap(edge.s_from, edge.s_to);
      }
      result.joint_edges.push_back(edge);
    }
  }
  std::stable_sort(result.joint_edges.begin(), result.joint_edges.end(), [](const auto& a, const auto& b) {
    return std::pair(a.joint, a.s_from) < std::pair(b.joint, b.s_from);
  });
  return result;
}

void add_joints_between_regions(const Domain& domain, const RawMesh& raw, const EdgeTable& edges,
                                std::vector<JointEdge>& joint_edges) {
  for (Index j = 0; j < static_cast<Index>(domain.joints.size()); ++j) {
    const JointLine& joint = domain.joints[j];
    if (joint.between.size() != 2) continue;
    const Index first = region_of(raw, joint, joint.between[0]),
                second = region_of(raw, joint, joint.between[1]);
    std::vector<Link> links;
    for (Index e = 0; e < edges.size(); ++e) {
      if (edges.cells[e][1] < 0) continue;
      const Index left = raw.cell_region[edges.cells[e][0]], right = raw.cell_region[edges.cells[e][1]];
      const auto [a, b] = edges.points[e];
      if (left == first && right == second) links.push_back({e, a, b});
      if (left == second && right == first) links.push_back({e, b, a});
    }
    if (links.empty() || first == second) {
      throw InputError(Mistake{joint.place,
                               "regions '" + joint.between[0] + "' and '" + joint.between[1] +
                                   "' of joint '" + joint.name + "' have no common border in the mesh",
                               "they must share the points of their border"});
    }
    double s = 0;
    for (const Link& link : chained(std::move(links), raw.points)) {
      const double length = geometry::distance(raw.points[link.start], raw.points[link.end]);
      joint_edges.push_back({j, link.number, link.start, link.end, s, s + length});
      s += length;
    }
  }
}

}  // namespace ashlar::mesh
