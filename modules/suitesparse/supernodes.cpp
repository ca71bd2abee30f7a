#include "suitesparse/supernodes.hpp"

#include <algorithm>
#include <vector>

#include <cblas.h>

namespace ashlar::suitesparse {

//   L₁₁ x₁ = b₁,  b₂ −= L₂₁ x₁
void solve_lower(const Supernodes& nodes, std::span<double> x) {
  const OneThread one_thread;
  std::vector<double> below;
  for (Index s = 0; s < nodes.count; ++s) {
    const Index columns = nodes.columns(s), rows = nodes.rows(s), more = rows - columns;
    double* own = x.data() + nodes.first_column[s];
    if (std::all_of(own, own + columns, [](double value) { return value == 0; })) continue;
    const double* block = nodes.value + nodes.values_at[s];
    cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, columns, block, rows, own, 1);
    if (more == 0) continue;
    below.resize(static_cast<std::size_t>(more));
    cblas_dgemv(CblasColMajor, CblasNoTrans, more, columns, 1, block + columns, rows, own, 1, 0, below.data(),
                1);
    const int* row = nodes.row + nodes.rows_at[s] + columns;
    for (Index r = 0; r < more; ++r) x[row[r]] -= below[r];
  }
}

//   L₁₁ᵀ x₁ = b₁ − L₂₁ᵀ x₂
void solve_lower_transposed(const Supernodes& nodes, std::span<double> x) {
  const OneThread one_thread;
  std::vector<double> below;
  for (Index s = nodes.count - 1; s >= 0; --s) {
    const Index columns = nodes.columns(s), rows = nodes.rows(s), more = rows - columns;
    double* own = x.data() + nodes.first_column[s];
    const double* block = nodes.value + nodes.values_at[s];
    if (more > 0) {
      below.resize(static_cast<std::size_t>(more));
      const int* row = nodes.row + nodes.rows_at[s] + columns;
      for (Index r = 0; r < more; ++r) below[r] = x[row[r]];
      cblas_dgemv(CblasColMajor, CblasTrans, more, columns, -1, block + columns, rows, below.data(), 1, 1,
                  own, 1);
    }
    cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, columns, block, rows, own, 1);
  }
}

}  // namespace ashlar::suitesparse
