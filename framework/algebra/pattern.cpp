#include <algorithm>
#include <cassert>
#include <limits>

#include "algebra/sparse.hpp"
#include "core/parallel.hpp"

namespace ashlar::algebra {

namespace {

/// For every unknown the groups that hold it, ascending; groups of all lists are numbered through.
struct Incidence {
  std::vector<std::int64_t> start;
  std::vector<Index> group;
  std::span<const Index> operator[](Index unknown) const {
    return {group.data() + start[unknown], group.data() + start[unknown + 1]};
  }
};

std::vector<std::span<const Index>> rows_of(std::span<const Adjacency* const> lists) {
  std::vector<std::span<const Index>> rows;
  for (const Adjacency* list : lists)
    for (Index g = 0; g < list->size(); ++g) rows.push_back((*list)[g]);
  return rows;
}

Incidence incidence(Index size, std::span<const std::span<const Index>> rows) {
  Incidence found;
  found.start.assign(static_cast<std::size_t>(size) + 1, 0);
  for (const auto& row : rows)
    for (const Index unknown : row)
      if (unknown >= 0) ++found.start[unknown + 1];
  for (Index i = 0; i < size; ++i) found.start[i + 1] += found.start[i];
  found.group.resize(static_cast<std::size_t>(found.start[size]));
  std::vector<std::int64_t> next(found.start.begin(), found.start.end() - 1);
  for (std::size_t g = 0; g < rows.size(); ++g)
    for (const Index unknown : rows[g])
      if (unknown >= 0) found.group[next[unknown]++] = static_cast<Index>(g);
  return found;
}

}  // namespace

SymmetricPattern make_pattern(Index size, std::span<const Adjacency* const> groups) {
  const auto rows = rows_of(groups);
  const Incidence of = incidence(size, rows);
  SymmetricPattern pattern;
  pattern.size = size;
  pattern.column_start.reserve(static_cast<std::size_t>(size) + 1);
  pattern.column_start.push_back(0);
  pattern.row.reserve(static_cast<std::size_t>(size) * 10);
  std::vector<Index> seen_by(static_cast<std::size_t>(size), -1);
  for (Index j = 0; j < size; ++j) {
    const std::size_t begin = pattern.row.size();
    // Unknowns of one node share all their groups: the second column is the first without its diagonal.
    if (j > 0 && !of[j].empty() && std::ranges::equal(of[j], of[j - 1])) {
      const auto above = static_cast<std::size_t>(pattern.column_start[j - 1]);
      for (std::size_t p = above + 1; p < begin; ++p) pattern.row.push_back(pattern.row[p]);
    } else {
      seen_by[j] = j;
      pattern.row.push_back(j);
      for (const Index g : of[j])
        for (const Index i : rows[g])
          if (i > j && seen_by[i] != j) {
            seen_by[i] = j;
            pattern.row.push_back(i);
          }
      std::sort(pattern.row.begin() + static_cast<std::ptrdiff_t>(begin) + 1, pattern.row.end());
    }
    assert(pattern.row.size() <= static_cast<std::size_t>(std::numeric_limits<Index>::max()));
    pattern.column_start.push_back(static_cast<Index>(pattern.row.size()));
  }
  return pattern;
}

ScatterMap::ScatterMap(const SymmetricPattern& pattern, const Adjacency& groups) {
  start_.resize(static_cast<std::size_t>(groups.size()) + 1);
  for (Index g = 0; g < groups.size(); ++g) {
    const std::int64_t n = groups.count(g);
    start_[g + 1] = start_[g] + n * (n + 1) / 2;
  }
  position_.resize(static_cast<std::size_t>(start_.back()));
  core::parallel_for(static_cast<std::size_t>(groups.size()), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<Index, Index>> sorted;  // unknown, place in the group
    for (std::size_t g = begin; g < end; ++g) {
      const auto group = groups[static_cast<Index>(g)];
      Index* position = position_.data() + start_[g];
      std::fill_n(position, start_[g + 1] - start_[g], Index{-1});
      sorted.clear();
      for (std::size_t k = 0; k < group.size(); ++k)
        if (group[k] >= 0) sorted.emplace_back(group[k], static_cast<Index>(k));
      std::sort(sorted.begin(), sorted.end());
      // Both the group and a column ascend: one walk down the column finds all its rows.
      for (std::size_t a = 0; a < sorted.size(); ++a) {
        Index p = pattern.column_start[sorted[a].first];
        for (std::size_t b = a; b < sorted.size(); ++b) {
          while (pattern.row[p] != sorted[b].first) ++p;
          assert(p < pattern.column_start[sorted[a].first + 1]);
          const Index low = std::min(sorted[a].second, sorted[b].second);
          const Index high = std::max(sorted[a].second, sorted[b].second);
          position[high * (high + 1) / 2 + low] = p;
        }
      }
    }
  });
}

std::size_t ScatterMap::bytes() const {
  return start_.capacity() * sizeof(start_[0]) + position_.capacity() * sizeof(position_[0]);
}

}  // namespace ashlar::algebra
