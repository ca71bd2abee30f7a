#pragma once
// A law written in the scenario, for trying ideas: see README.md beside this file.

#include "elasticity/materials/common.hpp"

namespace ashlar::elasticity {

/// What the scenario says of its law.
struct LuaLawData {
  std::shared_ptr<const core::Function> stress;  ///< (strain, state, p) → (stress, new state)
  int variables = 0;
  bool symmetric = true;
  core::NumberTable parameters;  ///< p
};

/// The tangent is a central difference of the function, 8 calls. The script's calls go one at a time,
/// whatever the number of threads.
class LuaLaw final : public model::Material {
 public:
  LuaLaw(LuaLawData data, model::Plane plane, Weight weight);

  bool linear() const override { return false; }
  bool symmetric() const override { return data_.symmetric; }
  int internal_variables() const override { return data_.variables; }
  /// Throws InputError with the function's place if it fails or returns what is no stress.
  model::Response respond(const model::Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const override;
  double unit_weight(double gravity) const override { return weight_per_volume(weight_, gravity); }
  double shear_modulus() const override { return shear_modulus_; }  ///< at no strain
  double plane_modulus() const override { return plane_modulus_; }  ///< at no strain

 private:
  model::Voigt stress(const model::Voigt& strain, std::span<const double> committed,
                      std::span<double> trial) const;

  LuaLawData data_;
  model::Plane plane_;
  Weight weight_;
  double shear_modulus_ = 0, plane_modulus_ = 0;
};

/// The maker of kind "material", name "lua". Tries the law on a few strains: a function that fails, an
/// unsymmetric tangent where symmetry is promised, and a law without stiffness at no strain are mistakes.
model::MakeMaterial make_lua_law;

}  // namespace ashlar::elasticity
