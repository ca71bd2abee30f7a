#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include "plastic_checks.hpp"

namespace ashlar::elasticity {
namespace {

using model::Voigt;
using mohr_coulomb::Region;
using mohr_coulomb::Strength;

constexpr double none = std::numeric_limits<double>::infinity();

struct Case {
  const char* title;
  double nu, cohesion, friction, dilation;
  double tension;                    ///< negative: c/tan φ
  double centre;                     ///< of the strains, all three directions
  std::vector<const char*> regions;  ///< that the states must reach
};

MohrCoulomb law_of(const Case& c) {
  const FrictionalStrength shear = frictional(c.cohesion, c.friction, c.dilation);
  return {isotropic(10e9, c.nu), {shear, c.tension < 0 ? greatest_tension(shear) : c.tension}};
}

const std::vector<Case>& cases() {
  static const std::vector<Case> list = {
      {"cut-off, non-associated",
       0.25,
       1e6,
       30,
       10,
       0.5e6,
       0,
       {"elastic", "shear plane", "compression edge", "extension edge", "tension plane", "tension edge",
        "apex", "shear and tension", "compression corner", "extension corner"}},
      {"associated, apex",
       0.2,
       1e6,
       35,
       35,
       -1,
       0,
       {"elastic", "shear plane", "compression edge", "extension edge", "apex"}},
      {"no dilation, apex",
       0.3,
       1e6,
       40,
       0,
       -1,
       0,
       {"elastic", "shear plane", "compression edge", "extension edge", "apex"}},
      {"Tresca", 0.3, 1e6, 0, 0, none, 0, {"elastic", "shear plane", "compression edge", "extension edge"}},
      {"Tresca with cut-off",
       0.3,
       1e6,
       0,
       0,
       0.4e6,
       0,
       {"elastic", "shear plane", "tension plane", "tension edge", "apex", "shear and tension",
        "compression corner", "extension corner"}},
      {"no cohesion",
       0.3,
       0,
       30,
       5,
       -1,
       -1e-3,
       {"elastic", "shear plane", "compression edge", "extension edge"}},
      {"no tension",
       0.2,
       2e6,
       45,
       20,
       0,
       -1e-4,
       {"elastic", "shear plane", "tension plane", "tension edge", "apex"}},
      {"nearly incompressible", 0.4999, 1e6, 30, 30, 0.2e6, 0, {"shear plane", "apex"}},
      {"nu below zero", -0.5, 1e6, 20, 0, 1e6, 0, {"elastic", "shear plane", "tension plane", "apex"}}};
  return list;
}

TEST(mohr_coulomb, battery_in_all_regions) {
  for (const Case& c : cases()) {
    const MohrCoulomb law = law_of(c);
    const auto states = testing::random_states(law, 2000, 3e-3, 7, {c.centre, c.centre, 0, c.centre});
    const testing::Battery battery = expect_battery(law, states, c.title);
    for (const char* region : c.regions)
      EXPECT_TRUE(battery.regions.contains(region)) << c.title << ": " << region;
    expect_sound(law, states);
  }
}

TEST(mohr_coulomb, one_stress_by_hand) {
  // nu = 0: D = E. f = 1.5*0 + 0.5*10 - 2 cos 30° = 3.268, n·Dm = 2E, so each of sigma_1 and -sigma_3
  // loses 1.634.
  const MohrCoulomb law(isotropic(1000, 0), {frictional(1, 30, 0), std::sqrt(3.0)});
  std::vector<double> committed(5), trial(5);
  const auto response = law.respond({-10e-3, 0, 0, -5e-3}, committed, trial);
  const double half = (5 - std::sqrt(3.0)) / 2;
  EXPECT_NEAR(response.stress[0], -10 + half, 1e-12);
  EXPECT_NEAR(response.stress[1], -half, 1e-12);
  EXPECT_NEAR(response.stress[2], 0, 1e-12);
  EXPECT_NEAR(response.stress[3], -5, 1e-12);
  EXPECT_NEAR(trial[0], -half / 1000, 1e-15);
  EXPECT_NEAR(trial[1], half / 1000, 1e-15);
  EXPECT_NEAR(trial[4], half / 1000 * std::sqrt(4.0 / 3), 1e-15);
  // Loading along x: D_ep = D - D m (D n)ᵀ/(n·D m), with n = (0, 1.5, -0.5 at x), m = (1, -1 at x).
  EXPECT_NEAR(response.tangent[0], 1000 * (1 - 0.5 / 2), 1e-9);
  EXPECT_NEAR(response.tangent[1], 1000 * 1.5 / 2, 1e-9);
  EXPECT_NEAR(response.tangent[4], 1000 * 0.5 / 2, 1e-9);
  EXPECT_NEAR(response.tangent[5], 1000 * (1 - 1.5 / 2), 1e-9);
  EXPECT_FALSE(law.symmetric());
}

// On the border of two regions the returned stress is known: the point that the flow left.
TEST(mohr_coulomb, borders_of_regions_return_to_their_point) {
  const Strength strength{frictional(1, 30, 10), 0.8};
  const Isotropic moduli = isotropic(1000, 0.3);
  const double s = 0.5, p = std::sin(10 * degree), limit = 2 * std::cos(30 * degree);
  const Eigen::Vector3d m13(1 + p, 0, -(1 - p)), m12(1 + p, -(1 - p), 0), m23(0, 1 + p, -(1 - p));
  const Eigen::Vector3d e1(1, 0, 0), e2(0, 1, 0);
  const auto on_shear = [&](double first) { return ((1 + s) * first - limit) / (1 - s); };
  const double low = on_shear(0.8);
  struct Border {
    Eigen::Vector3d stress, flow;
  };
  const std::vector<Border> borders = {{{-2, -2, on_shear(-2)}, m13},
                                       {{-2, -2, on_shear(-2)}, m13 + m23},
                                       {{-2, on_shear(-2), on_shear(-2)}, m13},
                                       {{-2, on_shear(-2), on_shear(-2)}, m13 + m12},
                                       {{0.8, -0.5, low}, m13},
                                       {{0.8, -0.5, low}, e1},
                                       {{0.8, 0.8, 0}, e1},
                                       {{0.8, 0.8, 0}, e1 + e2},
                                       {{0.8, 0.8, low}, m13},
                                       {{0.8, 0.8, low}, e1},
                                       {{0.8, 0.8, low}, e1 + e2},
                                       {{0.8, low, low}, m13 + m12},
                                       {{0.8, low, low}, e1},
                                       {{0.8, 0.8, 0.8}, e1},
                                       {{0.8, 0.8, 0.8}, e1 + e2},
                                       {{0.8, 0.8, 0.8}, Eigen::Vector3d::Ones()}};
  for (const Border& border : borders)
    for (const double size : {1e-9, 1e-3, 1e3}) {
      const Eigen::Vector3d step =
          size * (moduli.lambda * border.flow.sum() * Eigen::Vector3d::Ones() + 2 * moduli.mu * border.flow);
      const auto returned = mohr_coulomb::return_to(strength, moduli, border.stress + step);
      EXPECT_NE(returned.region, Region::elastic);
      EXPECT_LE((returned.answer.stress - border.stress).norm(), 1e-12 * (1 + step.norm()))
          << border.stress.transpose() << " from " << border.flow.transpose();
      EXPECT_TRUE(returned.answer.tangent.allFinite());
    }
}

TEST(mohr_coulomb, equal_principal_stresses_are_no_special_case) {
  const MohrCoulomb law = law_of(cases()[0]);
  std::vector<double> committed(5), trial(5);
  for (const double size : {1e-3, -1e-3, 1.0})
    for (const Voigt& strain :
         {Voigt{size, size, 0, size}, Voigt{size, size, 0, 0}, Voigt{size, 0, 0, 0}, Voigt{0, 0, 0, size},
          Voigt{-size, -size, 0, size}, Voigt{0, size, 0, size}}) {
      const testing::LawState state{strain, committed};
      const auto response = law.respond(strain, committed, trial);
      for (const double value : response.stress) EXPECT_TRUE(std::isfinite(value));
      for (const double value : response.tangent) EXPECT_TRUE(std::isfinite(value));
      EXPECT_EQ(response.stress[2], 0);
      EXPECT_LE(law.excess(response.stress), 1e-11 * trial_size(law, state));
      // Regions stretch beyond these symmetric states: the tangent there is the derivative too.
      const auto check = testing::check_tangent(law, state);
      EXPECT_TRUE(check.kink || check.error <= 1e-6) << law.region(strain, committed);
    }
}

// The regions leave no gap: every stress finds one, and not merely the least bad.
TEST(mohr_coulomb, every_stress_has_its_region) {
  for (const Case& c : cases()) {
    const FrictionalStrength shear = frictional(c.cohesion, c.friction, c.dilation);
    const Strength strength{shear, c.tension < 0 ? greatest_tension(shear) : c.tension};
    const double most = std::max(c.cohesion, 1e5);
    for (double first = -4 * most; first <= 9 * most; first += 0.3 * most)
      for (double second = first; second >= first - 12 * most; second -= 0.4 * most)
        for (double third = second; third >= second - 12 * most; third -= 0.5 * most) {
          const auto returned =
              mohr_coulomb::return_to(strength, isotropic(10e9, c.nu), {first, second, third});
          ASSERT_LE(returned.breach, 1e-11) << c.title << ": " << first << ' ' << second << ' ' << third
                                            << ", " << name_of(returned.region);
        }
  }
}

// What a user may say, at strains from rounding to nonsense: always an admissible, finite answer.
TEST(mohr_coulomb, any_parameters_and_any_strain_give_an_answer) {
  int laws = 0;
  for (const double nu : {-0.9, 0.0, 0.3, 0.4999999})
    for (const double cohesion : {0.0, 1.0, 1e6, 1e9})
      for (const double friction : {0.0, 1e-6, 30.0, 60.0, 89.0})
        for (const double dilation : {0.0, 0.5, 1.0})
          for (const double share : {0.0, 0.5, 1.0}) {
            if (cohesion == 0 && friction == 0) continue;
            const FrictionalStrength shear = frictional(cohesion, friction, dilation * friction);
            const double most = greatest_tension(shear);
            const double tension = share == 1 ? most : share * std::min(most, 1e7);
            const MohrCoulomb law(isotropic(10e9, nu), {shear, tension});
            ++laws;
            for (const double size : {1e-9, 1e-4, 1.0}) {
              const auto states = testing::random_states(law, 12, size, 3);
              expect_sound(law, states, 1e-10);
            }
            ASSERT_FALSE(HasFailure())
                << nu << ' ' << cohesion << ' ' << friction << ' ' << dilation << ' ' << share;
          }
  EXPECT_GT(laws, 600);
}

}  // namespace
}  // namespace ashlar::elasticity
