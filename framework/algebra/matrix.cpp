#include <algorithm>
#include <cassert>
#include <cmath>

#include "algebra/sparse.hpp"

namespace ashlar::algebra {

void multiply(const SymmetricMatrix& a, std::span<const double> x, std::span<double> y) {
  const SymmetricPattern& pattern = a.pattern;
  assert(x.size() == static_cast<std::size_t>(pattern.size) && y.size() == x.size());
  const std::vector<double>& upper = a.upper.empty() ? a.value : a.upper;
  std::fill(y.begin(), y.end(), 0.0);
  for (Index j = 0; j < pattern.size; ++j) {
    Index p = pattern.column_start[j];
    double sum = a.value[p] * x[j];
    for (++p; p < pattern.column_start[j + 1]; ++p) {
      const Index i = pattern.row[p];
      sum += upper[p] * x[i];
      y[i] += a.value[p] * x[j];
    }
    y[j] += sum;
  }
}

double infinity_norm(const SymmetricMatrix& a) {
  std::vector<double> sum(static_cast<std::size_t>(a.pattern.size));
  for (Index j = 0; j < a.pattern.size; ++j)
    for (Index p = a.pattern.column_start[j]; p < a.pattern.column_start[j + 1]; ++p) {
      const Index i = a.pattern.row[p];
      sum[i] += std::abs(a.value[p]);
      if (i != j) sum[j] += std::abs(a.upper.empty() ? a.value[p] : a.upper[p]);
    }
  return sum.empty() ? 0 : *std::max_element(sum.begin(), sum.end());
}

}  // namespace ashlar::algebra
