// Laws led along paths whose end is known in closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "elasticity/materials/drucker_prager/drucker_prager.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"
#include "plastic_checks.hpp"
#include "solve/drive.hpp"

namespace ashlar::elasticity {
namespace {

using model::Leg;
using model::Plane;

constexpr double e = 10e9, nu = 0.3, cohesion = 1e6, friction = 30;
const double sine = std::sin(friction * degree), cosine = std::cos(friction * degree);
const double unconfined = 2 * cohesion * cosine / (1 - sine);

solve::DriveResult led(std::shared_ptr<const model::Material> law, std::vector<Leg> legs, int steps = 40) {
  model::Drive drive;
  drive.material = std::move(law);
  drive.legs = std::move(legs);
  drive.steps = steps;
  return solve::drive(drive);
}

std::shared_ptr<const MohrCoulomb> rock(double dilation, double tension = -1) {
  const FrictionalStrength shear = frictional(cohesion, friction, dilation);
  return std::make_shared<MohrCoulomb>(
      isotropic(e, nu), mohr_coulomb::Strength{shear, tension < 0 ? greatest_tension(shear) : tension});
}

Leg leg(std::optional<double> yy, std::optional<double> sxx, std::optional<double> szz = {}) {
  Leg made;
  made.strain[1] = yy;
  made.stress[0] = sxx;
  made.stress[3] = szz;
  return made;
}

TEST(paths, elastic_law_gives_youngs_modulus_and_poissons_ratio) {
  const auto result = led(std::make_shared<Elastic>(e, nu, Plane::strain), {leg(-1e-3, 0, 0)}, 4);
  ASSERT_TRUE(result.converged);
  const auto& end = result.points.back();
  EXPECT_NEAR(end.stress[1], -1e-3 * e, 1e-6);
  EXPECT_NEAR(end.strain[0], nu * 1e-3, 1e-15);
  EXPECT_NEAR(end.strain[3], nu * 1e-3, 1e-15);
}

TEST(paths, uniaxial_compression_ends_at_the_unconfined_strength) {
  for (const double dilation : {0.0, 10.0, 30.0}) {
    const auto result = led(rock(dilation), {leg(-2 * unconfined / e, 0, 0)});
    ASSERT_TRUE(result.converged) << result.reason;
    for (const auto& point : result.points)
      EXPECT_NEAR(point.stress[1], std::max(e * point.strain[1], -unconfined), 1e-6 * unconfined)
          << point.step;
  }
}

// Dilation: in triaxial compression the plastic volume grows by 2 sin ψ/(1 − sin ψ) of the plastic
// shortening.
TEST(paths, triaxial_compression_dilates_by_its_angle) {
  for (const double dilation : {0.0, 10.0, 30.0}) {
    const double cell = 2e6, strength = unconfined + cell * (1 + sine) / (1 - sine);
    Leg confine;
    confine.stress = {-cell, -cell, {}, -cell};
    const auto result = led(rock(dilation), {confine, leg(-3 * strength / e, -cell, -cell)});
    ASSERT_TRUE(result.converged) << result.reason;
    const auto& end = result.points.back();
    EXPECT_NEAR(end.stress[1], -strength, 1e-6 * strength);
    const auto& v = end.variables;
    const double p = std::sin(dilation * degree);
    EXPECT_NEAR(v[0] + v[1] + v[3], -v[1] * 2 * p / (1 - p), 1e-7 * std::abs(v[1]));
  }
}

// In plane strain σ_z stays between the two, and does not matter to the strength.
TEST(paths, plane_strain_compression_under_cell_pressure) {
  const double cell = 2e6, strength = unconfined + cell * (1 + sine) / (1 - sine);
  Leg confine;
  confine.stress = {-cell, -cell, {}, {}};
  const auto result = led(rock(0), {confine, leg(-4 * strength / e, -cell)});
  ASSERT_TRUE(result.converged) << result.reason;
  const auto& end = result.points.back();
  EXPECT_NEAR(end.stress[1], -strength, 1e-6 * strength);
  EXPECT_LT(end.stress[3], -cell);
  EXPECT_GT(end.stress[3], -strength);
}

// Sheared at constant volume from an isotropic pressure p, ψ = 0: τ = c cos φ + p sin φ, the mean stress
// stays.
TEST(paths, simple_shear_under_pressure) {
  const double pressure = 3e6;
  Leg confine, shear;
  confine.stress = {-pressure, -pressure, {}, -pressure};
  shear.strain[2] = 2e-3;
  const auto result = led(rock(0), {confine, shear});
  ASSERT_TRUE(result.converged);
  const auto& end = result.points.back();
  EXPECT_NEAR(end.stress[2], cohesion * cosine + pressure * sine, 1e-6 * pressure);
  EXPECT_NEAR((end.stress[0] + end.stress[1]) / 2, -pressure, 1e-6 * pressure);
  // The same in von Mises' cylinder: τ = κ.
  const auto mises =
      led(std::make_shared<DruckerPrager>(isotropic(e, nu), Cone{0, 0, 1e6}), {confine, shear});
  EXPECT_NEAR(mises.points.back().stress[2], 1e6, 1);
}

TEST(paths, hydrostatic_tension_ends_in_the_apex) {
  Leg pull;
  pull.strain = {1e-3, 1e-3, {}, 1e-3};
  const double apex = cohesion * cosine / sine;
  const auto whole = led(rock(0), {pull}), cut = led(rock(0, 0.3e6), {pull});
  const auto cone = led(std::make_shared<DruckerPrager>(
                            isotropic(e, nu), matched(frictional(cohesion, friction, 0), Match::outer)),
                        {pull});
  for (const int i : {0, 1, 3}) {
    EXPECT_NEAR(whole.points.back().stress[i], apex, 1e-9 * apex);
    EXPECT_NEAR(cut.points.back().stress[i], 0.3e6, 1e-3);
    EXPECT_NEAR(cone.points.back().stress[i], apex, 1e-9 * apex);
  }
  // All of the volume beyond the elastic one is plastic.
  const auto& v = cut.points.back().variables;
  EXPECT_NEAR(v[0] + v[1] + v[3], 3e-3 - 0.3e6 / isotropic(e, nu).bulk, 1e-12);
}

TEST(paths, uniaxial_tension_ends_at_the_cut_off_and_unloads_elastically) {
  const auto result = led(rock(10, 0.3e6), {leg(3e-4, 0, 0), leg(2.9e-4, 0, 0)});
  ASSERT_TRUE(result.converged);
  EXPECT_NEAR(result.points[40].stress[1], 0.3e6, 1);
  EXPECT_NEAR(result.points[80].stress[1], 0.3e6 - 1e-5 * e, 1);
}

// The outer cone has the unconfined strength of the pyramid, the inner its uniaxial strength in extension.
TEST(paths, drucker_prager_matches_triaxial_strengths) {
  const auto cone = [](Match match) {
    return std::make_shared<DruckerPrager>(isotropic(e, nu),
                                           matched(frictional(cohesion, friction, 5), match));
  };
  const auto squeezed = led(cone(Match::outer), {leg(-2 * unconfined / e, 0, 0)});
  ASSERT_TRUE(squeezed.converged) << squeezed.reason;
  EXPECT_NEAR(squeezed.points.back().stress[1], -unconfined, 1e-6 * unconfined);
  const double pulled_strength = 2 * cohesion * cosine / (1 + sine);
  const auto pulled = led(cone(Match::inner), {leg(2 * pulled_strength / e, 0, 0)});
  ASSERT_TRUE(pulled.converged) << pulled.reason;
  EXPECT_NEAR(pulled.points.back().stress[1], pulled_strength, 1e-6 * pulled_strength);
}

// One step into the depth of yielding meets the held stresses too, by cuts where Newton's method loses its
// way.
TEST(paths, great_steps_end_where_small_ones_do) {
  Leg shear_under_tension;
  shear_under_tension.strain[2] = 5e-3;
  shear_under_tension.stress = {0.2e6, -1e6, {}, {}};
  for (const double dilation : {0.0, 10.0, 30.0})
    for (const Leg& last : {leg(-20 * unconfined / e, 0, 0), leg(-20 * unconfined / e, 0), leg(5e-3, 0, 0),
                            shear_under_tension}) {
      const auto small = led(rock(dilation, 0.3e6), {last}, 200),
                 great = led(rock(dilation, 0.3e6), {last}, 1);
      ASSERT_TRUE(small.converged && great.converged) << small.reason << great.reason;
      for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(great.points.back().stress[i], small.points.back().stress[i], 0.02 * unconfined)
            << dilation;
    }
}

TEST(paths, a_stress_beyond_the_strength_is_reported) {
  Leg push;
  push.stress = {0, -2 * unconfined, {}, 0};
  const auto result = led(rock(10), {push});
  EXPECT_FALSE(result.converged);
  EXPECT_NE(result.reason.find("leg 1, step 2"), std::string::npos) << result.reason;
  EXPECT_NEAR(result.points.back().stress[1], -unconfined, 0.06 * unconfined);
}

}  // namespace
}  // namespace ashlar::elasticity
