// Round borders: chords follow the cells, so that results converge to those of the circle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/scene_run.hpp"

namespace ashlar::test {
namespace {

std::filesystem::path scene(const std::string& name) {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "convergence" / "scenes" / (name + ".lua");
}

/// Relative errors at the hole's edge.
struct AtHole {
  double side = 0, crown = 0, stress = 0;
};

// Kirsch (1898), plane strain, hole of radius a: u_r(a, θ) = σ a/E' (1 + 2 cos 2θ); at the crown σ_xx = 3 σ.
AtHole errors(const std::string& mesh, double h) {
  constexpr double pull = 1e6, stiff = 10e9 / (1 - 0.3 * 0.3);
  const SceneRun run = run_scene(scene("kirsch"), {{"mesh", mesh}, {"h", std::to_string(h)}});
  const auto off = [&](const char* probe, const char* quantity, double exact) {
    return std::abs(run.value("pull", probe, quantity) / exact - 1);
  };
  return {off("side", "ux", 3 * pull / stiff), off("crown", "uy", -pull / stiff),
          off("crown", "sxx", 3 * pull)};
}

class Hole : public testing::TestWithParam<const char*> {};

TEST_P(Hole, opens_as_kirsch_says) {
  const AtHole coarse = errors(GetParam(), 0.4), fine = errors(GetParam(), 0.05);
  std::printf(
      "%s, size 0.4 → 0.05 of the radius: error of u at the side %.2f → %.2f %%, at the crown %.2f → %.2f "
      "%%, "
      "of its stress %.1f → %.1f %%\n",
      GetParam(), 100 * coarse.side, 100 * fine.side, 100 * coarse.crown, 100 * fine.crown,
      100 * coarse.stress, 100 * fine.stress);
  // Eight times finer: displacements could gain 64 times, one value in random cells gains at least 6.
  EXPECT_LT(fine.side, std::min(0.002, coarse.side / 6));
  EXPECT_LT(fine.crown, std::min(0.002, coarse.crown / 6));
  // The stress at a border node is of first order.
  EXPECT_LT(fine.stress, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Hole, testing::Values("voronoi", "quads"),
                         [](const auto& info) { return std::string(info.param); });

/// Relative error of the plug's contact force.
double plug_error(double h) {
  constexpr double pressure = 1e6;
  const SceneRun run = run_scene(scene("plug"), {{"h", std::to_string(h)}});
  const model::JointResult& rim = run.stage("press").joints.at(0);
  EXPECT_EQ(rim.closed, rim.points);
  for (const auto& row : rim.rows) EXPECT_NEAR(row.pressure, pressure, 1e-3 * pressure);
  return std::abs(rim.normal_force / (pressure * std::numbers::pi / 2) - 1);
}

// Equal pressure from all sides is an exact state of plug and block; only the kinks between chords disturb
// it, and chords are shorter than their arc by (angle)²/24.
TEST(Plug, feels_the_same_pressure_all_round) {
  const double coarse = plug_error(0.2), fine = plug_error(0.05);
  std::printf("contact force: error %.3f → %.3f %%\n", 100 * coarse, 100 * fine);
  EXPECT_LT(coarse, 0.003);
  EXPECT_LT(fine, coarse / 4);
}

}  // namespace
}  // namespace ashlar::test
