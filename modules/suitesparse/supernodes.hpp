#pragma once
// The supernodes of a CHOLMOD factor L: columns of equal structure, stored as dense columns of all their
// rows.

#include <span>

#include "algebra/sparse.hpp"
#include "suitesparse/common.hpp"

namespace ashlar::suitesparse {

using algebra::Index;

struct Supernodes {
  explicit Supernodes(const cholmod_factor& factor)
      : count(static_cast<Index>(factor.nsuper)),
        first_column(static_cast<const int*>(factor.super)),
        rows_at(static_cast<const int*>(factor.pi)),
        values_at(static_cast<const int*>(factor.px)),
        row(static_cast<const int*>(factor.s)),
        value(static_cast<const double*>(factor.x)) {}
  Index rows(Index s) const { return rows_at[s + 1] - rows_at[s]; }
  Index columns(Index s) const { return first_column[s + 1] - first_column[s]; }
  /// Column j of supernode s, from its row `first_column[s]` on.
  const double* column(Index s, Index j) const {
    return value + values_at[s] + static_cast<std::ptrdiff_t>(j - first_column[s]) * rows(s);
  }
  Index count;
  const int *first_column, *rows_at, *values_at, *row;
  const double* value;
};

/// x = L⁻¹ x, in the order of elimination. Columns that nothing has reached are passed over: a load on few
/// unknowns reads only the part of L on their paths to the root.
void solve_lower(const Supernodes& nodes, std::span<double> x);

/// x = L⁻ᵀ x.
void solve_lower_transposed(const Supernodes& nodes, std::span<double> x);

}  // namespace ashlar::suitesparse
