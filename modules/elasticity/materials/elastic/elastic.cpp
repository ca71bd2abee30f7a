#include "elasticity/materials/elastic/elastic.hpp"

#include <cassert>

namespace ashlar::elasticity {

using model::Plane;

Elastic::Elastic(double e, double nu, Plane plane, Weight weight) : weight_(weight) {
  assert(e > 0 && nu > -1 && (plane == Plane::stress ? nu <= 0.5 : nu < 0.5));
  // Plane stress has the same form with λ* = 2μλ/(λ+2μ) = Eν/(1−ν²), and no stress out of plane.
  mu_ = e / (2 * (1 + nu));
  lambda_ = plane == Plane::strain ? e * nu / ((1 + nu) * (1 - 2 * nu)) : e * nu / (1 - nu * nu);
  plane_modulus_ = plane == Plane::strain ? e / (1 - nu * nu) : e;
  out_of_plane_ = plane == Plane::strain;
}

model::Response Elastic::respond(const model::Voigt& strain, std::span<const double>,
                                 std::span<double>) const {
  model::Response response;
  const double direct = lambda_ + 2 * mu_;
  const double xx = strain[0], yy = strain[1], zz = out_of_plane_ ? strain[3] : 0;
  const double volumetric = lambda_ * (xx + yy + zz);
  response.stress = {volumetric + 2 * mu_ * xx, volumetric + 2 * mu_ * yy, mu_ * strain[2],
                     out_of_plane_ ? volumetric + 2 * mu_ * zz : 0};
  response.tangent = {direct, lambda_, 0, 0, lambda_, direct, 0, 0, 0, 0, mu_, 0, 0, 0, 0, 0};
  if (out_of_plane_) {
    response.tangent[3] = response.tangent[7] = response.tangent[12] = response.tangent[13] = lambda_;
    response.tangent[15] = direct;
  }
  return response;
}

std::shared_ptr<const model::Material> make_elastic(const core::Settings& settings, Plane plane,
                                                    core::Mistakes& mistakes) {
  if (!check_nu(settings, plane, mistakes)) return nullptr;
  const Elastic law(settings.number("E"), settings.number("nu"), plane, read_weight(settings));
  const auto strength = read_strength(settings, mistakes);
  if (strength) return std::make_shared<ElasticWithStrength>(law, *strength);
  return std::make_shared<Elastic>(law);
}

}  // namespace ashlar::elasticity
