#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// τ ≤ p tan(φ_r + JRC log₁₀(JCS/p)), the total angle from φ_r to 70°.
class BartonBandis final : public Friction {
 public:
  struct Data {
    double jrc = 0;             ///< roughness, degrees for each decade of pressure
    double jcs = 0;             ///< strength of the lips' rock [Pa]
    double residual_angle = 0;  ///< φ_r [rad]
    bool dilation = false;
    double stiffness = std::numeric_limits<double>::infinity();  ///< k_s [Pa/m]
  };
  explicit BartonBandis(const Data& data) : data_(data) {}
  double stiffness() const override { return data_.stiffness; }
  Strength strength(double pressure, double path) const override;
  contact::Dilation dilation(double pressure, double from, double to) const override;

 private:
  struct Roughness {
    double angle = 0;        ///< above φ_r [rad]
    double by_pressure = 0;  ///< times the pressure [rad]
  };
  Roughness roughness(double pressure) const;

  Data data_;
};

/// The maker of kind "friction", name "barton_bandis".
MakeFriction make_barton_bandis;

}  // namespace ashlar::contact
