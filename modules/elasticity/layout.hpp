#pragma once
// Where the dofs, integration points and internal variables of each cell stand.

#include <vector>

#include "model/model.hpp"

namespace ashlar::elasticity {

using mesh::Index;

struct Layout {
  explicit Layout(const model::Model& model);

  std::size_t bytes() const;
  /// A cell's part of the internal variables.
  template <class T>
  std::span<T> of(Index cell, std::span<T> all) const {
    const auto c = static_cast<std::size_t>(cell);
    return all.subspan(history[c], history[c + 1] - history[c]);
  }

  mesh::Adjacency dofs;              ///< of each cell, in the element's order
  std::vector<std::size_t> point;    ///< integration points of cell c: point[c] … point[c+1]
  std::vector<std::size_t> history;  ///< internal variables of cell c begin at history[c], point by point
  bool symmetric = true;             ///< every law's tangent is
};

}  // namespace ashlar::elasticity
