#pragma once
// A ragged array: row i holds the entities adjacent to entity i. The one such type everywhere.

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ashlar::mesh {

using geometry::Index;
using geometry::Point;

class Adjacency {
 public:
  Adjacency() = default;
  Adjacency(std::vector<Index> offsets, std::vector<Index> values)
      : offsets_(std::move(offsets)), values_(std::move(values)) {}

  Index size() const { return static_cast<Index>(offsets_.size()) - 1; }
  std::span<const Index> operator[](Index row) const {
    return {values_.data() + offsets_[row], static_cast<std::size_t>(offsets_[row + 1] - offsets_[row])};
  }
  Index count(Index row) const { return offsets_[row + 1] - offsets_[row]; }
  void append(std::span<const Index> row) {
    values_.insert(values_.end(), row.begin(), row.end());
    offsets_.push_back(static_cast<Index>(values_.size()));
  }
  std::span<const Index> offsets() const { return offsets_; }
  std::span<const Index> values() const { return values_; }
  std::span<Index> values() { return values_; }

  /// The reverse relation: row j lists, ascending, the rows of this that hold j.
  Adjacency transposed(Index columns) const;

 private:
  std::vector<Index> offsets_{0};
  std::vector<Index> values_;
};

}  // namespace ashlar::mesh
