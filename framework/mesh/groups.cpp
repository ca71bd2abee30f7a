#include "mesh/groups.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "mesh/domain_joints.hpp"
#include "mesh/flatten.hpp"

namespace ashlar::mesh {

namespace {

using geometry::Arrangement;
using geometry::InputSegment;

bool holds(const std::vector<Index>& list, Index entry) {
  return std::find(list.begin(), list.end(), entry) != list.end();
}

Index number_in(const std::vector<RegionShape>& regions, const std::string& name) {
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (regions[r].name == name) return static_cast<Index>(r);
  return -1;
}

/// The two borders of a `faces` joint.
struct FacePair {
  Index joint = -1;
  std::array<Index, 2> regions = {-1, -1};
  std::array<std::string, 2> edges;
};

// Arranges all regions once, to see which hang together. Mistakes that every group's own domain will find are
// not collected here.
class Grouper {
 public:
  Grouper(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints, double chord,
          core::Mistakes& mistakes)
      : regions_(regions), joints_(joints), mistakes_(mistakes), root_(regions.size()) {
    std::iota(root_.begin(), root_.end(), 0);
    read_faces();
    arrange(chord);
  }

  /// For each region the lowest region of its group.
  std::vector<Index> groups() {
    for (const JointLine& joint : joints_) {
      if (joint.between.size() != 2) continue;
      unite(number_in(regions_, joint.between[0]), number_in(regions_, joint.between[1]));
    }
    for (Index s = 0; s < static_cast<Index>(arrangement_.segments.size()); ++s) unite_across(s);
    std::vector<Index> groups(regions_.size());
    for (std::size_t r = 0; r < groups.size(); ++r) groups[r] = find(static_cast<Index>(r));
    check_pairs();
    check_overlaps();
    return groups;
  }

  /// The group that a joint belongs to; 0 if it touches none (its domain reports that).
  Index group_of(Index joint) {
    if (!joints_[joint].between.empty()) {
      const Index region = number_in(regions_, joints_[joint].between[0]);
      return region < 0 ? 0 : find(region);
    }
    std::set<Index> groups;
    for (const auto& segment : arrangement_.segments) {
      const bool follows = std::ranges::any_of(segment.sources, [&](Index source) {
        const Index number = source < 0 ? -1 - source : source;
        return number >= first_path_ && sources_[number - first_path_].joint == joint;
      });
      if (!follows) continue;
      for (const Index face : {segment.left, segment.right})
        for (const Index region : regions_at_[face]) groups.insert(find(region));
    }
    if (groups.size() > 1) {
      mistakes_.add(joints_[joint].place,
                    "joint '" + joints_[joint].name + "' runs through '" + regions_[*groups.begin()].name +
                        "' and '" + regions_[*groups.rbegin()].name + "', which are meshed apart",
                    "give each body a joint of its own that ends at its border");
    }
    return groups.empty() ? 0 : *groups.begin();
  }

 private:
  void read_faces() {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (joints_[j].faces.size() != 2) continue;
      FacePair pair{static_cast<Index>(j), {}, {}};
      for (int side = 0; side < 2; ++side) {
        const std::string& word = joints_[j].faces[side];
        const std::size_t dot = word.find('.');
        pair.regions[side] = number_in(regions_, word.substr(0, dot));
        pair.edges[side] = dot == std::string::npos ? "" : word.substr(dot + 1);
      }
      if (pair.regions[0] >= 0 && pair.regions[1] >= 0) pairs_.push_back(pair);
    }
  }

  void arrange(double chord) {
    core::Mistakes found_again;
    flat_ = flatten(regions_, faces_of(joints_), chord, found_again);
    std::vector<InputSegment> inputs;
    for (const auto& edge : flat_.edges)
      inputs.push_back({edge.from, edge.to, static_cast<Index>(inputs.size())});
    first_path_ = static_cast<Index>(inputs.size());
    sources_ = joint_sources(joints_, first_path_, inputs, found_again);
    constexpr double relative_snap = 1e-9;
    arrangement_ = geometry::arrange(inputs, relative_snap * flat_.length);
    regions_at_.resize(arrangement_.faces.size());
    for (std::size_t f = 1; f < arrangement_.faces.size(); ++f)
      for (Index r = 0; r < static_cast<Index>(regions_.size()); ++r)
        if (flat_.shapes[r].contains(arrangement_.faces[f].inside)) regions_at_[f].push_back(r);
  }

  Index find(Index region) const {
    while (root_[region] != region) region = root_[region];
    return region;
  }

  void unite(Index a, Index b) {
    if (a < 0 || b < 0) return;
    a = find(a), b = find(b);
    root_[std::max(a, b)] = std::min(a, b);
  }

  bool bears(const Arrangement::Segment& segment, Index region, const std::string& name) const {
    return std::ranges::any_of(segment.sources, [&](Index source) {
      const Index number = source < 0 ? -1 - source : source;
      return number < first_path_ && flat_.edges[number].region == region && flat_.edges[number].name == name;
    });
  }

  /// The pair whose faces both lie on the segment, with these regions opposite each other.
  const FacePair* pair_on(const Arrangement::Segment& segment, Index a, Index b) const {
    for (const FacePair& pair : pairs_) {
      if (pair.regions != std::array{a, b} && pair.regions != std::array{b, a}) continue;
      if (bears(segment, pair.regions[0], pair.edges[0]) && bears(segment, pair.regions[1], pair.edges[1]))
        return &pair;
    }
    return nullptr;
  }

