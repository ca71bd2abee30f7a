#include "fields/dof_map.hpp"

namespace ashlar::fields {

DofMap::DofMap(const mesh::Mesh& mesh, Field field) : field_(std::move(field)) {
  edges_from_ = mesh.point_count() * field_.per_point * field_.width;
  cells_from_ = edges_from_ + mesh.edge_count() * field_.per_edge * field_.width;
  size_ = cells_from_ + mesh.cell_count() * field_.per_cell * field_.width;
}

void DofMap::append_cell(const mesh::Mesh& mesh, Index cell, std::vector<Index>& dofs) const {
  const auto append_node = [&](Index first) {
    for (int c = 0; c < field_.width; ++c) dofs.push_back(first + c);
  };
  const auto points = mesh.cell_points[cell];
  for (const Index point : points) append_node(of_point(point));
  for (std::size_t side = 0; side < points.size() && field_.per_edge > 0; ++side) {
    const Index edge = mesh.cell_edges[cell][side];
    const bool forward = mesh.edge_points[edge][0] == points[side];
    for (int k = 0; k < field_.per_edge; ++k)
      append_node(of_edge(edge, forward ? k : field_.per_edge - 1 - k));
  }
  for (int k = 0; k < field_.per_cell; ++k) append_node(of_cell(cell, k));
}

}  // namespace ashlar::fields
