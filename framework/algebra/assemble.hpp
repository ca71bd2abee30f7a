#pragma once
// Sums the contributions of groups (cells) into one array, the same bits for any number of threads.

#include <algorithm>
#include <span>
#include <vector>

#include "algebra/sparse.hpp"
#include "core/parallel.hpp"

namespace ashlar::algebra {

namespace detail {

/// Groups computed before they are scattered: their buffer stays in the cache.
constexpr Index groups_per_chunk = 4096;

inline void add(std::span<const Index> positions, const double* values, std::span<double> target) {
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (positions[k] >= 0) target[positions[k]] += values[k];
}

/// As `add`, for the positions in [from, to) alone.
inline void add_between(std::span<const Index> positions, const double* values, std::span<double> target,
                        Index from, Index to) {
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (positions[k] >= from && positions[k] < to) target[positions[k]] += values[k];
}

template <class Map, class Compute>
void assemble_on_one_thread(const Map& map, std::span<double> target, Compute& compute) {
  std::vector<double> values;
  for (Index g = 0; g < map.size(); ++g) {
    const std::span<const Index> positions = map[g];
    if (values.size() < positions.size()) values.resize(positions.size());
    compute(g, std::span<double>(values.data(), positions.size()));
    add(positions, values.data(), target);
  }
}

}  // namespace detail

/// target[map[g][k]] += values_g[k] for every group g; a position of -1 is skipped. `compute(g, values)`
/// must fill all of `values` (as long as map[g]) and may run on several threads at once.
///
/// `map` is a ScatterMap (packed matrices into a SymmetricMatrix's values) or an Adjacency (vectors by dof).
/// Chunk by chunk, contributions are computed in parallel, then added in parallel, each thread owning a range
/// of the target and walking the groups in their order: every sum is taken in one order, whatever the
/// threads.
template <class Map, class Compute>
void assemble(const Map& map, std::span<double> target, Compute&& compute) {
  if (core::thread_count() == 1) return detail::assemble_on_one_thread(map, target, compute);
  std::vector<double> values;
  std::vector<std::size_t> start;
  for (Index first = 0; first < map.size(); first += detail::groups_per_chunk) {
    const Index count = std::min(detail::groups_per_chunk, map.size() - first);
    start.assign(1, 0);
    Index low = static_cast<Index>(target.size()), high = 0;
    for (Index g = first; g < first + count; ++g) {
      start.push_back(start.back() + map[g].size());
      for (const Index p : map[g])
        if (p >= 0) low = std::min(low, p), high = std::max(high, p + 1);
    }
    values.resize(start.back());
    core::parallel_for(static_cast<std::size_t>(count), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        compute(first + static_cast<Index>(k),
                std::span<double>(values.data() + start[k], start[k + 1] - start[k]));
    });
    if (low >= high) continue;
    core::parallel_for(static_cast<std::size_t>(high - low), 1024, [&](std::size_t begin, std::size_t end) {
      const Index from = low + static_cast<Index>(begin), to = low + static_cast<Index>(end);
      for (Index k = 0; k < count; ++k)
        detail::add_between(map[first + k], values.data() + start[k], target, from, to);
    });
  }
}

}  // namespace ashlar::algebra
