#pragma once
// Drucker–Prager's law: a cone and its apex, perfectly plastic, plane strain: see README.md beside this file.

#include "elasticity/materials/plastic.hpp"
#include "elasticity/utilisation.hpp"

namespace ashlar::elasticity {

/// √J2 + η p ≤ κ, p the mean stress (tension positive); the flow has η̄ in place of η.
struct Cone {
  double eta = 0;      ///< η
  double eta_bar = 0;  ///< η̄ ≤ η
  double kappa = 0;    ///< ξ c [Pa]
};

/// Which line of Mohr–Coulomb's pyramid the cone shares: that of triaxial compression (outer), of triaxial
/// extension (inner), or the limit loads in plane strain with dilation = friction.
enum class Match { outer, inner, plane_strain };
Cone matched(const FrictionalStrength& strength, Match match);

class DruckerPrager final : public Plastic, public WithStrength {
 public:
  DruckerPrager(const Isotropic& moduli, const Cone& cone, Weight weight = {})
      : Plastic(moduli, weight), cone_(cone) {}

  bool symmetric() const override { return cone_.eta == cone_.eta_bar; }
  double excess(const model::Voigt& stress) const override;
  /// √J2 over κ − η p, what it may be under the same mean stress.
  double utilisation(const model::Voigt& stress) const override;
  const char* region(const model::Voigt& strain, std::span<const double> committed) const override;

 private:
  std::optional<model::Response> returned(const model::Voigt& trial_stress) const override;
  Cone cone_;
};

/// The maker of kind "material", name "drucker_prager".
model::MakeMaterial make_drucker_prager;

}  // namespace ashlar::elasticity
