#include "mesh/adjacency.hpp"

namespace ashlar::mesh {

Adjacency Adjacency::transposed(Index columns) const {
  std::vector<Index> offsets(static_cast<std::size_t>(columns) + 1, 0);
  for (const Index column : values_) ++offsets[static_cast<std::size_t>(column) + 1];
  for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
  std::vector<Index> next(offsets.begin(), offsets.end() - 1);
  std::vector<Index> rows(values_.size());
  for (Index row = 0; row < size(); ++row) {
    for (const Index column : (*this)[row]) {
      rows[static_cast<std::size_t>(next[static_cast<std::size_t>(column)]++)] = row;
    }
  }
  return {std::move(offsets), std::move(rows)};
}

}  // namespace ashlar::mesh
