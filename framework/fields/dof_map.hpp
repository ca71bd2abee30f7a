#pragma once
// Degrees of freedom of one field on the mesh: `width` components on every node that points, edges and cells
// carry.

#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ashlar::fields {

using mesh::Index;

/// What a field is. Elements of order 1 carry it on points only; higher orders also on edges and cells.
struct Field {
  std::string name;                               ///< "displacement"
  std::string unit;                               ///< "m"
  int width = 2;                                  ///< components
  int per_point = 1, per_edge = 0, per_cell = 0;  ///< nodes on each entity
};

/// Numbers the degrees of freedom: all points first, then edges, then cells; components together.
class DofMap {
 public:
  DofMap() = default;
  DofMap(const mesh::Mesh& mesh, Field field);

  const Field& field() const { return field_; }
  Index size() const { return size_; }
  /// First of the `width` consecutive dofs of a node.
  Index of_point(Index point) const { return point * field_.width; }
  Index of_edge(Index edge, int node = 0) const {
    return edges_from_ + (edge * field_.per_edge + node) * field_.width;
  }
  Index of_cell(Index cell, int node = 0) const {
    return cells_from_ + (cell * field_.per_cell + node) * field_.width;
  }
  /// Appends a cell's dofs in the element's order: corners, then edge nodes (edge by edge, in the cell's own
  /// sense), then cell nodes; components together.
  void append_cell(const mesh::Mesh& mesh, Index cell, std::vector<Index>& dofs) const;

 private:
  Field field_;
  Index edges_from_ = 0, cells_from_ = 0, size_ = 0;
};

}  // namespace ashlar::fields
