#pragma once
// Perfect plasticity on an isotropic elastic base, whatever the strength: elastic trial, return to the
// strength, plastic strain from what the return took away. Plane strain.

#include <optional>

#include "elasticity/materials/common.hpp"

namespace ashlar::elasticity {

/// Internal variables: plastic strain (xx, yy, xy as an angle, zz), and the equivalent plastic strain
/// Σ √(2/3 Δε_p : Δε_p), which never falls.
class Plastic : public model::Material {
 public:
  Plastic(const Isotropic& moduli, Weight weight) : moduli_(moduli), weight_(weight) {}

  bool linear() const final { return false; }
  int internal_variables() const final { return 5; }
  model::Response respond(const model::Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const final;
  double unit_weight(double gravity) const final { return weight_per_volume(weight_, gravity); }
  double shear_modulus() const final { return moduli_.mu; }
  double plane_modulus() const final { return moduli_.e / (1 - moduli_.nu * moduli_.nu); }

  const Isotropic& moduli() const { return moduli_; }
  /// Greatest breach of the strength [Pa]; ≤ 0: the stress can be borne.
  virtual double excess(const model::Voigt& stress) const = 0;
  /// Where a strain from these committed variables ends: "elastic", "plane", "apex" …
  virtual const char* region(const model::Voigt& strain, std::span<const double> committed) const = 0;

 protected:
  /// Stress before any more flow.
  model::Voigt trial_stress(const model::Voigt& strain, std::span<const double> committed) const;
  /// The stress returned to the strength and ∂σ/∂ε; nothing if the trial stress can be borne.
  virtual std::optional<model::Response> returned(const model::Voigt& trial_stress) const = 0;

 private:
  Isotropic moduli_;
  Weight weight_;
};

/// Plane strain and a compressible law, or nothing and the mistakes.
std::optional<Isotropic> read_plastic_moduli(const core::Settings& settings, model::Plane plane,
                                             core::Mistakes& mistakes);

/// Cohesion and angles of friction and dilation, which the laws of soil and rock have in common.
struct FrictionalStrength {
  double cohesion = 0;      ///< c [Pa]
  double sin_friction = 0;  ///< of φ
  double cos_friction = 1;
  double sin_dilation = 0;  ///< of ψ
  bool associated() const { return sin_friction == sin_dilation; }
};
/// Nothing and mistakes if friction is not in [0°, 90°), dilation not in [0°, friction], or there is no
/// strength.
std::optional<FrictionalStrength> read_frictional_strength(const core::Settings& settings,
                                                           core::Mistakes& mistakes);

}  // namespace ashlar::elasticity
