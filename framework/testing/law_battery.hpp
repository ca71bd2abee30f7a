#pragma once
// What every material law must show, whoever wrote it: its tangent is the derivative of its stress, it is
// pure, finite, symmetric where it says so, and it does not mind in which axes it is asked (if it is
// isotropic).

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "model/material.hpp"

namespace ashlar::testing {

/// A point of a material: total strain, and the variables committed before it.
struct LawState {
  model::Voigt strain{};
  std::vector<double> committed;
};

/// `count` states: strains of random direction whose sizes run from 10⁻³ to 1 times `size`, every second one
/// after a random earlier step of the law. The same on every machine. `centre` is a strain about which they
/// lie.
std::vector<LawState> random_states(const model::Material& law, int count, double size, unsigned seed,
                                    const model::Voigt& centre = {});

struct TangentCheck {
  double error = 0;  ///< greatest difference of an entry, over the greatest entry or, if more, μ
  bool kink =
      false;  ///< differences of two steps, or from left and right, differ: no derivative to compare with
};
/// Fourth-order central differences with `step` times the size of the strain.
TangentCheck check_tangent(const model::Material& law, const LawState& state, double step = 1e-5);

/// Names the region that a state is in ("elastic", "apex" …), for the count.
using Label = std::function<std::string(const LawState&)>;

struct Battery {
  int states = 0, kinks = 0;
  std::map<std::string, int> regions;  ///< states checked, without kinks
  double worst_tangent = 0;            ///< TangentCheck::error
  double worst_symmetry = 0;  ///< |D − Dᵀ| over the greatest entry; 0 if the law promises nothing
  int impure = 0;             ///< states whose second answer differed from the first in any bit
  int not_finite = 0;
  std::string worst_state;  ///< that of worst_tangent, to be put into a message
};
Battery run_battery(const model::Material& law, const std::vector<LawState>& states, const Label& label = {});

/// Strain or stress in axes turned by `angle` [rad]; strains have the engineering shear.
model::Voigt turned_strain(const model::Voigt& strain, double angle);
model::Voigt turned_stress(const model::Voigt& stress, double angle);

/// |σ(turned ε) − turned σ(ε)| [Pa]. The first four internal variables, if any, are a strain and turn
/// too.
double objectivity_error(const model::Material& law, const LawState& state, double angle);

}  // namespace ashlar::testing
