#include "mesh/insert.hpp"

#include <algorithm>
#include <cassert>

#include "mesh/cell_shapes.hpp"

namespace ashlar::mesh {

namespace {

/// What became of an edge: parts.size() is points.size() + 1; t are the places of the points on it.
struct Split {
  std::vector<Index> parts, points;
  std::vector<double> t;
};

class Inserter {
 public:
  explicit Inserter(Mesh& mesh) : mesh_(mesh) {}

  std::vector<Index> insert(std::span<const PointOnEdge> places) {
    std::vector<Index> numbers;
    std::map<Index, std::vector<std::pair<double, Index>>> on_edge;
    for (const auto& [edge, t] : places) {
      assert(t > 0 && t < 1 && mesh_.edge_cells[edge][1] < 0);
      const auto [a, b] = mesh_.edge_points[edge];
      numbers.push_back(mesh_.point_count());
      on_edge[edge].emplace_back(t, numbers.back());
      mesh_.points.push_back(mesh_.points[a] + t * (mesh_.points[b] - mesh_.points[a]));
    }
    for (auto& [edge, points] : on_edge) {
      std::sort(points.begin(), points.end());
      split(edge, points);
    }
    rebuild_cells();
    extend_groups();
    for (JointLips& joint : mesh_.joints)
      for (int side = 0; side < 2; ++side) joint.lips[side] = divided(joint, side);
    put_on_arcs();
    return numbers;
  }

 private:
  void split(Index edge, const std::vector<std::pair<double, Index>>& points) {
    Split& done = splits_[edge];
    const Index end = mesh_.edge_points[edge][1];
    const auto arc = mesh_.arcs.find(edge);
    done.parts = {edge};
    for (const auto& [t, point] : points) {
      mesh_.edge_points[done.parts.back()][1] = point;
      done.parts.push_back(mesh_.edge_count());
      mesh_.edge_points.push_back({point, end});
      mesh_.edge_cells.push_back({mesh_.edge_cells[edge][0], -1});
      if (arc != mesh_.arcs.end()) mesh_.arcs[done.parts.back()] = arc->second;
      done.points.push_back(point);
      done.t.push_back(t);
    }
  }

  // Border edges run in the sense of their one cell.
  void rebuild_cells() {
    Adjacency cell_points, cell_edges;
    std::vector<Index> points, edges;
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell) {
      points.clear(), edges.clear();
      const auto corners = mesh_.cell_points[cell], sides = mesh_.cell_edges[cell];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        points.push_back(corners[i]);
        const auto found = splits_.find(sides[i]);
        if (found == splits_.end()) {
          edges.push_back(sides[i]);
          continue;
        }
        points.insert(points.end(), found->second.points.begin(), found->second.points.end());
        edges.insert(edges.end(), found->second.parts.begin(), found->second.parts.end());
      }
      cell_points.append(points);
      cell_edges.append(edges);
    }
    mesh_.cell_points = std::move(cell_points);
    mesh_.cell_edges = std::move(cell_edges);
  }

  void extend_groups() {
    for (auto& [name, group] : mesh_.edge_groups) {
      const std::size_t before = group.size();
      for (std::size_t i = 0; i < before; ++i)
        if (const auto found = splits_.find(group[i]); found != splits_.end())
          group.insert(group.end(), found->second.parts.begin() + 1, found->second.parts.end());
      if (group.size() > before) std::sort(group.begin(), group.end());
    }
  }

  std::vector<LipEdge> divided(const JointLips& joint, int side) const {
    std::vector<LipEdge> lip;
    for (const LipEdge& whole : joint.lips[side]) {
      const auto found = splits_.find(whole.edge);
      if (found == splits_.end()) {
        lip.push_back(whole);
        continue;
      }
      assert(joint.apart);
      const Split& split = found->second;
      const std::size_t count = split.parts.size();
      for (std::size_t k = 0; k < count; ++k) {
        // The second lip runs against its edges.
        const std::size_t part = side == 0 ? k : count - 1 - k;
        const double begin = part == 0 ? 0 : split.t[part - 1], end = part + 1 == count ? 1 : split.t[part];
        LipEdge piece = whole;
        piece.edge = split.parts[part];
        std::tie(piece.from, piece.to) = std::pair(mesh_.edge_points[piece.edge][side == 0 ? 0 : 1],
                                                   mesh_.edge_points[piece.edge][side == 0 ? 1 : 0]);
        const double length = whole.s_to - whole.s_from;
        if (k > 0) piece.s_from = lip.back().s_to;
        if (k + 1 < count) piece.s_to = whole.s_from + (side == 0 ? end : 1 - begin) * length;
        lip.push_back(piece);
      }
    }
    return lip;
  }

  void put_on_arcs() {
    if (std::ranges::none_of(splits_, [this](const auto& each) { return mesh_.arcs.contains(each.first); }))
      return;
    CellShapes cells(mesh_);
    for (const auto& [edge, split] : splits_)
      if (const auto arc = mesh_.arcs.find(edge); arc != mesh_.arcs.end())
        for (const Index p : split.points) cells.move(p, arc->second.nearest(mesh_.points[p]));
  }

  Mesh& mesh_;
  std::map<Index, Split> splits_;
};

}  // namespace

std::vector<Index> insert_points(Mesh& mesh, std::span<const PointOnEdge> places) {
  return places.empty() ? std::vector<Index>{} : Inserter(mesh).insert(places);
}

}  // namespace ashlar::mesh
