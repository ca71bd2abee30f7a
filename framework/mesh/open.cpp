#include "mesh/open.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace ashlar::mesh {

namespace {

// First and last point of each joint that is welded there: (joint, point).
std::set<std::pair<Index, Index>> welded_ends(const std::vector<JointEdge>& joint_edges,
                                              const std::vector<JointLine>& joints) {
  std::set<std::pair<Index, Index>> welded;
  for (std::size_t i = 0; i < joint_edges.size(); ++i) {
    const auto& edge = joint_edges[i];
    const bool first = i == 0 || joint_edges[i - 1].joint != edge.joint;
    const bool last = i + 1 == joint_edges.size() || joint_edges[i + 1].joint != edge.joint;
    if (first && joints[edge.joint].weld[0]) welded.emplace(edge.joint, edge.from);
    if (last && joints[edge.joint].weld[1]) welded.emplace(edge.joint, edge.to);
  }
  return welded;
}

// Numbers the sectors of the cells around a point; `joined` says whether two of its edges' cells hang
// together.
class Sectors {
 public:
  explicit Sectors(std::span<const Index> cells) : cells_(cells), root_(cells.size()) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }
  void join(Index a, Index b) {
    const std::size_t i = find(position(a)), j = find(position(b));
    root_[std::max(i, j)] = std::min(i, j);
  }
  /// For each cell the position of the first cell of its sector. Cells ascend, so sectors do.
  std::size_t find(std::size_t i) const {
    while (root_[i] != i) i = root_[i];
    return i;
  }

 private:
  std::size_t position(Index cell) const {
    return static_cast<std::size_t>(std::lower_bound(cells_.begin(), cells_.end(), cell) - cells_.begin());
  }
  std::span<const Index> cells_;
  std::vector<std::size_t> root_;
};

}  // namespace

std::vector<Copy> open_joints(const Adjacency& cell_points, const EdgeTable& edges,
                              const std::vector<JointEdge>& joint_edges, const std::vector<JointLine>& joints,
                              Index points) {
  std::vector<Copy> copies;
  if (joint_edges.empty()) return copies;
  const auto welded = welded_ends(joint_edges, joints);
  std::vector<Index> joint_of(static_cast<std::size_t>(edges.size()), -1);
  std::set<Index> on_joints;
  for (const auto& edge : joint_edges) {
    joint_of[edge.edge] = edge.joint;
    on_joints.insert({edge.from, edge.to});
  }
  const Adjacency point_cells = cell_points.transposed(points);
  Index made = points;
  for (const Index p : on_joints) {
    const auto cells = point_cells[p];
    Sectors sectors(cells);
    for (const Index c : cells) {
      const auto corners = cell_points[c];
      const Index first = cell_points.offsets()[c];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Index edge = edges.cell_edges[first + i];
        const auto [a, b] = edges.points[edge];
        if ((a != p && b != p) || edges.cells[edge][1] < 0) continue;
        if (joint_of[edge] >= 0 && !welded.contains({joint_of[edge], p})) continue;
        sectors.join(edges.cells[edge][0], edges.cells[edge][1]);
      }
    }
    std::vector<Index> copy_of(cells.size(), -1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t sector = sectors.find(i);
      if (sector == 0) continue;
      if (copy_of[sector] < 0) copy_of[sector] = made++;
      copies.push_back({cells[i], p, copy_of[sector]});
    }
  }
  return copies;
}

}  // namespace ashlar::mesh
