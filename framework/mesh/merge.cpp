// Several domains or meshes side by side as one.
#include <algorithm>
#include <cassert>

#include "mesh/groups.hpp"

namespace ashlar::mesh {

namespace {

Index shifted(Index entry, Index by) {
  return entry < 0 ? entry : entry + by;
}

// Rings count a segment from -1 downwards where they run against it.
void shift_ring(std::vector<Index>& ring, Index by) {
  for (Index& entry : ring) entry = entry < 0 ? entry - by : entry + by;
}

void append(Domain& all, const Domain& part) {
  const auto points = static_cast<Index>(all.points.size()), faces = static_cast<Index>(all.faces.size()),
             segments = static_cast<Index>(all.segments.size()),
             regions = static_cast<Index>(all.regions.size());
  std::vector<Index> joint_number;
  for (const JointLine& joint : part.joints) {
    const auto same = std::ranges::find(all.joints, joint.name, &JointLine::name);
    joint_number.push_back(static_cast<Index>(same - all.joints.begin()));
    if (same == all.joints.end()) all.joints.push_back(joint);
  }
  for (auto segment : part.segments) {
    segment.from += points, segment.to += points;
    segment.left = shifted(segment.left, faces), segment.right = shifted(segment.right, faces);
    if (segment.joint >= 0) segment.joint = joint_number[segment.joint];
    all.segments.push_back(std::move(segment));
  }
  for (auto face : part.faces) {
    face.region += regions;
    shift_ring(face.outer, segments);
    for (auto& ring : face.inner) shift_ring(ring, segments);
    all.faces.push_back(std::move(face));
  }
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  all.regions.insert(all.regions.end(), part.regions.begin(), part.regions.end());
  all.named_points.insert(part.named_points.begin(), part.named_points.end());
}

void append_groups(const std::map<std::string, std::vector<Index>>& part, Index first,
                   std::map<std::string, std::vector<Index>>& all) {
  for (const auto& [name, members] : part)
    for (const Index member : members) all[name].push_back(member + first);
}

void append_joints(std::vector<JointLips> joints, std::array<Index, 3> first, std::vector<JointLips>& all) {
  const auto [points, cells, edges] = first;
  for (JointLips& joint : joints) {
    for (auto& lip : joint.lips)
      for (LipEdge& edge : lip) {
        edge.edge += edges, edge.cell += cells;
        edge.from += points, edge.to += points;
      }
    for (auto& [first, second] : joint.pairs) first += points, second += points;
    all.push_back(std::move(joint));
  }
}

// What is said of all bodies alike is said once.
void append_notes(const std::vector<std::pair<std::string, std::string>>& part,
                  std::vector<std::pair<std::string, std::string>>& all) {
  for (const auto& [key, text] : part) {
    const auto same = std::ranges::find(all, key, &std::pair<std::string, std::string>::first);
    if (same == all.end())
      all.emplace_back(key, text);
    else if (same->second != text)
      same->second += "; " + text;
  }
}

void append(Mesh& all, Mesh part, const std::vector<Index>& region_number) {
  const Index points = all.point_count(), cells = all.cell_count(), edges = all.edge_count();
  std::vector<Index> row;
  const auto append_rows = [&row](const Adjacency& from, Index by, Adjacency& to) {
    for (Index r = 0; r < from.size(); ++r) {
      row.assign(from[r].begin(), from[r].end());
      for (Index& entry : row) entry += by;
      to.append(row);
    }
  };
  append_rows(part.cell_points, points, all.cell_points);
  append_rows(part.cell_edges, edges, all.cell_edges);
  for (const auto& [a, b] : part.edge_points) all.edge_points.push_back({a + points, b + points});
  for (const auto& [a, b] : part.edge_cells) all.edge_cells.push_back({a + cells, shifted(b, cells)});
  for (const Index region : part.cell_region) all.cell_region.push_back(region_number[region]);
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  append_groups(part.edge_groups, edges, all.edge_groups);
  append_groups(part.point_groups, points, all.point_groups);
  append_joints(std::move(part.joints), {points, cells, edges}, all.joints);
  for (const auto& [edge, arc] : part.arcs) all.arcs[edge + edges] = arc;
  append_notes(part.notes, all.notes);
}

double diagonal(const std::vector<Point>& points) {
  if (points.empty()) return 0;
  Point low = points.front(), high = low;
  for (const Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return geometry::distance(low, high);
}

}  // namespace

Domain together(const std::vector<Domain>& domains) {
  assert(!domains.empty());
  Domain all = domains.front();
  for (std::size_t d = 1; d < domains.size(); ++d) append(all, domains[d]);
  if (domains.size() > 1) all.length = diagonal(all.points);
  return all;
}

Mesh merge(std::vector<Mesh> parts, const std::vector<std::string>& regions) {
  Mesh all;
  all.regions = regions;
  for (Mesh& part : parts) {
    std::vector<Index> number;
    for (const std::string& name : part.regions) {
      const auto found = std::ranges::find(regions, name);
      assert(found != regions.end());
      number.push_back(static_cast<Index>(found - regions.begin()));
    }
    append(all, std::move(part), number);
  }
  return all;
}

}  // namespace ashlar::mesh
