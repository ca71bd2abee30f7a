// Scenes with a closed form through the whole program.

#include <gtest/gtest.h>

#include "support/scene_run.hpp"

namespace ashlar::test {
namespace {

constexpr double e = 10e9, nu = 0.3;

// Round-off of a few hundred unknowns; all these solutions lie in the elements' own space at the mesh points.
constexpr double round_off = 1e-11;

std::filesystem::path scene(const std::string& name) {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "crosscheck" / "scenes" / (name + ".lua");
}

TEST(ClosedForm, a_column_between_smooth_walls_settles_by_its_weight) {
  // One-dimensional: M u'' = γ, u(0) = 0, u'(H) = 0. Linear elements are exact at the nodes of any spacing.
  const double modulus = e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), weight = 24e3, height = 12;
  const double settlement = weight * height * height / (2 * modulus);
  const SceneRun run = run_scene(scene("column"));
  EXPECT_NEAR(run.value("self-weight", "top", "uy"), -settlement, round_off * settlement);
  EXPECT_NEAR(run.value("self-weight", "top", "ux"), 0, round_off * settlement);
}

void expect_uniform(const std::string& mesh, bool joint) {
  // Free sides: ε_y = −p/E', ε_x = p ν (1+ν)/E. The penalty's penetration p/k lowers what stands on the
  // joint.
  const double p = 1e6, width = 4, height = 3, penetration = joint ? p / 2e9 : 0;
  const double down = p * (1 - nu * nu) / e * height + penetration, out = p * nu * (1 + nu) / e * width;
  const SceneRun run = run_scene(scene("block"), {{"mesh", mesh}, {"joint", joint ? "true" : "false"}});
  EXPECT_NEAR(run.value("pressure", "corner", "uy"), -down, round_off * down) << mesh;
  EXPECT_NEAR(run.value("pressure", "corner", "ux"), out, round_off * down) << mesh;
  if (joint) {
    EXPECT_NEAR(run.stage("pressure").joints.at(0).normal_force, p * width, round_off * p * width) << mesh;
  }
}

TEST(ClosedForm, a_block_under_pressure_deforms_uniformly_on_any_mesh) {
  expect_uniform("voronoi", false);
  expect_uniform("quads", false);
}

TEST(ClosedForm, a_joint_across_the_block_passes_the_pressure_and_adds_its_penetration) {
  expect_uniform("voronoi", true);
  expect_uniform("quads", true);
}

}  // namespace
}  // namespace ashlar::test
