#include "elasticity/materials/common.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

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

std::optional<double> read_angle(const core::Settings& settings, const char* key, AngleRange range,
                                 core::Mistakes& mistakes) {
  constexpr double degree = std::numbers::pi / 180;
  const double angle = settings.number(key);
  // 90*u.deg may come out a rounding error beside the limit.
  const double slack = 1e-12;
  const double degrees = angle / degree;
  const bool above = range.high_open ? degrees >= range.high - slack : degrees > range.high + slack;
  if (degrees >= range.low - slack && !above) return angle;
  std::ostringstream what, advice;
  what << "must be " << (range.high_open ? "from " : "between ") << range.low << "° "
       << (range.high_open ? "to below " : "and ") << range.high << "°, got " << degrees << "°";
  if (angle > range.low && angle <= range.high)
    advice << "a bare number is in radians: for " << angle << "° write " << angle << "*units.deg";
  mistakes.add(settings.place_of(key), what.str(), advice.str());
  return {};
}

}  // namespace ashlar::elasticity
