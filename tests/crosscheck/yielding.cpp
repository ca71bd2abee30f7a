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

std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "examples" / name;
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

struct Tube {
  const char *plane, *element, *order, *cells;
  double elastic, yields;  ///< greatest relative errors of the displacements
};

class ThickTube : public testing::TestWithParam<Tube> {
 protected:
  /// Displacements inside and outside over the exact ones, less 1.
  double error(const std::string& yields, const std::string& pressure, double inside, double outside) const {
    const Tube& tube = GetParam();
    const SceneRun run = run_scene(example("thick_tube"), {{"plane", tube.plane},
                                                           {"element", tube.element},
                                                           {"order", tube.order},
                                                           {"cells", tube.cells},
                                                           {"yields", yields},
                                                           {"pressure", pressure}});
    const double a = run.value("pressure", "inside", "ux") / inside - 1;
    const double b = run.value("pressure", "outside", "ux") / outside - 1;
    std::printf("%s, %s of order %s, %s, %s: inside %+.1e, outside %+.1e\n", tube.plane, tube.element,
                tube.order, tube.cells, yields == "true" ? "Hill" : "Lamé", a, b);
    return std::max(std::abs(a), std::abs(b));
  }
};

constexpr double tube_e = 20e9, tube_nu = 0.3;

// Lamé in plane strain, radii 1 and 2 m, p = 10 MPa: u = (1+ν) p a²/(E (b²−a²)) ((1−2ν) r + b²/r).
TEST_P(ThickTube, deforms_as_lame_says) {
  const auto u = [](double r) {
    return (1 + tube_nu) * 10e6 / (tube_e * 3) * ((1 - 2 * tube_nu) * r + 4 / r);
  };
  EXPECT_LT(error("false", "10*units.MPa", u(1), u(2)), GetParam().elastic);
}

// Hill, The Mathematical Theory of Plasticity (1950), ch. V: Tresca with Y = 2c, yielding to the radius ρ.
//   p = Y (ln ρ/a + (1 − ρ²/b²)/2),   u = (1+ν)(1−2ν) r σ_r/E + (1−ν²) Y ρ²/(E r)
TEST_P(ThickTube, yields_as_hill_says) {
  const double y = 20e6, rho = 1.5, p = y * (std::log(rho) + 0.5 * (1 - rho * rho / 4));
  const auto u = [&](double r, double radial) {
    return (1 + tube_nu) * (1 - 2 * tube_nu) * r * radial / tube_e +
           (1 - tube_nu * tube_nu) * y * rho * rho / (tube_e * r);
  };
  EXPECT_LT(error("true", std::to_string(p), u(1, -p), u(2, 0)), GetParam().yields);
}

// In plane strain the circles are drawn with chords of 0.1 m: a polygon's wall is thinner than the ring's.
INSTANTIATE_TEST_SUITE_P(Tubes, ThickTube,
                         testing::Values(Tube{"axisymmetric", "vem", "1", "quads", 1e-9, 5e-3},
                                         Tube{"axisymmetric", "vem", "1", "voronoi", 2e-3, 8e-3},
                                         Tube{"axisymmetric", "vem", "2", "voronoi", 1e-3, 2e-4},
                                         Tube{"axisymmetric", "vem", "3", "quads", 1e-4, 5e-5},
                                         Tube{"axisymmetric", "fem", "2", "quads", 1e-5, 1e-4},
                                         Tube{"strain", "vem", "1", "voronoi", 5e-3, 2e-2},
                                         Tube{"strain", "vem", "2", "voronoi", 4e-3, 4e-3}),
                         [](const auto& info) {
                           const Tube& tube = info.param;
                           return std::string(tube.plane) + "_" + tube.element + tube.order + "_" +
                                  tube.cells;
                         });

// Prandtl (1920): a strip footing on weightless Tresca soil carries (2 + π) c, from above as these elements
// find it.
TEST(Prandtl, a_strip_footing_carries_its_limit_load) {
  const SceneRun run = run_scene(example("strip_footing"), {{"fine", "0.03*units.m"}});
  const model::StageResult& stage = run.stage("push");
  const auto footing = std::ranges::find_if(stage.balance.reactions,
                                            [](const auto& reaction) { return reaction.first == "footing"; });
  ASSERT_NE(footing, stage.balance.reactions.end());
  const double limit = -footing->second.y / 0.5 / 10e3, exact = 2 + std::numbers::pi;
  std::printf("order 2, %d cells: %.4f c, %+.2f %%\n", run.model.mesh.cell_count(), limit,
              100 * (limit / exact - 1));
  EXPECT_GT(limit, exact);
  EXPECT_LT(limit, 1.02 * exact);
}

}  // namespace
}  // namespace ashlar::test
