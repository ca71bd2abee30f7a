#include "mesh/cell_shapes.hpp"

#include <algorithm>

#include "geometry/polygon.hpp"

namespace ashlar::mesh {

CellShapes::CellShapes(Mesh& mesh)
    : mesh_(mesh), point_cells_(mesh.cell_points.transposed(mesh.point_count())) {}

bool CellShapes::move(Index point, Point to) {
  const Point before = mesh_.points[point];
  mesh_.points[point] = to;
  const bool holds = std::ranges::all_of(point_cells_[point], [this](Index cell) { return sound(cell); });
  if (!holds) mesh_.points[point] = before;
  return holds;
}

bool CellShapes::sound(Index cell) {
  mesh_.corners(cell, corners_);
  return geometry::signed_area(corners_) > 0 && geometry::is_simple(corners_);
}

}  // namespace ashlar::mesh
