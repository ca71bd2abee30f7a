#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// τ ≤ c + μ p; c and μ fall from peak to residual with the slip travelled, and slip opens the lips.
class Coulomb final : public Friction {
 public:
  struct Data {
    double friction = 0, residual_friction = 0;  ///< μ = tan φ
    double cohesion = 0, residual_cohesion = 0;  ///< [Pa]
    double softening_slip = 0;                   ///< path over which both fall [m]; 0: at once
    double dilation = 0;                         ///< tan ψ
    double dilation_slip = std::numeric_limits<double>::infinity();  ///< γ_c, over which it decays [m]
    double stiffness = std::numeric_limits<double>::infinity();      ///< k_s [Pa/m]
  };
  explicit Coulomb(const Data& data) : data_(data) {}
  double stiffness() const override { return data_.stiffness; }
  Strength strength(double pressure, double path) const override;
  contact::Dilation dilation(double pressure, double from, double to) const override;

 private:
  Data data_;
};

/// The maker of kind "friction", name "coulomb".
MakeFriction make_coulomb;

}  // namespace ashlar::contact
