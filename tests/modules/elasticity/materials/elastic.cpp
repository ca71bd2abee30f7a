#include "elasticity/materials/elastic/elastic.hpp"

#include <gtest/gtest.h>

#include "settings.hpp"
#include "testing/law_battery.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;

TEST(elastic, plane_strain_agrees_with_hooke_in_three_dimensions) {
  const double e = 10, nu = 0.3;
  const Elastic law(e, nu, Plane::strain);
  const auto r = law.respond({0.01, -0.004, 0.006}, {}, {});
  // Back to strains: ε = (1+ν)/E σ − ν/E tr σ, with ε_zz = 0.
  const double trace = r.stress[0] + r.stress[1] + r.stress[3];
  EXPECT_NEAR((1 + nu) / e * r.stress[0] - nu / e * trace, 0.01, 1e-15);
  EXPECT_NEAR((1 + nu) / e * r.stress[1] - nu / e * trace, -0.004, 1e-15);
  EXPECT_NEAR((1 + nu) / e * r.stress[3] - nu / e * trace, 0, 1e-15);
  EXPECT_NEAR(2 * (1 + nu) / e * r.stress[2], 0.006, 1e-15);
  EXPECT_NEAR(law.plane_modulus(), e / (1 - nu * nu), 1e-14);
}

TEST(elastic, plane_stress_agrees_with_hooke_in_three_dimensions) {
  const double e = 10, nu = 0.3;
  const Elastic law(e, nu, Plane::stress);
  const auto r = law.respond({0.01, -0.004, 0.006}, {}, {});
  EXPECT_EQ(r.stress[3], 0);
  EXPECT_NEAR((r.stress[0] - nu * r.stress[1]) / e, 0.01, 1e-15);
  EXPECT_NEAR((r.stress[1] - nu * r.stress[0]) / e, -0.004, 1e-15);
  EXPECT_NEAR(law.plane_modulus(), e, 1e-14);
  EXPECT_NEAR(law.shear_modulus(), e / 2.6, 1e-14);
}

TEST(elastic, battery) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Elastic law(7, 0.2, plane);
    const auto states = testing::random_states(law, 200, 1e-2, 3);
    const auto battery = testing::run_battery(law, states);
    EXPECT_LE(battery.worst_tangent, 1e-9) << battery.worst_state;
    EXPECT_LE(battery.worst_symmetry, 1e-15);
    EXPECT_EQ(battery.kinks + battery.impure + battery.not_finite, 0);
    for (const auto& state : states) EXPECT_LE(testing::objectivity_error(law, state, 0.7), 1e-14);
  }
}

TEST(elastic, weight_comes_from_unit_weight_or_density) {
  EXPECT_EQ(Elastic(1, 0, Plane::strain).unit_weight(9.81), -1);
  EXPECT_EQ(Elastic(1, 0, Plane::strain, {24e3, {}}).unit_weight(3), 24e3);
  EXPECT_EQ(Elastic(1, 0, Plane::strain, {{}, 2400.0}).unit_weight(10), 24e3);
}

core::Settings settings(double nu, bool unit_weight, bool density) {
  return settings_of("elastic", {{"E", 1e9},
                                 {"nu", nu},
                                 {"unit_weight", unit_weight ? std::optional(24e3) : std::nullopt},
                                 {"density", density ? std::optional(2400.0) : std::nullopt},
                                 {"cohesion", {}},
                                 {"friction", {}},
                                 {"tensile_strength", {}}});
}

TEST(elastic, refuses_what_has_no_solution_and_says_where) {
  core::Mistakes mistakes;
  EXPECT_TRUE(make_elastic(settings(0.5, true, false), Plane::stress, mistakes));
  EXPECT_TRUE(make_elastic(settings(0.4999, false, true), Plane::strain, mistakes));
  EXPECT_TRUE(mistakes.empty());
  EXPECT_FALSE(make_elastic(settings(0.5, true, false), Plane::strain, mistakes));
  ASSERT_EQ(mistakes.list().size(), 1u);
  EXPECT_EQ(mistakes.list()[0].place.path, "nu");
}

}  // namespace
}  // namespace ashlar::elasticity
