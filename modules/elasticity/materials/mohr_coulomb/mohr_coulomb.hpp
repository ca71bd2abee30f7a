#pragma once
// Mohr–Coulomb's law with tension cut-off, perfectly plastic, plane strain: see README.md beside this file.

#include "elasticity/materials/mohr_coulomb/return_mapping.hpp"
#include "elasticity/materials/plastic.hpp"
#include "elasticity/utilisation.hpp"

namespace ashlar::elasticity {

class MohrCoulomb final : public Plastic, public WithStrength {
 public:
  /// tension ≤ c/tan φ.
  MohrCoulomb(const Isotropic& moduli, const mohr_coulomb::Strength& strength, Weight weight = {})
      : Plastic(moduli, weight), strength_(strength) {}

  bool symmetric() const override { return strength_.shear.associated(); }
  double excess(const model::Voigt& stress) const override;
  double utilisation(const model::Voigt& stress) const override;
  const char* region(const model::Voigt& strain, std::span<const double> committed) const override;

 private:
  std::optional<model::Response> returned(const model::Voigt& trial_stress) const override;
  mohr_coulomb::Strength strength_;
};

/// c/tan φ, where the pyramid ends [Pa]; infinite if φ = 0.
double greatest_tension(const FrictionalStrength& shear);

/// The maker of kind "material", name "mohr_coulomb".
model::MakeMaterial make_mohr_coulomb;

}  // namespace ashlar::elasticity
