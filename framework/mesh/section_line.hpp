#pragma once
// A polyline through the mesh: the cells that it crosses, the edges that it follows, and which cells and
// points lie on its left. Its ends count as prolonged straight on: an end inside a cell is moved out to the
// cell's border.

#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// Where a piece of the line begins or ends: at a mesh point, on a mesh edge, or (both -1) at a kink inside
/// a cell.
struct LineStation {
  double s = 0;  ///< arc length from the line's first point [m]; negative if moved out before it
  Point at;
  Index point = -1, edge = -1;
};

/// The line in one cell, or along one edge of it.
struct LinePiece {
  enum class Cell { crossed, left, right };  ///< left: the line follows an edge, the cell lies on its left
  Cell side = Cell::crossed;
  Index cell = -1, edge = -1;  ///< the edge that is followed, or -1
  int segment = 0;             ///< of the path
  LineStation from, to;
};

/// A cell that the line touches, if only in a corner.
struct TouchedCell {
  Index cell = -1;
  LinePiece::Cell side = LinePiece::Cell::crossed;
};

struct SectionLine {
  std::string name;
  std::vector<Point> path;
  double tolerance = 0;            ///< points nearer to the line lie on it [m]
  std::vector<LinePiece> pieces;   ///< by rising s; of two along one edge the left comes first
  std::vector<TouchedCell> cells;  ///< ascending
  std::vector<char> on_line;       ///< by mesh point
  bool ends_inside = false;        ///< an end lies inside the body: the line does not divide it there

  Point first() const { return pieces.front().from.at; }
  Point last() const;
  Point middle() const { return 0.5 * (first() + last()); }
  /// Unit vector from the first to the last place in the body; n = left_of(t) points to the line's left.
  Point along() const { return (1 / distance(first(), last())) * (last() - first()); }
  /// Unit vector along a segment of the path.
  Point direction(int segment) const;
  /// Distance to the (prolonged) line, positive on its left; 0 within the tolerance.
  double side(Point p) const;
  /// Follows borders of the body that lie on its right: no cell lies on its left.
  bool body_on_right() const;
};

/// Traces `path` (two points at least, neighbours apart). No pieces: it meets no cell.
SectionLine trace(const Mesh& mesh, std::vector<Point> path, double tolerance);

/// Corners of the chain that a group of edges makes, with the body (of the region "r" in a group "r.edge") on
/// its left; empty if they do not make one open chain.
std::vector<Point> path_along(const Mesh& mesh, const std::string& group, double tolerance);

}  // namespace ashlar::mesh
