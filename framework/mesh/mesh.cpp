#include "mesh/mesh.hpp"

#include <limits>

namespace ashlar::mesh {

std::span<const Point> Mesh::corners(Index cell, std::vector<Point>& corners) const {
  const auto row = cell_points[cell];
  corners.resize(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) corners[i] = points[row[i]];
  return corners;
}

std::optional<EdgeArc> arc_of(const Mesh& mesh, Index edge, bool reversed) {
  const auto found = mesh.arcs.find(edge);
  if (found == mesh.arcs.end()) return {};
  EdgeArc arc = found->second;
  if (reversed) arc.counter_clockwise = !arc.counter_clockwise;
  return arc;
}

std::vector<std::string> edge_group_names(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, edges] : mesh.edge_groups) names.push_back(name);
  return names;
}

std::vector<Index> bodies(const Mesh& mesh, Index& count) {
  std::vector<Index> body(static_cast<std::size_t>(mesh.cell_count()), -1), stack;
  count = 0;
  for (Index seed = 0; seed < mesh.cell_count(); ++seed) {
    if (body[seed] >= 0) continue;
    body[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index cell = stack.back();
      stack.pop_back();
      for (const Index edge : mesh.cell_edges[cell]) {
        for (const Index other : mesh.edge_cells[edge]) {
          if (other < 0 || body[other] >= 0) continue;
          body[other] = count;
          stack.push_back(other);
        }
      }
    }
    ++count;
  }
  return body;
}

Index nearest_point(const Mesh& mesh, Point p, const std::string& lip) {
  Index nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  auto consider = [&](Index q) {
    const Point d = mesh.points[q] - p;
    const double square = geometry::dot(d, d);
    if (square < least || (square == least && q < nearest)) least = square, nearest = q;
  };
  if (lip.empty()) {
    for (Index q = 0; q < mesh.point_count(); ++q) consider(q);
    return nearest;
  }
  const auto group = mesh.edge_groups.find(lip);
  if (group == mesh.edge_groups.end()) return -1;
  for (const Index edge : group->second) {
    for (const Index q : mesh.edge_points[edge]) consider(q);
  }
  return nearest;
}

}  // namespace ashlar::mesh
