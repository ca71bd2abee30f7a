#include "elasticity/materials/drucker_prager/drucker_prager.hpp"

#include <gtest/gtest.h>

#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"
#include "plastic_checks.hpp"

namespace ashlar::elasticity {
namespace {

using model::Voigt;

struct Case {
  const char* title;
  double nu, cohesion, friction, dilation;
  Match match;
  double centre;
  std::vector<const char*> regions;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> list = {
      {"outer, non-associated", 0.25, 1e6, 30, 10, Match::outer, 0, {"elastic", "cone", "apex"}},
      {"inner, associated", 0.25, 1e6, 30, 30, Match::inner, 0, {"elastic", "cone", "apex"}},
      {"plane strain, no dilation", 0.3, 1e6, 40, 0, Match::plane_strain, 0, {"elastic", "cone", "apex"}},
      {"von Mises", 0.3, 1e6, 0, 0, Match::outer, 0, {"elastic", "cone"}},
      {"no cohesion", 0.2, 0, 30, 5, Match::plane_strain, -1e-3, {"elastic", "cone"}},
      {"nearly incompressible", 0.4999, 1e6, 30, 30, Match::plane_strain, 0, {"elastic", "cone", "apex"}}};
  return list;
}

DruckerPrager law_of(const Case& c) {
  return {isotropic(10e9, c.nu), matched(frictional(c.cohesion, c.friction, c.dilation), c.match)};
}

TEST(drucker_prager, battery_on_cone_and_apex) {
  for (const Case& c : cases()) {
    const DruckerPrager law = law_of(c);
    const auto states = testing::random_states(law, 2000, 3e-3, 11, {c.centre, c.centre, 0, c.centre});
    const testing::Battery battery = expect_battery(law, states, c.title);
    for (const char* region : c.regions)
      EXPECT_TRUE(battery.regions.contains(region)) << c.title << ": " << region;
    expect_sound(law, states);
  }
}

// The outer cone meets the pyramid where sigma_1 = sigma_2 (triaxial compression), the inner where sigma_2 =
// sigma_3.
TEST(drucker_prager, cones_meet_the_pyramid_where_they_say) {
  const FrictionalStrength strength = frictional(2, 35, 0);
  const double s = strength.sin_friction, limit = 2 * 2 * strength.cos_friction;
  const auto excess = [&](Match match, const Voigt& stress) {
    return DruckerPrager(isotropic(1, 0), matched(strength, match)).excess(stress);
  };
  for (const double first : {0.5, -1.0, -20.0}) {
    const double low = ((1 + s) * first - limit) / (1 - s);
    EXPECT_NEAR(excess(Match::outer, {first, first, 0, low}), 0, 1e-12);
    EXPECT_NEAR(excess(Match::inner, {first, low, 0, low}), 0, 1e-12);
    // In plane strain without elastic strains, flow with psi = phi fixes sigma_z: s_z = -eta sqrt(J2) 2/3.
    const Cone cone = matched(frictional(2, 35, 35), Match::plane_strain);
    const double centre = (first + low) / 2, radius = (first - low) / 2;
    const double root = radius / std::sqrt(1 - cone.eta * cone.eta / 3);
    const double z = centre - cone.eta * root;
    EXPECT_NEAR(excess(Match::plane_strain, {first, low, 0, z}), 0, 1e-12);
  }
}

TEST(drucker_prager, one_stress_by_hand) {
  // mu = 500, K = 1000/3; pure shear gamma = 0.01: sqrt(J2) = 5, p = 0; von Mises with kappa = 2 leaves tau
  // = 2.
  const DruckerPrager mises(isotropic(1000, 0), {0, 0, 2});
  std::vector<double> committed(5), trial(5);
  auto response = mises.respond({0, 0, 0.01, 0}, committed, trial);
  EXPECT_NEAR(response.stress[2], 2, 1e-14);
  EXPECT_NEAR(trial[2], 3.0 / 500, 1e-16);
  EXPECT_NEAR(response.tangent[10], 0, 1e-11);
  EXPECT_NEAR(response.tangent[0] - response.tangent[1], 2 * 500 * 2 / 5.0, 1e-11);
  // With eta = 0.3 = eta_bar: multiplier = 3/(500 + 1000/3 * 0.09) = 3/530; p = -1000/3 * 0.3 * 3/530.
  const DruckerPrager cone(isotropic(1000, 0), {0.3, 0.3, 2});
  response = cone.respond({0, 0, 0.01, 0}, committed, trial);
  EXPECT_NEAR(response.stress[2], 5 - 500 * 3 / 530.0, 1e-13);
  EXPECT_NEAR(response.stress[0], -100 * 3 / 530.0, 1e-13);
  EXPECT_NEAR(response.stress[3], -100 * 3 / 530.0, 1e-13);
}

TEST(drucker_prager, any_parameters_and_any_strain_give_an_answer) {
  for (const double nu : {-0.9, 0.0, 0.3, 0.4999999})
    for (const double cohesion : {0.0, 1.0, 1e6})
      for (const double friction : {0.0, 1e-6, 30.0, 89.0})
        for (const double dilation : {0.0, 0.5, 1.0})
          for (const Match match : {Match::outer, Match::inner, Match::plane_strain}) {
            if (cohesion == 0 && friction == 0) continue;
            const DruckerPrager law(isotropic(10e9, nu),
                                    matched(frictional(cohesion, friction, dilation * friction), match));
            for (const double size : {1e-9, 1e-4, 1.0})
              expect_sound(law, testing::random_states(law, 12, size, 3), 1e-10);
            ASSERT_FALSE(HasFailure()) << nu << ' ' << cohesion << ' ' << friction << ' ' << dilation;
          }
}

}  // namespace
}  // namespace ashlar::elasticity
