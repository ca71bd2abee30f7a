#pragma once
// Hooke's law for plane strain and plane stress, isotropic.

#include "elasticity/materials/common.hpp"
#include "elasticity/utilisation.hpp"

namespace ashlar::elasticity {

class Elastic : public model::Material {
 public:
  /// E > 0 [Pa]; −1 < nu ≤ ½, and below ½ in plane strain.
  Elastic(double e, double nu, model::Plane plane, Weight weight = {});

  bool linear() const override { return true; }
  model::Response respond(const model::Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const override;
  double unit_weight(double gravity) const override { return weight_per_volume(weight_, gravity); }
  double shear_modulus() const override { return mu_; }
  double plane_modulus() const override { return plane_modulus_; }

 private:
  double mu_, lambda_, plane_modulus_;
  bool out_of_plane_;  ///< carries stress out of the plane: not in plane stress
  Weight weight_;
};

/// Hooke's law with a strength to compare stresses with; it never yields.
class ElasticWithStrength final : public Elastic, public WithStrength {
 public:
  ElasticWithStrength(const Elastic& law, const CoulombLimit& limit) : Elastic(law), limit_(limit) {}
  double utilisation(const model::Voigt& stress) const override {
    return elasticity::utilisation(limit_, stress);
  }

 private:
  CoulombLimit limit_;
};

/// The maker of kind "material", name "elastic".
model::MakeMaterial make_elastic;

}  // namespace ashlar::elasticity
