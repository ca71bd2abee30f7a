#pragma once
// Groups of unknowns as a grid of quadrilaterals has them, without a mesh.

#include <random>

#include <Eigen/Dense>

#include "algebra/sparse.hpp"

namespace ashlar::algebra::testing {

/// Two unknowns a node on nx × ny quads; nodes numbered row by row; the first `held` unknowns are held (-1).
inline Adjacency quad_groups(Index nx, Index ny, Index held = 0) {
  Adjacency groups;
  std::vector<Index> row;
  for (Index y = 0; y < ny; ++y)
    for (Index x = 0; x < nx; ++x) {
      row.clear();
      const Index a = y * (nx + 1) + x;
      for (const Index node : {a, a + 1, a + nx + 2, a + nx + 1})
        for (Index c = 0; c < 2; ++c) row.push_back(std::max(2 * node + c - held, Index{-1}));
      groups.append(row);
    }
  return groups;
}

inline Index quad_unknowns(Index nx, Index ny, Index held = 0) {
  return 2 * (nx + 1) * (ny + 1) - held;
}

/// The full matrix.
inline Eigen::MatrixXd dense(const SymmetricMatrix& a) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(a.pattern.size, a.pattern.size);
  for (Index j = 0; j < a.pattern.size; ++j)
    for (Index p = a.pattern.column_start[j]; p < a.pattern.column_start[j + 1]; ++p)
      full(a.pattern.row[p], j) = full(j, a.pattern.row[p]) = a.value[p];
  return full;
}

}  // namespace ashlar::algebra::testing
