#include "elasticity/materials/orthotropic/orthotropic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "elasticity/materials/elastic/elastic.hpp"
#include "settings.hpp"
#include "testing/law_battery.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;
using model::Voigt;

const OrthotropicModuli bedded{20e9, 8e9, 15e9, 0.25, 0.2, 0.1, 4e9, 0.5};

OrthotropicModuli at_angle(double bedding) {
  OrthotropicModuli moduli = bedded;
  moduli.bedding = bedding;
  return moduli;
}

TEST(orthotropic, battery) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Orthotropic law(bedded, plane);
    const auto battery = testing::run_battery(law, testing::random_states(law, 200, 1e-2, 5));
    EXPECT_LE(battery.worst_tangent, 1e-9) << battery.worst_state;
    EXPECT_LE(battery.worst_symmetry, 1e-15);
    EXPECT_EQ(battery.kinks + battery.impure + battery.not_finite, 0);
  }
}

TEST(orthotropic, isotropic_moduli_give_the_isotropic_law) {
  const double e = 3e9, nu = 0.3;
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Orthotropic bedding({e, e, e, nu, nu, nu, e / (2 * (1 + nu)), 0.4}, plane);
    const Elastic plain(e, nu, plane);
    for (const auto& state : testing::random_states(plain, 20, 1e-3, 1)) {
      const auto a = bedding.respond(state.strain, {}, {}), b = plain.respond(state.strain, {}, {});
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(a.stress[i], b.stress[i], 1e-9 * e * 1e-3);
    }
    EXPECT_NEAR(bedding.shear_modulus(), plain.shear_modulus(), 1e-6);
    EXPECT_NEAR(bedding.plane_modulus(), plain.plane_modulus(), 1e-5);
  }
}

// Back to strains along the axes by the compliances, ν_ij/E_i = ν_ji/E_j.
TEST(orthotropic, strains_come_back_by_the_compliances) {
  const Orthotropic law(at_angle(0), Plane::strain);
  const Voigt strain{1e-3, -4e-4, 6e-4, 2e-4};
  const auto s = law.respond(strain, {}, {}).stress;
  EXPECT_NEAR(s[0] / 20e9 - 0.25 * s[1] / 20e9 - 0.2 * s[3] / 20e9, strain[0], 1e-17);
  EXPECT_NEAR(-0.25 * s[0] / 20e9 + s[1] / 8e9 - 0.1 * s[3] / 8e9, strain[1], 1e-17);
  EXPECT_NEAR(-0.2 * s[0] / 20e9 - 0.1 * s[1] / 8e9 + s[3] / 15e9, strain[3], 1e-17);
  EXPECT_NEAR(s[2], 4e9 * 6e-4, 1e-6);
  const auto flat = Orthotropic(at_angle(0), Plane::stress).respond(strain, {}, {}).stress;
  EXPECT_NEAR(flat[0] / 20e9 - 0.25 * flat[1] / 20e9, strain[0], 1e-17);
  EXPECT_EQ(flat[3], 0);
}

// The law does not know its axes but by the bedding: turning both leaves the same answer, turned.
TEST(orthotropic, bedding_turns_with_the_body) {
  const Voigt strain{1e-3, -4e-4, 6e-4, 2e-4};
  for (const double angle : {0.3, 1.2, -2.0}) {
    const auto expected =
        testing::turned_stress(Orthotropic(at_angle(0), Plane::strain).respond(strain, {}, {}).stress, angle);
    const auto got = Orthotropic(at_angle(angle), Plane::strain)
                         .respond(testing::turned_strain(strain, angle), {}, {})
                         .stress;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(got[i], expected[i], 1e-6);
  }
  // A quarter turn puts the soft axis along x: stretched in x, it carries less.
  const Voigt pull{1e-3, 0, 0, 0};
  EXPECT_LT(Orthotropic(at_angle(std::numbers::pi / 2), Plane::strain).respond(pull, {}, {}).stress[0],
            0.6 * Orthotropic(at_angle(0), Plane::strain).respond(pull, {}, {}).stress[0]);
}

core::Settings said(double nu12, std::optional<double> nu13 = {}, double bedding = 0.5) {
  return settings_of("orthotropic", {{"E1", 20e9},
                                     {"E2", 5e9},
                                     {"G12", 4e9},
                                     {"nu12", nu12},
                                     {"E3", {}},
                                     {"nu13", nu13},
                                     {"nu23", {}},
                                     {"bedding", bedding},
                                     {"unit_weight", 25e3},
                                     {"density", {}}});
}

TEST(orthotropic, moduli_without_energy_are_refused_with_their_place) {
  core::Mistakes none;
  const auto sound = make_orthotropic(said(0.3), Plane::strain, none);
  ASSERT_TRUE(sound);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(sound->unit_weight(9.81), 25e3);
  const auto expect = [](const core::Settings& settings, Plane plane, const char* path, const char* words) {
    core::Mistakes mistakes;
    EXPECT_FALSE(make_orthotropic(settings, plane, mistakes));
    ASSERT_EQ(mistakes.list().size(), 1u) << words;
    EXPECT_EQ(mistakes.list()[0].place.path, path);
    EXPECT_NE((mistakes.list()[0].what + mistakes.list()[0].advice).find(words), std::string::npos)
        << mistakes.list()[0].what << mistakes.list()[0].advice;
  };
  // sqrt(E1/E2) = 2
  expect(said(2.01, 0.1), Plane::stress, "nu12", "between -2 and 2");
  expect(said(0.3, 1.0), Plane::strain, "nu13", "between -1 and 1");
  expect(said(1.3, 0.9), Plane::strain, "nu12", "together with nu13");
  expect(said(0.3, {}, 30), Plane::strain, "bedding", "30*units.deg");
}

}  // namespace
}  // namespace ashlar::elasticity
