#include "elasticity/materials/common.hpp"

namespace ashlar::elasticity {

Weight read_weight(const core::Settings& settings) {
  Weight weight;
  if (settings.has("unit_weight")) weight.unit_weight = settings.number("unit_weight");
  if (settings.has("density")) weight.density = settings.number("density");
  return weight;
}

double weight_per_volume(const Weight& weight, double gravity) {
  if (weight.unit_weight) return *weight.unit_weight;
  return weight.density ? *weight.density * gravity : -1;
}

Isotropic isotropic(double e, double nu) {
  return {e, nu, e / (2 * (1 + nu)), e * nu / ((1 + nu) * (1 - 2 * nu)), e / (3 * (1 - 2 * nu))};
}

model::Voigt stress_of(const Isotropic& moduli, const model::Voigt& strain) {
  const double volumetric = moduli.lambda * (strain[0] + strain[1] + strain[3]);
  return {volumetric + 2 * moduli.mu * strain[0], volumetric + 2 * moduli.mu * strain[1],
          moduli.mu * strain[2], volumetric + 2 * moduli.mu * strain[3]};
}

model::Voigt strain_of(const Isotropic& moduli, const model::Voigt& stress) {
  const double mean = (stress[0] + stress[1] + stress[3]) / 3;
  const double volumetric = mean / (3 * moduli.bulk), twice = 2 * moduli.mu;
  return {(stress[0] - mean) / twice + volumetric, (stress[1] - mean) / twice + volumetric,
          stress[2] / moduli.mu, (stress[3] - mean) / twice + volumetric};
}

model::Tangent stiffness(const Isotropic& moduli) {
  const double l = moduli.lambda, direct = l + 2 * moduli.mu;
  return {direct, l, 0, l, l, direct, 0, l, 0, 0, moduli.mu, 0, l, l, 0, direct};
}

bool check_nu(const core::Settings& settings, model::Plane plane, core::Mistakes& mistakes) {
  if (plane == model::Plane::stress || settings.number("nu") < 0.5) return true;
  mistakes.add(settings.place_of("nu"), "nu = 0.5 has no volume change: plane strain has no solution for it",
               "take nu = 0.4999 (the elements do not lock), or plane = \"stress\"");
  return false;
}

}  // namespace ashlar::elasticity
