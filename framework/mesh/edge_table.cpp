#include "mesh/edge_table.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "mesh/flatten.hpp"

namespace ashlar::mesh {

namespace {

[[noreturn]] void report_overlap(Point a, Point b) {
  core::Mistake mistake;
  mistake.what = "the mesh has cells that overlap at the edge from " + to_text(a) + " to " + to_text(b);
  throw core::InputError(std::move(mistake));
}

}  // namespace

EdgeTable::EdgeTable(const Adjacency& cell_points, const std::vector<Point>& coordinates)
    : first_of_point_(coordinates.size(), -1) {
  cell_edges.reserve(cell_points.values().size());
  for (Index cell = 0; cell < cell_points.size(); ++cell) {
    const auto corners = cell_points[cell];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
      Index edge = find(a, b);
      if (edge < 0) {
        edge = size();
        points.push_back({a, b});
        cells.push_back({cell, -1});
        next_.push_back(first_of_point_[std::min(a, b)]);
        first_of_point_[std::min(a, b)] = edge;
      } else if (cells[edge][1] >= 0 || points[edge][0] == a) {
        report_overlap(coordinates[a], coordinates[b]);
      } else {
        cells[edge][1] = cell;
      }
      cell_edges.push_back(edge);
    }
  }
}

Index EdgeTable::find(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  for (Index edge = first_of_point_[low]; edge >= 0; edge = next_[edge]) {
    if (std::max(points[edge][0], points[edge][1]) == high) return edge;
  }
  return -1;
}

}  // namespace ashlar::mesh
