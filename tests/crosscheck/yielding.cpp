// Bodies that yield, through the whole program: closed forms, and how Newton converges.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/scene_run.hpp"

namespace ashlar::test {
namespace {

std::filesystem::path scene(const std::string& name) {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "crosscheck" / "scenes" / (name + ".lua");
}

struct Choice {
  const char *element, *order, *dilation;
};

class Yields : public testing::TestWithParam<Choice> {};

// Uniaxial stress in plane strain: σ_yy = −2 c cos φ/(1 − sin φ), σ_zz = ν σ_yy between the two. The rest of
// the plate's way is plastic, and ε_xx^p = −ε_yy^p (1 + sin ψ)/(1 − sin ψ).
TEST_P(Yields, at_the_uniaxial_strength_with_the_flow_of_its_dilation) {
  const double e = 10e6, nu = 0.3, c = 10e3, phi = std::numbers::pi / 6, way = 0.02;
  const double psi = std::stod(GetParam().dilation) * std::numbers::pi / 180;
  const double strength = 2 * c * std::cos(phi) / (1 - std::sin(phi));
  const SceneRun run =
      run_scene(scene("yield"), {{"element", GetParam().element},
                                 {"order", GetParam().order},
                                 {"dilation", std::string(GetParam().dilation) + "*units.deg"}});
  const model::StageResult& stage = run.stage("press");
  const auto top = std::ranges::find_if(stage.balance.reactions,
                                        [](const auto& reaction) { return reaction.first == "soil.top"; });
  ASSERT_NE(top, stage.balance.reactions.end());
  EXPECT_NEAR(top->second.y, -strength, 1e-8 * strength);
  EXPECT_NEAR(top->second.moment, -0.5 * strength, 1e-8 * strength);
  const double plastic = way - (1 - nu * nu) / e * strength;
  const double wide = nu * (1 + nu) / e * strength + plastic * (1 + std::sin(psi)) / (1 - std::sin(psi));
  EXPECT_NEAR(run.value("press", "corner", "ux"), wide, 1e-7 * wide);
  EXPECT_LT(stage.balance.relative_error, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Elements, Yields,
                         testing::Values(Choice{"vem", "1", "0"}, Choice{"vem", "1", "30"},
                                         Choice{"vem", "2", "10"}, Choice{"vem", "2", "30"},
                                         Choice{"vem", "3", "0"}, Choice{"fem", "1", "10"},
                                         Choice{"fem", "2", "0"}),
                         [](const auto& info) {
                           return std::string(info.param.element) + info.param.order + "_dilation_" +
                                  info.param.dilation;
                         });

TEST(Yielding, a_load_beyond_the_strength_stops_with_what_was_reached) {
  try {
    run_scene(scene("yield"), {{"pressure", "50*units.kPa"}});
    FAIL() << "50 kPa were carried";
  } catch (const std::runtime_error& error) {
    // 34.64 of 50 kPa; steps of 1/64 find it from below.
    const std::string said = error.what();
    const auto at = said.find("(reached ");
    ASSERT_NE(at, std::string::npos) << said;
    const double reached = std::stod(said.substr(at + 9));
    EXPECT_GE(reached, 66) << said;
    EXPECT_LE(reached, 69.3) << said;
  }
}

class Footing : public testing::TestWithParam<const char*> {};

TEST_P(Footing, newton_converges_quadratically) {
  const SceneRun run = run_scene(scene("footing"), {{"order", GetParam()}});
  const model::StageResult& stage = run.stage("push");
  ASSERT_GT(stage.iterations.size(), 3u);
  int steps = 0, quadratic = 0;
  for (std::size_t i = 1; i < stage.iterations.size(); ++i) {
    const model::Iteration& now = stage.iterations[i];
    const bool last = i + 1 == stage.iterations.size() || stage.iterations[i + 1].number == 1;
    if (!last || now.number < 3 || now.residual > 1e-10) continue;
    const double before = stage.iterations[i - 1].residual;
    std::printf("order %s, step %d: residual %.1e → %.1e\n", GetParam(), now.step, before, now.residual);
    ++steps;
    // The last step gains nearly twice the digits, down to round-off.
    if (now.residual <= std::max(1e-11, std::pow(before, 1.6))) ++quadratic;
  }
  EXPECT_GT(steps, 0);
  EXPECT_EQ(quadratic, steps);
  EXPECT_LT(stage.balance.relative_error, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Orders, Footing, testing::Values("1", "2"),
                         [](const auto& info) { return std::string("order") + info.param; });

}  // namespace
}  // namespace ashlar::test
