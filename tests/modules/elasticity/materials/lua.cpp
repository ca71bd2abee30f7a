#include "elasticity/materials/lua/lua.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "testing/law_battery.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;

/// Stands for a script's function: σ = E (1 + 10³ |ε|²) ε with shear by halves, counting its calls in the
/// state.
class Stiffening final : public core::Function {
 public:
  std::vector<double> call(std::span<const double>) const override { return {}; }
  void call_tables(std::span<const core::NumberTable> arguments,
                   std::span<core::NumberTable> results) const override {
    EXPECT_EQ(arguments.size(), 3u);
    EXPECT_EQ(arguments[0].names, (std::vector<std::string>{"xx", "yy", "xy", "zz"}));
    EXPECT_EQ(arguments[2].names, std::vector<std::string>{"E"});
    std::vector<double> e = arguments[0].values;
    e[2] /= 2;
    const double square = e[0] * e[0] + e[1] * e[1] + 2 * e[2] * e[2] + e[3] * e[3];
    for (int i = 0; i < 4; ++i) results[0].values[i] = arguments[2].values[0] * (1 + 1e3 * square) * e[i];
    results[1].values[0] = arguments[1].values[0] + 1;
  }
};

LuaLawData stiffening() {
  return {std::make_shared<Stiffening>(), 1, true, {{"E"}, {8e9}}};
}

TEST(lua_law, battery) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const LuaLaw law(stiffening(), plane, {});
    const auto battery = testing::run_battery(law, testing::random_states(law, 300, 1e-2, 9));
    EXPECT_LE(battery.worst_tangent, 1e-6) << battery.worst_state;
    EXPECT_EQ(battery.worst_symmetry, 0);
    EXPECT_EQ(battery.kinks + battery.impure + battery.not_finite, 0);
  }
}

TEST(lua_law, moduli_and_state_come_from_the_function) {
  const LuaLaw law(stiffening(), Plane::strain, {{}, 2000.0});
  EXPECT_NEAR(law.shear_modulus(), 4e9, 10);
  EXPECT_NEAR(law.plane_modulus(), 8e9, 10);
  EXPECT_EQ(law.unit_weight(10), 20e3);
  const std::vector<double> committed = {5};
  std::vector<double> trial(1);
  const auto response = law.respond({1e-3, 0, 2e-3, 0}, committed, trial);
  EXPECT_EQ(trial[0], 6);
  EXPECT_NEAR(response.stress[2], 8e9 * (1 + 1e3 * 3e-6) * 1e-3, 1e-3);
  EXPECT_EQ(LuaLaw(stiffening(), Plane::stress, {}).respond({0, 0, 0, 1}, committed, trial).stress[3], 0);
}

}  // namespace
}  // namespace ashlar::elasticity
