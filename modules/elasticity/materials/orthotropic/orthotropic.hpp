#pragma once
// Hooke's law with different moduli along and across a bedding: see README.md beside this file.

#include "elasticity/materials/common.hpp"

namespace ashlar::elasticity {

/// Axis 1 lies in the bedding and in the plane, 2 across the bedding, 3 out of the plane.
/// ν_ij: the strain in j, with reversed sign, per strain in i under a stress in i; ν_ij/E_i = ν_ji/E_j.
struct OrthotropicModuli {
  double e1 = 1, e2 = 1, e3 = 1;  ///< [Pa]
  double nu12 = 0, nu13 = 0, nu23 = 0;
  double g12 = 0.5;    ///< [Pa]
  double bedding = 0;  ///< from x to axis 1, counter-clockwise [rad]
};

class Orthotropic final : public model::Material {
 public:
  /// The moduli give every strain a positive energy, as make_orthotropic checks.
  Orthotropic(const OrthotropicModuli& moduli, model::Plane plane, Weight weight = {});

  bool linear() const override { return true; }
  model::Response respond(const model::Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const override;
  double unit_weight(double gravity) const override { return weight_per_volume(weight_, gravity); }
  /// The mean over all directions in the plane.
  double shear_modulus() const override { return shear_modulus_; }
  /// √(E'_1 E'_2), E'_i the stress over the strain along axis i with the other axis in the plane free.
  double plane_modulus() const override { return plane_modulus_; }

 private:
  model::Tangent tangent_;
  double shear_modulus_ = 0, plane_modulus_ = 0;
  Weight weight_;
};

/// The maker of kind "material", name "orthotropic".
model::MakeMaterial make_orthotropic;

}  // namespace ashlar::elasticity
