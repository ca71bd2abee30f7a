#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"

#include <Eigen/Core>
#include <limits>

namespace ashlar::elasticity {

using Eigen::Vector3d;
using model::Voigt;

namespace {

Vector3d picked(const Vector3d& values, const std::array<int, 3>& order) {
  return {values[order[0]], values[order[1]], values[order[2]]};
}

}  // namespace

double MohrCoulomb::excess(const Voigt& stress) const {
  const Vector3d principal = principal_axes(stress).stress;
  return mohr_coulomb::excess(strength_, picked(principal, descending(principal)));
}

double MohrCoulomb::utilisation(const Voigt& stress) const {
  const FrictionalStrength& shear = strength_.shear;
  return elasticity::utilisation(
      CoulombLimit{shear.cohesion, shear.sin_friction, shear.cos_friction, strength_.tension}, stress);
}

const char* MohrCoulomb::region(const Voigt& strain, std::span<const double> committed) const {
  const Vector3d principal = principal_axes(trial_stress(strain, committed)).stress;
  const Vector3d sorted = picked(principal, descending(principal));
  return name_of(mohr_coulomb::return_to(strength_, moduli(), sorted).region);
}

std::optional<model::Response> MohrCoulomb::returned(const Voigt& trial_stress) const {
  const PrincipalAxes axes = principal_axes(trial_stress);
  const std::array<int, 3> order = descending(axes.stress);
  const auto returned = mohr_coulomb::return_to(strength_, moduli(), picked(axes.stress, order));
  if (returned.region == mohr_coulomb::Region::elastic) return {};
  PrincipalAnswer answer;
  for (int i = 0; i < 3; ++i) {
    answer.stress[order[i]] = returned.answer.stress[i];
    for (int j = 0; j < 3; ++j) answer.tangent(order[i], order[j]) = returned.answer.tangent(i, j);
  }
  return in_components(axes, answer, moduli().mu);
}

double greatest_tension(const FrictionalStrength& shear) {
  return shear.sin_friction > 0 ? shear.cohesion * shear.cos_friction / shear.sin_friction
                                : std::numeric_limits<double>::infinity();
}

std::shared_ptr<const model::Material> make_mohr_coulomb(const core::Settings& settings, model::Plane plane,
                                                         core::Mistakes& mistakes) {
  const auto moduli = read_plastic_moduli(settings, plane, mistakes);
  const auto shear = read_frictional_strength(settings, mistakes);
  if (!moduli || !shear) return nullptr;
  const double most = greatest_tension(*shear);
  const double tension = settings.number("tensile_strength", most);
  // The user may have computed c/tan φ himself.
  if (tension > most * (1 + 1e-9)) {
    mistakes.add(
        settings.place_of("tensile_strength"),
        "exceeds cohesion/tan(friction) = " + core::format_quantity(most, core::parse_dimension("Pa")) +
            ", the most that cohesion and friction leave",
        "a smaller value, or none to take just that");
    return nullptr;
  }
  return std::make_shared<MohrCoulomb>(*moduli, mohr_coulomb::Strength{*shear, std::min(tension, most)},
                                       read_weight(settings));
}

}  // namespace ashlar::elasticity
