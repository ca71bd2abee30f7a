// The normal laws against numbers by hand.

#include <gtest/gtest.h>

#include "modules/contact/laws/laws.hpp"

namespace ashlar::test {
namespace {

TEST(normal_laws, linear_closes_by_its_stiffness_and_breaks_once) {
  const Linear law(20e9, 5e5);
  EXPECT_EQ(law.form(), NormalLaw::Form::compliant);
  EXPECT_DOUBLE_EQ(law.opening(2e6).value, -1e-4);
  EXPECT_DOUBLE_EQ(law.opening(-4e5).value, 2e-5);
  Variables variables{};
  EXPECT_EQ(law.tensile_strength(variables), 5e5);
  law.part(variables);
  EXPECT_EQ(law.tensile_strength(variables), 0);
  EXPECT_EQ(law.variables(), std::vector<std::string>{"broken"});
  Variables none{};
  Linear(20e9, 0).part(none);
  EXPECT_EQ(none[0], 0);
  EXPECT_TRUE(Linear(20e9, 0).variables().empty());
}

TEST(normal_laws, barton_bandis_closes_along_a_hyperbola) {
  const double k = 10e9, v = 2e-4;
  const BartonBandisClosure law(k, v);
  for (const double closure : {1e-6, 5e-5, 1e-4, 1.9e-4}) {
    const double pressure = k * closure / (1 - closure / v);
    EXPECT_NEAR(law.opening(pressure).value, -closure, 1e-18);
    EXPECT_NEAR(law.opening(pressure).by_pressure, -std::pow(1 - closure / v, 2) / k, 1e-24);
  }
  EXPECT_DOUBLE_EQ(law.opening(k * v).value, -v / 2);
  EXPECT_LT(-law.opening(1e15).value, v);
  EXPECT_DOUBLE_EQ(law.opening(-1e5).value, 1e-5);
  EXPECT_NEAR(law.opening(-1e-9).by_pressure, law.opening(1e-9).by_pressure, 1e-22);
}

// k₀ = 100 GPa/m, T = 1 MPa, G_f = 100 J/m²: o₀ = 10 µm, o_f = 200 µm
TEST(normal_laws, cohesive_tears_by_its_fracture_energy) {
  const Cohesive law({1e11, 1e6, 100});
  Variables memory{};
  const auto go = [&](double opening) {
    Variables trial = memory;
    const double pull = -law.pressure(opening, memory, trial).value;
    memory = trial;
    return pull;
  };
  EXPECT_DOUBLE_EQ(go(-1e-5), -1e6);
  EXPECT_DOUBLE_EQ(go(5e-6), 5e5);
  EXPECT_NEAR(go(1e-5), 1e6, 1e-6);
  EXPECT_NEAR(go(105e-6), 5e5, 1e-6);
  EXPECT_NEAR(law.tensile_strength(memory), 5e5, 1e-6);
  EXPECT_NEAR(go(52.5e-6), 2.5e5, 1e-6);
  EXPECT_NEAR(go(0), 0, 1e-9);
  EXPECT_DOUBLE_EQ(go(-1e-5), -1e6);
  EXPECT_NEAR(go(105e-6), 5e5, 1e-6);
  EXPECT_NEAR(go(152.5e-6), 2.5e5, 1e-6);
  EXPECT_EQ(go(200.1e-6), 0);
  EXPECT_EQ(go(100e-6), 0);
  EXPECT_DOUBLE_EQ(go(-2e-5), -2e6);
  EXPECT_EQ(law.tensile_strength(memory), 0);

  double work = 0;
  constexpr int steps = 2000;
  memory = {};
  for (int i = 0; i < steps; ++i) work += go((i + 0.5) * 250e-6 / steps) * 250e-6 / steps;
  EXPECT_NEAR(work, 100, 1e-3);
}

}  // namespace
}  // namespace ashlar::test
