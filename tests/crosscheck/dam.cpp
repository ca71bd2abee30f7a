// The jointed dam against CalculiX on the same two meshes of quadrilaterals. README.md has finer ones.

#include <gtest/gtest.h>

#include "crosscheck/compare.hpp"

namespace ashlar::test {
namespace {

TEST(Crosscheck, the_jointed_dam_agrees_with_calculix_within_the_discretisation_error) {
  if (!has_calculix()) GTEST_SKIP() << "ccx is not installed (Debian package calculix-ccx)";
  const auto folder = std::filesystem::path(testing::TempDir()) / "ashlar_crosscheck";
  const Comparison coarse = compare_dam(500, folder), fine = compare_dam(2000, folder);

  // What halving the cells changed in each program: the error of the finer mesh where convergence is of first
  // order, as joint tip and heel make it.
  const double our_error = relative_difference(coarse.ours, fine.ours);
  const double their_error = relative_difference(coarse.theirs, fine.theirs);
  const double apart = relative_difference(fine.ours, fine.theirs);
  EXPECT_LT(apart, std::max(our_error, their_error));
  EXPECT_LT(apart, relative_difference(coarse.ours, coarse.theirs)) << "refining must bring them together";
  // The estimates must mean something: 2 % of error would hide a wrong load.
  EXPECT_LT(std::max(our_error, their_error), 0.02);
}

}  // namespace
}  // namespace ashlar::test
