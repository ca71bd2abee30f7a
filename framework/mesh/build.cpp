#include <algorithm>
#include <cassert>
#include <limits>

#include "mesh/cut.hpp"
#include "mesh/flatten.hpp"
#include "mesh/joint_edges.hpp"
#include "mesh/open.hpp"

namespace ashlar::mesh {

namespace {

using core::InputError;
using core::Mistake;

double extent(const std::vector<Point>& points) {
  if (points.empty()) return 0;
  Point low = points.front(), high = low;
  for (const Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return geometry::distance(low, high);
}

// Points that no cell uses would be free unknowns.
void drop_unused_points(RawMesh& raw) {
  std::vector<Index> number(raw.points.size(), -1);
  for (const Index p : raw.cell_points.values()) number[p] = 0;
  Index count = 0;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] < 0) continue;
    raw.points[count] = raw.points[p];
    number[p] = count++;
  }
  if (count == static_cast<Index>(raw.points.size())) return;
  raw.points.resize(count);
  for (Index& p : raw.cell_points.values()) p = number[p];
  for (auto& [name, edges] : raw.edge_groups) {
    for (auto& edge : edges) edge = {number[edge[0]], number[edge[1]]};
    std::erase_if(edges, [](const auto& edge) { return edge[0] < 0 || edge[1] < 0; });
  }
  for (auto& [name, group] : raw.point_groups) {
    for (Index& p : group) p = number[p];
    std::erase(group, -1);
  }
}

void require_borders(const Domain& domain, const std::vector<Index>& missing) {
  for (const Index s : missing) {
    const auto& segment = domain.segments[s];
    if (segment.joint >= 0) {
      const auto& joint = domain.joints[segment.joint];
      throw InputError(Mistake{joint.place,
                               "the mesh does not follow joint '" + joint.name + "' from " +
                                   to_text(domain.points[segment.from]) + " to " +
                                   to_text(domain.points[segment.to]),
                               "refine the mesh there, or use a mesh that conforms to joints"});
    }
    std::string name;
    for (const auto& border : segment.borders) name += " '" + border + "'";
    throw InputError(Mistake{{},
                             "the mesh does not follow the border" + name + " from " +
                                 to_text(domain.points[segment.from]) + " to " +
                                 to_text(domain.points[segment.to]),
                             "refine the mesh there, or use another kind of mesh"});
  }
}

// From the raw mesh, its edges and the copies of points to the final mesh.
class Assembler {
 public:
  Assembler(RawMesh raw, const Domain& domain, const EdgeTable& edges)
      : raw_(std::move(raw)), domain_(domain), edges_(edges) {}

  Mesh assemble(const FollowedSegments& followed) {
    is_joint_.assign(static_cast<std::size_t>(edges_.size()), false);
    for (const auto& edge : followed.joint_edges) is_joint_[edge.edge] = true;
    mesh_.regions = domain_.faces.empty() ? raw_.regions : domain_.regions;
    mesh_.cell_region = raw_.cell_region;
    take_points(open_joints(raw_.cell_points, edges_, followed.joint_edges, domain_.joints,
                            static_cast<Index>(raw_.points.size())));
    number_edges();
    for (const auto& [segment, edge] : followed.border_edges) {
      name_border(domain_.segments[segment], edge);
      if (domain_.segments[segment].arc) note_arc(domain_.segments[segment], edge);
    }
    name_raw_edges();
    for (const auto& edge : followed.joint_edges) add_lips(edge);
    for (auto& [name, group] : mesh_.edge_groups) {
      std::sort(group.begin(), group.end());
      group.erase(std::unique(group.begin(), group.end()), group.end());
    }
    return std::move(mesh_);
  }

 private:
  void take_points(const std::vector<Copy>& copies) {
    mesh_.points = std::move(raw_.points);
    mesh_.cell_points = std::move(raw_.cell_points);
    mesh_.point_groups = std::move(raw_.point_groups);
    std::map<Index, std::vector<Index>> copies_of;
    for (const Copy& copy : copies) {
      if (copy.made == mesh_.point_count()) {
        mesh_.points.push_back(mesh_.points[copy.point]);
        copies_of[copy.point].push_back(copy.made);
      }
      const auto begin = mesh_.cell_points.values().begin() + mesh_.cell_points.offsets()[copy.cell];
      const auto end = mesh_.cell_points.values().begin() + mesh_.cell_points.offsets()[copy.cell + 1];
      *std::find(begin, end, copy.point) = copy.made;
    }
    for (auto& [name, group] : mesh_.point_groups) {
      const std::vector<Index> originals = group;
      for (const Index p : originals) {
        if (const auto found = copies_of.find(p); found != copies_of.end()) {
          group.insert(group.end(), found->second.begin(), found->second.end());
        }
      }
      std::sort(group.begin(), group.end());
      group.erase(std::unique(group.begin(), group.end()), group.end());
    }
  }

