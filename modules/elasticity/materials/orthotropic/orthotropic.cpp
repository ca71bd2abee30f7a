#include "elasticity/materials/orthotropic/orthotropic.hpp"

#include <Eigen/Dense>
#include <cassert>
#include <cmath>

#include "elasticity/materials/principal.hpp"

namespace ashlar::elasticity {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using model::Plane;

namespace {

/// Strains (1, 2, 3) from stresses (1, 2, 3).
Matrix3d compliance(const OrthotropicModuli& m) {
  const double s12 = -m.nu12 / m.e1, s13 = -m.nu13 / m.e1, s23 = -m.nu23 / m.e2;
  Matrix3d s;
  s << 1 / m.e1, s12, s13, s12, 1 / m.e2, s23, s13, s23, 1 / m.e3;
  return s;
}

OrthotropicModuli read_moduli(const core::Settings& settings, double bedding) {
  OrthotropicModuli m;
  m.e1 = settings.number("E1"), m.e2 = settings.number("E2"), m.g12 = settings.number("G12");
  m.nu12 = settings.number("nu12");
  // All directions in the bedding alike: E3 = E1, ν32 = ν12, and for ν13 the same number.
  m.e3 = settings.number("E3", m.e1);
  m.nu13 = settings.number("nu13", m.nu12);
  m.nu23 = settings.number("nu23", m.nu12 * m.e2 / m.e3);
  m.bedding = bedding;
  return m;
}

/// What has to hold for two axes by themselves: ν_ij² < E_i/E_j.
bool check_pair(const core::Settings& settings, const char* key, double nu, double ratio,
                core::Mistakes& mistakes) {
  if (nu * nu < ratio) return true;
  const std::string most = core::format_quantity(std::sqrt(ratio), {});
  mistakes.add(settings.place_of(key),
               "asks for strains of negative energy: with these moduli it must be between -" + most +
                   " and " + most + ", got " + core::format_quantity(nu, {}),
               "nu12 is the strain across the bedding per strain along it, under stress along it");
  return false;
}

bool check_energy(const core::Settings& settings, const OrthotropicModuli& m, Plane plane,
                  core::Mistakes& mistakes) {
  bool sound = check_pair(settings, "nu12", m.nu12, m.e1 / m.e2, mistakes);
  if (plane == Plane::stress) return sound;
  sound = check_pair(settings, "nu13", m.nu13, m.e1 / m.e3, mistakes) && sound;
  sound = check_pair(settings, "nu23", m.nu23, m.e2 / m.e3, mistakes) && sound;
  if (!sound) return false;
  // 1 − ν12²E2/E1 − ν23²E3/E2 − ν13²E3/E1 − 2 ν12 ν23 ν13 E3/E1, the determinant of C times E1 E2 E3
  const double left = 1 - m.nu12 * m.nu12 * m.e2 / m.e1 - m.nu23 * m.nu23 * m.e3 / m.e2 -
                      m.nu13 * m.nu13 * m.e3 / m.e1 - 2 * m.nu12 * m.nu23 * m.nu13 * m.e3 / m.e1;
  if (left > 1e-12) return true;
  mistakes.add(
      settings.place_of("nu12"),
      "together with nu13 = " + core::format_quantity(m.nu13, {}) +
          " and nu23 = " + core::format_quantity(m.nu23, {}) + " it asks for strains of negative energy",
      "smaller Poisson's ratios: 1 - nu12^2 E2/E1 - nu23^2 E3/E2 - nu13^2 E3/E1 - 2 nu12 nu23 nu13 E3/E1 "
      "must be above 0, and is " +
          core::format_quantity(left, {}));
  return false;
}

}  // namespace

Orthotropic::Orthotropic(const OrthotropicModuli& moduli, Plane plane, Weight weight) : weight_(weight) {
  Matrix4d local = Matrix4d::Zero();
  const Matrix3d s = compliance(moduli);
  local(2, 2) = moduli.g12;
  if (plane == Plane::stress) {
    local.topLeftCorner<2, 2>() = s.topLeftCorner<2, 2>().inverse();
  } else {
    const Matrix3d d = s.inverse();
    const int place[] = {0, 1, 3};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) local(place[i], place[j]) = (d(i, j) + d(j, i)) / 2;
  }
  tangent_ = turned(local, std::cos(2 * moduli.bedding), std::sin(2 * moduli.bedding));
  // Of the two shears in the plane, along the bedding and at 45° to it, every other is a mixture.
  shear_modulus_ = (moduli.g12 + (local(0, 0) - local(0, 1) - local(1, 0) + local(1, 1)) / 4) / 2;
  const double minor = local(0, 0) * local(1, 1) - local(0, 1) * local(1, 0);
  plane_modulus_ = minor / std::sqrt(local(0, 0) * local(1, 1));
  assert(minor > 0 && moduli.g12 > 0);
}

model::Response Orthotropic::respond(const model::Voigt& strain, std::span<const double>,
                                     std::span<double>) const {
  model::Response response{{}, tangent_};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) response.stress[i] += tangent_[4 * i + j] * strain[j];
  return response;
}

std::shared_ptr<const model::Material> make_orthotropic(const core::Settings& settings, Plane plane,
                                                        core::Mistakes& mistakes) {
  const auto bedding = read_angle(settings, "bedding", {-180, 180, false}, mistakes);
  const OrthotropicModuli moduli = read_moduli(settings, bedding.value_or(0));
  if (!check_energy(settings, moduli, plane, mistakes) || !bedding) return nullptr;
  return std::make_shared<Orthotropic>(moduli, plane, read_weight(settings));
}

}  // namespace ashlar::elasticity
