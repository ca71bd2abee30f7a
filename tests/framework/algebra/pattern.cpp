#include <gtest/gtest.h>

#include <set>

#include "framework/algebra/grids.hpp"

namespace ashlar::algebra {
namespace {

using testing::quad_groups;
using testing::quad_unknowns;

std::set<std::pair<Index, Index>> pairs(const Adjacency& groups) {
  std::set<std::pair<Index, Index>> found;
  for (Index g = 0; g < groups.size(); ++g)
    for (const Index i : groups[g])
      for (const Index j : groups[g])
        if (j >= 0 && i >= j) found.emplace(j, i);
  return found;
}

TEST(pattern, holds_every_coupled_pair_once_and_in_order) {
  const Adjacency groups = quad_groups(5, 3, 7);
  const Adjacency* lists[] = {&groups};
  const Index size = quad_unknowns(5, 3, 7);
  const SymmetricPattern pattern = make_pattern(size, lists);
  ASSERT_EQ(pattern.size, size);
  ASSERT_EQ(pattern.column_start.size(), static_cast<std::size_t>(size) + 1);
  std::vector<std::pair<Index, Index>> listed;
  for (Index j = 0; j < size; ++j) {
    EXPECT_EQ(pattern.row[pattern.column_start[j]], j);
    for (Index p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p)
      listed.emplace_back(j, pattern.row[p]);
  }
  const auto expected = pairs(groups);
  EXPECT_TRUE(std::ranges::equal(listed, expected));
}

TEST(pattern, joins_several_lists_and_keeps_lonely_diagonals) {
  Adjacency first, second;
  first.append(std::vector<Index>{4, 0, -1});
  second.append(std::vector<Index>{0, 2});
  second.append(std::vector<Index>{2, 4});
  const Adjacency* lists[] = {&first, &second};
  const SymmetricPattern pattern = make_pattern(5, lists);
  EXPECT_EQ(pattern.row, (std::vector<Index>{0, 2, 4, 1, 2, 4, 3, 4}));
  EXPECT_EQ(pattern.column_start, (std::vector<Index>{0, 3, 4, 6, 7, 8}));
}

// Neighbouring unknowns that share all groups take the short cut; those that share some must not.
TEST(pattern, tells_unknowns_of_different_groups_apart) {
  Adjacency groups;
  groups.append(std::vector<Index>{0, 1, 3});
  groups.append(std::vector<Index>{1, 2, 3});
  const Adjacency* lists[] = {&groups};
  EXPECT_EQ(make_pattern(4, lists).row, (std::vector<Index>{0, 1, 3, 1, 2, 3, 2, 3, 3}));
}

TEST(scatter_map, finds_the_place_of_every_packed_entry) {
  Adjacency groups;
  groups.append(std::vector<Index>{5, 2, -1, 3});
  groups.append(std::vector<Index>{0, 1, 2});
  const Adjacency* lists[] = {&groups};
  const SymmetricPattern pattern = make_pattern(6, lists);
  const ScatterMap map(pattern, groups);
  ASSERT_EQ(map.size(), 2);
  for (Index g = 0; g < 2; ++g) {
    const auto group = groups[g];
    std::size_t k = 0;
    for (std::size_t r = 0; r < group.size(); ++r)
      for (std::size_t c = 0; c <= r; ++c, ++k) {
        const Index position = map[g][k];
        if (group[r] < 0 || group[c] < 0) {
          EXPECT_EQ(position, -1);
          continue;
        }
        EXPECT_EQ(pattern.row[position], std::max(group[r], group[c]));
        const Index column = std::min(group[r], group[c]);
        EXPECT_GE(position, pattern.column_start[column]);
        EXPECT_LT(position, pattern.column_start[column + 1]);
      }
    EXPECT_EQ(k, map[g].size());
  }
}

}  // namespace
}  // namespace ashlar::algebra