  // A joint's edge becomes two, one for each of its cells.
  void number_edges() {
    new_edges_.assign(static_cast<std::size_t>(edges_.size()), {-1, -1});
    std::size_t k = 0;
    std::vector<Index> row;
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell) {
      row.clear();
      const auto corners = mesh_.cell_points[cell];
      for (std::size_t i = 0; i < corners.size(); ++i, ++k) {
        const Index old = edges_.cell_edges[k];
        const int side = edges_.cells[old][0] == cell ? 0 : 1;
        Index& made = new_edges_[old][is_joint_[old] ? side : 0];
        if (made < 0) {
          made = mesh_.edge_count();
          mesh_.edge_points.push_back({corners[i], corners[(i + 1) % corners.size()]});
          mesh_.edge_cells.push_back({cell, -1});
        } else {
          mesh_.edge_cells[made][1] = cell;
        }
        row.push_back(made);
      }
      mesh_.cell_edges.append(row);
    }
  }

  // On an open joint each lip keeps the name that its own region gave.
  void name_border(const Domain::Segment& segment, Index old) {
    for (const auto& name : segment.borders) {
      for (const Index edge : new_edges_[old]) {
        if (edge < 0) continue;
        const std::string& region = mesh_.regions[mesh_.cell_region[mesh_.edge_cells[edge][0]]];
        if (!is_joint_[old] || name.starts_with(region + ".")) mesh_.edge_groups[name].push_back(edge);
      }
    }
  }

  void note_arc(const Domain::Segment& segment, Index old) {
    const Point along = domain_.points[segment.to] - domain_.points[segment.from];
    for (const Index edge : new_edges_[old]) {
      if (edge < 0) continue;
      const auto [a, b] = mesh_.edge_points[edge];
      EdgeArc arc = *segment.arc;
      if (dot(along, mesh_.points[b] - mesh_.points[a]) < 0) arc.counter_clockwise = !arc.counter_clockwise;
      mesh_.arcs[edge] = arc;
    }
  }

  void name_raw_edges() {
    for (const auto& [name, pairs] : raw_.edge_groups) {
      auto& group = mesh_.edge_groups[name];
      for (const auto& [a, b] : pairs) {
        const Index old = edges_.find(a, b);
        if (old < 0) {
          throw InputError(Mistake{{},
                                   "edge group '" + name +
                                       "' of the mesh has an edge that no cell has, near " +
                                       to_text(mesh_.points[a]),
                                   {}});
        }
        for (const Index edge : new_edges_[old]) {
          if (edge >= 0) group.push_back(edge);
        }
      }
    }
  }

  void add_lips(const JointEdge& joint_edge) {
    const JointLine& line = domain_.joints[joint_edge.joint];
    if (mesh_.joints.empty() || last_joint_ != joint_edge.joint) {
      last_joint_ = joint_edge.joint;
      mesh_.joints.push_back({line.name, line.sides, {}});
    }
    const Index old = joint_edge.edge;
    if (new_edges_[old][1] < 0) {
      throw InputError(Mistake{line.place,
                               "joint '" + line.name + "' runs along an outer border of the mesh near " +
                                   to_text(mesh_.points[joint_edge.from]),
                               {}});
    }
    const int left = edges_.points[old][0] == joint_edge.from ? 0 : 1;
    for (int side = 0; side < 2; ++side) {
      const Index edge = new_edges_[old][side == 0 ? left : 1 - left];
      LipEdge lip{edge,
                  mesh_.edge_cells[edge][0],
                  mesh_.edge_points[edge][0],
                  mesh_.edge_points[edge][1],
                  joint_edge.s_from,
                  joint_edge.s_to,
                  arc_of(mesh_, edge, side == 1)};
      if (side == 1) std::swap(lip.from, lip.to);
      mesh_.joints.back().lips[side].push_back(lip);
      mesh_.edge_groups[line.name + "." + line.sides[side]].push_back(edge);
    }
  }

  RawMesh raw_;
  const Domain& domain_;
  const EdgeTable& edges_;
  Mesh mesh_;
  std::vector<bool> is_joint_;
  std::vector<std::array<Index, 2>> new_edges_;  // of each old edge: by its first and its second cell
  Index last_joint_ = -1;
};

}  // namespace

Mesh build_mesh(RawMesh raw, const Domain& domain) {
  assert(raw.cell_region.size() == static_cast<std::size_t>(raw.cell_points.size()));
  drop_unused_points(raw);
  constexpr double relative_tolerance = 1e-9;
  const double tolerance = relative_tolerance * (domain.faces.empty() ? extent(raw.points) : domain.length);
  EdgeTable edges(raw.cell_points, raw.points);
  FollowedSegments followed = follow_segments(domain, raw.points, edges, tolerance);
  std::vector<Index> unfollowed;
  for (const Index s : followed.missing) {
    const Index joint = domain.segments[s].joint;
    if (joint >= 0 && std::find(unfollowed.begin(), unfollowed.end(), joint) == unfollowed.end())
      unfollowed.push_back(joint);
  }
  if (!unfollowed.empty()) {
    std::sort(unfollowed.begin(), unfollowed.end());
    cut_along_joints(raw, domain, unfollowed, tolerance);
    edges = EdgeTable(raw.cell_points, raw.points);
    followed = follow_segments(domain, raw.points, edges, tolerance);
  }
  require_borders(domain, followed.missing);
  if (domain.faces.empty()) add_joints_between_regions(domain, raw, edges, followed.joint_edges);
  auto notes = std::move(raw.notes);
  Mesh mesh = Assembler(std::move(raw), domain, edges).assemble(followed);
  mesh.notes = std::move(notes);
  return mesh;
}

}  // namespace ashlar::mesh
