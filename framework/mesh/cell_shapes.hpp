#pragma once
// Moving points of a finished mesh, as long as the cells around them keep their shape.

#include "mesh/mesh.hpp"

namespace ashlar::mesh {

class CellShapes {
 public:
  explicit CellShapes(Mesh& mesh);

  /// Moves a point; puts it back and returns false if a cell there would not stay simple and
  /// counter-clockwise.
  bool move(Index point, Point to);

 private:
  bool sound(Index cell);

  Mesh& mesh_;
  Adjacency point_cells_;
  std::vector<Point> corners_;
};

}  // namespace ashlar::mesh
