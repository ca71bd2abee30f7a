#pragma once
// A symmetric sparse matrix (lower triangle, compressed columns, rows ascending) and the map that scatters
// element matrices into it.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/adjacency.hpp"

namespace ashlar::algebra {

using mesh::Adjacency;
using mesh::Index;

struct SymmetricPattern {
  Index size = 0;
  std::vector<Index> column_start;  ///< size + 1
  std::vector<Index> row;           ///< the diagonal entry comes first in each column
  std::size_t entries() const { return row.size(); }
};

struct SymmetricMatrix {
  SymmetricPattern pattern;
  std::vector<double> value;  ///< as pattern.row
  /// Of the transposed entries (column, row) where the matrix is not symmetric, though its pattern is; else
  /// empty.
  std::vector<double> upper = {};
};

/// y = A x.
void multiply(const SymmetricMatrix& a, std::span<const double> x, std::span<double> y);
/// max over rows of Σ|a_ij|.
double infinity_norm(const SymmetricMatrix& a);

/// The pattern that couples the unknowns of every group with each other; unknown -1 (held) is skipped. Every
/// diagonal entry is present. Deterministic.
SymmetricPattern make_pattern(Index size, std::span<const Adjacency* const> groups);

/// Where the packed lower triangle of each group's matrix goes. For group g the entries row by row
/// (0,0) (1,0) (1,1) (2,0) … hold the position in `value`, or -1 if either unknown is held.
class ScatterMap {
 public:
  ScatterMap() = default;
  ScatterMap(const SymmetricPattern& pattern, const Adjacency& groups);
  std::span<const Index> operator[](Index group) const {
    return {position_.data() + start_[group], static_cast<std::size_t>(start_[group + 1] - start_[group])};
  }
  Index size() const { return static_cast<Index>(start_.size()) - 1; }
  std::size_t bytes() const;

 private:
  std::vector<std::int64_t> start_{0};
  std::vector<Index> position_;
};

}  // namespace ashlar::algebra
