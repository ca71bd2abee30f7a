#include <algorithm>
#include <limits>
#include <numbers>

#include "geometry/polygon.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

MeshReport report(const Mesh& mesh) {
  MeshReport r;
  r.cells = mesh.cell_count();
  r.points = mesh.point_count();
  r.edges = mesh.edge_count();
  if (r.cells == 0) return r;
  constexpr double far = std::numeric_limits<double>::max();
  r.size_min = r.shortest_edge = r.shortest_edge_ratio = r.roundness_min = far;
  r.corners_min = std::numeric_limits<int>::max();
  std::vector<Point> corners;
  double lost = 0;
  for (Index cell = 0; cell < r.cells; ++cell) {
    mesh.corners(cell, corners);
    const double area = geometry::signed_area(corners), size = std::sqrt(std::max(area, 0.0));
    double perimeter = 0, shortest = far;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double length = geometry::distance(corners[i], corners[(i + 1) % corners.size()]);
      perimeter += length;
      shortest = std::min(shortest, length);
    }
    const double roundness = 4 * std::numbers::pi * area / (perimeter * perimeter);
    if (roundness < r.roundness_min) r.worst_cell = geometry::centroid(corners);
    // Kahan's sum: a hundred thousand equal areas would lose four digits.
    const double term = area - lost, sum = r.area + term;
    lost = (sum - r.area) - term;
    r.area = sum;
    r.size_min = std::min(r.size_min, size);
    r.size_max = std::max(r.size_max, size);
    r.size_mean += size / r.cells;
    r.corners_min = std::min(r.corners_min, static_cast<int>(corners.size()));
    r.corners_max = std::max(r.corners_max, static_cast<int>(corners.size()));
    r.corners_mean += static_cast<double>(corners.size()) / r.cells;
    r.shortest_edge = std::min(r.shortest_edge, shortest);
    r.shortest_edge_ratio = std::min(r.shortest_edge_ratio, shortest / geometry::diameter(corners));
    r.roundness_min = std::min(r.roundness_min, roundness);
    r.roundness_mean += roundness / r.cells;
  }
  r.notes = mesh.notes;
  return r;
}

}  // namespace ashlar::mesh
