#pragma once
// What every yielding law must show beyond the battery.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include "elasticity/materials/plastic.hpp"
#include "testing/law_battery.hpp"

namespace ashlar::elasticity {

constexpr double degree = std::numbers::pi / 180;

inline FrictionalStrength frictional(double cohesion, double friction, double dilation) {
  return {cohesion, std::sin(friction * degree), std::cos(friction * degree), std::sin(dilation * degree)};
}

/// The greatest stress that the elastic trial of a state holds: what rounding is measured by.
inline double trial_size(const Plastic& law, const testing::LawState& state) {
  model::Voigt elastic = state.strain;
  for (int i = 0; i < 4; ++i) elastic[i] -= state.committed[i];
  double most = 0;
  for (const double value : stress_of(law.moduli(), elastic)) most = std::max(most, std::abs(value));
  return most;
}

/// Admissible, dissipating and objective in every state; `slack` is a share of the trial stress.
inline void expect_sound(const Plastic& law, const std::vector<testing::LawState>& states,
                         double slack = 1e-11) {
  for (const testing::LawState& state : states) {
    std::vector<double> trial(5);
    const model::Response response = law.respond(state.strain, state.committed, trial);
    const double size = trial_size(law, state);
    EXPECT_LE(law.excess(response.stress), slack * size);
    double work = 0, flow = 0;
    for (int i = 0; i < 4; ++i) {
      work += response.stress[i] * (trial[i] - state.committed[i]);
      flow = std::max(flow, std::abs(trial[i] - state.committed[i]));
    }
    EXPECT_GE(work, -slack * size * flow);
    EXPECT_GE(trial[4], state.committed[4]);
    EXPECT_LE(testing::objectivity_error(law, state, 0.7), 100 * slack * size);
  }
}

/// The battery with the limits that all laws keep; tells how many states each region had.
inline testing::Battery expect_battery(const Plastic& law, const std::vector<testing::LawState>& states,
                                       const char* title) {
  const auto label = [&](const testing::LawState& state) {
    return law.region(state.strain, state.committed);
  };
  const testing::Battery battery = testing::run_battery(law, states, label);
  EXPECT_LE(battery.worst_tangent, 1e-6) << title << ": " << battery.worst_state;
  EXPECT_LE(battery.worst_symmetry, 1e-12) << title;
  EXPECT_EQ(battery.impure, 0) << title;
  EXPECT_EQ(battery.not_finite, 0) << title;
  EXPECT_LE(battery.kinks, battery.states / 20) << title;
  std::cout << title << ": " << battery.states << " states, " << battery.kinks << " at kinks, worst tangent "
            << battery.worst_tangent;
  for (const auto& [region, count] : battery.regions) std::cout << "; " << region << ' ' << count;
  std::cout << '\n';
  return battery;
}

}  // namespace ashlar::elasticity
