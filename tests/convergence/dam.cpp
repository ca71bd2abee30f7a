// The jointed dam settles as its mesh is refined. README.md has finer meshes.

#include <gtest/gtest.h>

#include "convergence/dam_numbers.hpp"

namespace ashlar::test {
namespace {

class Settles : public testing::TestWithParam<const char*> {};

TEST_P(Settles, the_jointed_dam) {
  const auto coarse = dam_numbers(GetParam(), 500), medium = dam_numbers(GetParam(), 2000),
             fine = dam_numbers(GetParam(), 8000);
  for (std::size_t stage = 0; stage < fine.size(); ++stage) {
    SCOPED_TRACE(fine[stage].stage);
    const double first = relative_change(coarse[stage], medium[stage]);
    const double second = relative_change(medium[stage], fine[stage]);
    // Halving h divides the change by 1.4 (points in re-entrant corners) to 2; random meshes scatter about
    // that.
    EXPECT_LT(second, 0.85 * first);
    // Triangles of order 1 are stiff and change most; 4 % would hide a wrong load.
    EXPECT_LT(second, 0.04);
    // The tip is singular: a stress that stays the same means a mesh that does not get finer there.
    EXPECT_GT(fine[stage].peak, medium[stage].peak);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Settles, testing::Values("voronoi", "quads", "triangles"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace ashlar::test
