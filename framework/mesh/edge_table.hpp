#pragma once
// The edges of a set of cells, numbered as they are met going through the cells.

#include <array>
#include <vector>

#include "mesh/adjacency.hpp"

namespace ashlar::mesh {

class EdgeTable {
 public:
  /// Throws InputError if cells overlap (an edge with three cells, or with two on the same side).
  EdgeTable(const Adjacency& cell_points, const std::vector<Point>& points);

  /// The edge between two points, in either sense; -1 if there is none.
  Index find(Index a, Index b) const;

  Index size() const { return static_cast<Index>(points.size()); }

  std::vector<std::array<Index, 2>> points;  ///< in the sense of the first cell
  std::vector<std::array<Index, 2>> cells;   ///< the second is -1 on a border
  std::vector<Index> cell_edges;             ///< parallel to cell_points.values()

 private:
  std::vector<Index> first_of_point_;  // edges by their lower point, as linked lists
  std::vector<Index> next_;
};

}  // namespace ashlar::mesh