  void unite_across(Index number) {
    const auto& segment = arrangement_.segments[number];
    const auto &left = regions_at_[segment.left], &right = regions_at_[segment.right];
    for (const Index a : left)
      for (const Index b : right) {
        if (holds(right, a) || holds(left, b) || pair_on(segment, a, b)) continue;
        unite(a, b);
        bonds_.emplace(std::minmax(a, b), number);
      }
  }

  void check_pairs() {
    for (const FacePair& pair : pairs_) {
      const auto [a, b] = pair.regions;
      if (a == b || find(a) != find(b)) continue;
      const JointLine& joint = joints_[pair.joint];
      const std::string names = "'" + regions_[a].name + "' and '" + regions_[b].name + "'";
      const auto bond = bonds_.find(std::minmax(a, b));
      if (bond == bonds_.end()) {
        mistakes_.add(joint.place,
                      "joint '" + joint.name + "' has " + names +
                          " meet by contact, but other regions or joints make them one body",
                      "regions that share a border are bonded: use `path` or `between` inside one body");
        continue;
      }
      const auto& segment = arrangement_.segments[bond->second];
      mistakes_.add(joint.place,
                    "joint '" + joint.name + "' has " + names +
                        " meet by contact, but they are bonded along another border from " +
                        to_text(arrangement_.points[segment.from]) + " to " +
                        to_text(arrangement_.points[segment.to]),
                    "give their whole common border to the two faces, or use `between`");
    }
  }

  void check_overlaps() {
    std::set<std::pair<Index, Index>> said;
    for (std::size_t f = 1; f < regions_at_.size(); ++f) {
      const auto& here = regions_at_[f];
      for (std::size_t i = 0; i < here.size(); ++i)
        for (std::size_t j = i + 1; j < here.size(); ++j) {
          const Index a = here[i], b = here[j];
          if (find(a) == find(b) || face_bounds(static_cast<Index>(f), a, b)) continue;
          if (!said.emplace(a, b).second) continue;
          mistakes_.add(regions_[b].place,
                        "regions '" + regions_[a].name + "' and '" + regions_[b].name + "' overlap around " +
                            to_text(arrangement_.faces[f].inside),
                        "let one end where the other begins, or take it away with difference");
        }
    }
  }

  // Both faces of a pair of these two regions bound the overlap, each inside the other's region.
  bool face_bounds(Index face, Index a, Index b) const {
    return std::ranges::any_of(pairs_, [&](const FacePair& pair) {
      if (pair.regions != std::array{a, b} && pair.regions != std::array{b, a}) return false;
      std::array<bool, 2> met = {false, false};
      for (const auto& segment : arrangement_.segments) {
        if (segment.left != face && segment.right != face) continue;
        const auto &left = regions_at_[segment.left], &right = regions_at_[segment.right];
        for (int side = 0; side < 2; ++side) {
          const Index other = pair.regions[1 - side];
          met[side] = met[side] || (holds(left, other) && holds(right, other) &&
                                    bears(segment, pair.regions[side], pair.edges[side]));
        }
      }
      return met[0] && met[1];
    });
  }

  const std::vector<RegionShape>& regions_;
  const std::vector<JointLine>& joints_;
  core::Mistakes& mistakes_;
  std::vector<Index> root_;
  std::vector<FacePair> pairs_;
  FlatRegions flat_;
  Index first_path_ = 0;
  std::vector<JointSource> sources_;
  Arrangement arrangement_;
  std::vector<std::vector<Index>> regions_at_;
  std::map<std::pair<Index, Index>, Index> bonds_;  // two regions and a segment that bonds them
};

// Every edge of a face lies between its body and nothing.
void check_faces(const std::vector<Domain>& domains, const std::vector<JointLine>& joints,
                 core::Mistakes& mistakes) {
  for (const JointLine& joint : joints) {
    for (const std::string& face : joint.faces) {
      Index count = 0;
      const Domain::Segment* inner = nullptr;
      const Domain* at = nullptr;
      for (const Domain& domain : domains)
        for (const auto& segment : domain.segments) {
          if (std::ranges::count(segment.borders, face) == 0) continue;
          ++count;
          if (segment.left < 0 || segment.right < 0) continue;
          inner = &segment, at = &domain;
        }
      const std::string name = "edge '" + face + "' of joint '" + joint.name + "'";
      if (count == 0) mistakes.add(joint.place, name + " is not there: nothing is left of it");
      if (inner)
        mistakes.add(joint.place,
                     name + " is not on the border of its body from " + to_text(at->points[inner->from]) +
                         " to " + to_text(at->points[inner->to]),
                     "give the part that lies outside a name of its own");
    }
  }
}

}  // namespace

std::vector<Domain> make_domains(const std::vector<RegionShape>& regions,
                                 const std::vector<JointLine>& joints, double chord,
                                 core::Mistakes& mistakes) {
  const bool apart =
      std::ranges::any_of(joints, [](const JointLine& joint) { return joint.faces.size() == 2; });
  if (!apart || regions.empty()) return {make_domain(regions, joints, chord, mistakes)};
  Grouper grouper(regions, joints, chord, mistakes);
  const std::vector<Index> groups = grouper.groups();
  std::map<Index, std::pair<std::vector<RegionShape>, std::vector<JointLine>>> parts;
  for (std::size_t r = 0; r < regions.size(); ++r) parts[groups[r]].first.push_back(regions[r]);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].faces.empty())
      parts[grouper.group_of(static_cast<Index>(j))].second.push_back(joints[j]);
    else
      for (auto& [group, part] : parts) part.second.push_back(joints[j]);
  }
  std::vector<Domain> domains;
  for (const auto& [group, part] : parts)
    domains.push_back(make_domain(part.first, part.second, chord, mistakes));
  if (mistakes.empty()) check_faces(domains, joints, mistakes);
  return domains;
}

}  // namespace ashlar::mesh
