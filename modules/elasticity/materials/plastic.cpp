#include "elasticity/materials/plastic.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ashlar::elasticity {

using model::Voigt;

Voigt Plastic::trial_stress(const Voigt& strain, std::span<const double> committed) const {
  Voigt elastic{};
  for (int i = 0; i < 4; ++i) elastic[i] = strain[i] - committed[i];
  return stress_of(moduli_, elastic);
}

model::Response Plastic::respond(const Voigt& strain, std::span<const double> committed,
                                 std::span<double> trial) const {
  assert(committed.size() == 5 && trial.size() == 5);
  const Voigt before = trial_stress(strain, committed);
  const auto yielded = returned(before);
  std::copy(committed.begin(), committed.end(), trial.begin());
  if (!yielded) return {before, stiffness(moduli_)};
  Voigt taken{};
  for (int i = 0; i < 4; ++i) taken[i] = before[i] - yielded->stress[i];
  const Voigt flow = strain_of(moduli_, taken);
  for (int i = 0; i < 4; ++i) trial[i] += flow[i];
  const double square = flow[0] * flow[0] + flow[1] * flow[1] + flow[2] * flow[2] / 2 + flow[3] * flow[3];
  trial[4] += std::sqrt(2.0 / 3 * square);
  return *yielded;
}

std::optional<Isotropic> read_plastic_moduli(const core::Settings& settings, model::Plane plane,
                                             core::Mistakes& mistakes) {
  if (plane == model::Plane::stress) {
    mistakes.add(settings.place, "the law '" + settings.name + "' is for plane strain only",
                 "set plane = \"strain\", or take a linear law");
    return {};
  }
  if (!check_nu(settings, plane, mistakes)) return {};
  return isotropic(settings.number("E"), settings.number("nu"));
}

std::optional<FrictionalStrength> read_frictional_strength(const core::Settings& settings,
                                                           core::Mistakes& mistakes) {
  const double cohesion = settings.number("cohesion");
  const auto friction = read_angle(settings, "friction", {0, 90, true}, mistakes);
  const auto dilation = read_angle(settings, "dilation", {0, 90, true}, mistakes);
  if (!friction || !dilation) return {};
  if (*dilation > *friction) {
    mistakes.add(settings.place_of("dilation"), "must not exceed friction: such a flow would make energy",
                 "dilation = friction is the most, 0 keeps the volume");
    return {};
  }
  if (cohesion == 0 && *friction == 0) {
    mistakes.add(settings.place_of("cohesion"), "without cohesion and friction there is no strength at all",
                 "give one of them a value above 0");
    return {};
  }
  return FrictionalStrength{cohesion, std::sin(*friction), std::cos(*friction), std::sin(*dilation)};
}

}  // namespace ashlar::elasticity
