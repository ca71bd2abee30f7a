#pragma once
// Where the dofs, integration points and internal variables of each cell stand.

#include <vector>

#include "model/model.hpp"

namespace ashlar::elasticity {

using mesh::Index;

struct Layout {
  explicit Layout(const model::Model& model);

  std::size_t bytes() const;

  mesh::Adjacency dofs;              ///< of each cell, in the element's order
  std::vector<std::size_t> point;    ///< integration points of cell c: point[c] … point[c+1]
  std::vector<std::size_t> history;  ///< internal variables of cell c begin at history[c], point by point
  bool linear = true;                ///< every law is
  bool symmetric = true;
};

}  // namespace ashlar::elasticity
