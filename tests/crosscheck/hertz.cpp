// The pressure of examples/hertz: the stored reference against CalculiX, and Ashlar against the reference.

#include <gtest/gtest.h>

#include <cmath>

#include "crosscheck/calculix.hpp"
#include "crosscheck/hertz_reference.hpp"

namespace ashlar::test {
namespace {

constexpr Loading loadings[] = {Loading::flat_top, Loading::pole};

void print(const std::string& what, Loading loading, double peak, const Apart& away) {
  std::printf(
      "%-19s %-8s peak %7.3f Pa, apart %6.3f %% to 1.1 m, %6.3f %% to 0.9 a, %6.3f %% beyond, %6.3f %% in "
      "L2\n",
      what.c_str(), name_of(loading).c_str(), peak, 100 * away.inner, 100 * away.inside, 100 * away.edge,
      100 * away.l2);
}

TEST(Hertz, calculix_gives_the_stored_reference_at_twice_its_spacing) {
  if (!has_calculix()) GTEST_SKIP() << "ccx is not installed (Debian package calculix-ccx)";
  const auto folder = std::filesystem::path(testing::TempDir()) / "ashlar_hertz";
  const Profiles stored = stored_reference();
  for (const Loading loading : loadings) {
    const Profile& fine = stored.at(loading);
    // Pairs must close, and pairs must open.
    const double first_guess = loading == Loading::flat_top ? 1.2 : 1.8;
    const HertzReference coarse = compute_hertz(loading, 0.05, folder / name_of(loading), first_guess);
    const Apart away = apart(coarse.profile, fine);
    print("CalculiX, 50 mm", loading, coarse.profile.peak(), away);
    EXPECT_NEAR(coarse.force, 100, 1e-5) << "CalculiX prints seven digits";
    EXPECT_NEAR(coarse.profile.peak() / fine.peak(), 1, 1e-4);
    EXPECT_LT(away.inner, 2e-4);
    EXPECT_LT(away.inside, 2e-3);
    // One pair more or less is closed: 25 mm of an upright end.
    EXPECT_LT(away.l2, 0.04);
  }
}

TEST(Hertz, the_stored_reference_carries_the_load_and_lies_beside_theory_as_said) {
  const Profiles stored = stored_reference();
  EXPECT_NEAR(stored.at(Loading::flat_top).peak(), 83.127, 5e-4);
  EXPECT_NEAR(stored.at(Loading::pole).peak(), 83.961, 5e-4);
  for (const Loading loading : loadings) {
    const Profile& profile = stored.at(loading);
    EXPECT_NEAR(profile.force(), 100, 0.1) << "straight between points; the end is upright";
    EXPECT_NEAR(profile.peak() / hertz_pressure(0), loading == Loading::pole ? 1.0043 : 0.9943, 1e-4);
    for (std::size_t i = 0; i < profile.x.size() && profile.x[i] <= 1.1; ++i)
      EXPECT_NEAR(profile.p[i] / profile.peak(), hertz_pressure(profile.x[i]) / hertz_pressure(0), 0.008)
          << profile.x[i];
  }
}

struct Bounds {
  int order, cells;
  double peak, inner, inside, edge, l2;
};
// A tenth above what was measured. A node is closed or open, so the edge of the contact moves by cells, and
// the pressures of the nodes before it swing about the true ones: inwards less and less, by chance more or
// less.
constexpr Bounds bounds[] = {
    {1, 389, 0.007, 0.013, 0.020, 0.053, 0.046},    {1, 600, 0.001, 0.0045, 0.012, 0.018, 0.037},
    {1, 1155, 0.0013, 0.0053, 0.026, 0.051, 0.019}, {2, 389, 0.0006, 0.0074, 0.0081, 0.019, 0.0155},
    {2, 600, 0.0003, 0.0038, 0.018, 0.088, 0.017},  {2, 1155, 0.0004, 0.0022, 0.044, 0.063, 0.015}};

TEST(Hertz, pressure_follows_the_reference_at_all_sizes_and_orders) {
  const Profiles stored = stored_reference();
  for (const Loading loading : loadings)
    for (const Bounds& most : bounds) {
      const HertzRun run = run_hertz(loading, most.cells, most.order);
      const Profile& reference = stored.at(loading);
      const Apart away = apart(run.profile, reference);
      const std::string what = std::to_string(run.cells) + " cells, order " + std::to_string(most.order);
      print(what, loading, run.max_pressure, away);
      EXPECT_NEAR(run.max_pressure / reference.peak(), 1, most.peak) << what;
      EXPECT_LT(away.inner, most.inner) << what;
      EXPECT_LT(away.inside, most.inside) << what;
      EXPECT_LT(away.edge, most.edge) << what;
      EXPECT_LT(away.l2, most.l2) << what;
    }
}

}  // namespace
}  // namespace ashlar::test
