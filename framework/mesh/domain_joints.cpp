#include "mesh/domain_joints.hpp"

#include <algorithm>
#include <set>

#include "mesh/chain.hpp"
#include "mesh/flatten.hpp"

namespace ashlar::mesh {

namespace {

// Gives a segment to a joint unless another one (or the same one, coming back) has it.
bool claim(Domain& domain, Index segment, Index joint, std::set<Index>& said, core::Mistakes& mistakes) {
  auto& s = domain.segments[segment];
  if (s.joint < 0) {
    s.joint = joint;
    return true;
  }
  if (said.insert(joint).second) {
    const auto& line = domain.joints[joint];
    const std::string where =
        " from " + to_text(domain.points[s.from]) + " to " + to_text(domain.points[s.to]);
    mistakes.add(line.place, s.joint == joint ? "joint '" + line.name + "' runs twice along the line" + where
                                              : "joints '" + domain.joints[s.joint].name + "' and '" +
                                                    line.name + "' lie on the same line" + where);
  }
  return false;
}

void check_has_regions(const Domain& domain, const Domain::Segment& s, std::set<Index>& said,
                       core::Mistakes& mistakes) {
  if (domain.faces.empty() || (s.left >= 0 && s.right >= 0) || !said.insert(s.joint).second) return;
  const auto& joint = domain.joints[s.joint];
  const std::string where = " from " + to_text(domain.points[s.from]) + " to " + to_text(domain.points[s.to]);
  if (s.left < 0 && s.right < 0) {
    mistakes.add(joint.place, "joint '" + joint.name + "' lies outside every region" + where,
                 "end the path on the surface");
  } else {
    mistakes.add(joint.place, "joint '" + joint.name + "' runs along an outer border" + where,
                 "a joint needs a region on both sides");
  }
}

std::vector<Link> common_border(const Domain& domain, Index first, Index second) {
  auto region = [&](Index face) { return face < 0 ? -1 : domain.faces[face].region; };
  std::vector<Link> links;
  for (Index i = 0; i < static_cast<Index>(domain.segments.size()); ++i) {
    const auto& s = domain.segments[i];
    if (region(s.left) == first && region(s.right) == second) links.push_back({i, s.from, s.to});
    if (region(s.left) == second && region(s.right) == first) links.push_back({i, s.to, s.from});
  }
  return chained(std::move(links), domain.points);
}

Index region_number(const Domain& domain, const JointLine& joint, const std::string& name,
                    core::Mistakes& mistakes) {
  const auto found = std::find(domain.regions.begin(), domain.regions.end(), name);
  if (found != domain.regions.end()) return static_cast<Index>(found - domain.regions.begin());
  mistakes.add(joint.place, "joint '" + joint.name + "' names region '" + name + "', which does not exist",
               core::did_you_mean(name, domain.regions));
  return -1;
}

}  // namespace

std::vector<JointSource> joint_sources(const std::vector<JointLine>& joints, Index first,
                                       std::vector<geometry::InputSegment>& inputs,
                                       core::Mistakes& mistakes) {
  std::vector<JointSource> sources;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto& joint = joints[j];
    if (!joint.between.empty() || !joint.faces.empty()) continue;
    const bool finite = std::all_of(joint.path.begin(), joint.path.end(),
                                    [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); });
    if (!finite) {
      mistakes.add(joint.place, "the path of joint '" + joint.name + "' has a point that is not finite");
      continue;
    }
    double position = 0;
    for (std::size_t i = 0; i + 1 < joint.path.size(); ++i) {
      const Point a = joint.path[i], b = joint.path[i + 1];
      if (a == b) continue;
      const Index input = first + static_cast<Index>(sources.size());
      sources.push_back({input, static_cast<Index>(j), a, position});
      inputs.push_back({a, b, input});
      position += geometry::distance(a, b);
    }
    if (!(position > 0)) {
      mistakes.add(joint.place, "joint '" + joint.name + "' has no length",
                   "give a path of two different points or more");
    }
  }
  return sources;
}

void mark_path_joints(Domain& domain, const geometry::Arrangement& arrangement,
                      const std::vector<JointSource>& sources, core::Mistakes& mistakes) {
  if (sources.empty()) return;
  std::set<Index> doubled, outside;
  for (Index i = 0; i < static_cast<Index>(domain.segments.size()); ++i) {
    for (const Index signed_source : arrangement.segments[i].sources) {
      const bool reversed = signed_source < 0;
      const Index input = reversed ? -1 - signed_source : signed_source;
      if (input < sources.front().input) continue;
      const JointSource& source = sources[input - sources.front().input];
      if (!claim(domain, i, source.joint, doubled, mistakes)) continue;
      auto& s = domain.segments[i];
      s.joint_reversed = reversed;
      s.joint_position =
          source.position + geometry::distance(source.from, domain.points[reversed ? s.to : s.from]);
      check_has_regions(domain, s, outside, mistakes);
    }
  }
}

void mark_border_joints(Domain& domain, core::Mistakes& mistakes) {
  std::set<Index> doubled;
  for (Index j = 0; j < static_cast<Index>(domain.joints.size()); ++j) {
    const JointLine& joint = domain.joints[j];
    if (joint.between.size() != 2 || domain.faces.empty()) continue;
    const Index first = region_number(domain, joint, joint.between[0], mistakes);
    const Index second = region_number(domain, joint, joint.between[1], mistakes);
    if (first < 0 || second < 0) continue;
    const auto links = common_border(domain, first, second);
    if (links.empty()) {
      mistakes.add(joint.place, "regions '" + joint.between[0] + "' and '" + joint.between[1] +
                                    "' of joint '" + joint.name + "' have no common border");
    }
    double position = 0;
    for (const Link& link : links) {
      if (!claim(domain, link.number, j, doubled, mistakes)) continue;
      auto& s = domain.segments[link.number];
      s.joint_reversed = s.from != link.start;
      s.joint_position = position;
      position += geometry::distance(domain.points[s.from], domain.points[s.to]);
    }
  }
}

}  // namespace ashlar::mesh
