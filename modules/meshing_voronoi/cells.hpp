#pragma once
// From sites to cells: the Voronoi diagram with border points set exactly, and short edges collapsed.

#include "border.hpp"

namespace ashlar::meshing_voronoi {

struct Cells {
  std::vector<Point> points;         ///< first the balls' centres (used or not), then Voronoi vertices
  std::size_t fixed_points = 0;      ///< how many of them carry geometry
  std::vector<Index> offsets = {0};  ///< ring of cell c: corners[offsets[c] … offsets[c + 1])
  std::vector<Index> corners;        ///< counter-clockwise
  std::vector<Index> faces;
  Index size() const { return static_cast<Index>(faces.size()); }
};

/// Voronoi cells of the sites that lie in faces.
Cells cut_cells(const std::vector<Site>& sites, const std::vector<Ball>& balls);

/// Joins the ends of edges shorter than tolerance × √(area of the smaller cell beside them), shortest first,
/// unless both carry geometry or a cell would turn over or cease to be simple. Returns how many.
Index collapse_short_edges(Cells& cells, double tolerance);

/// Drops points that no cell uses.
void drop_unused_points(Cells& cells);

/// What is wrong with the cells: a piece of a segment that no edge follows, areas that do not add up, a cell
/// that is not simple. Places, empty if all is well.
std::vector<Point> find_faults(const mesh::Domain& domain, const Border& border, const Cells& cells);

}  // namespace ashlar::meshing_voronoi
