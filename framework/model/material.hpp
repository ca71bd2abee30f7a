#pragma once
// A material law is a pure function: (strain, committed internal variables) → (stress, tangent, trial
// variables). Vectors are Voigt (xx, yy, xy, zz), z out of the plane, with the engineering shear strain γ_xy.
// Tension positive. In plane strain ε_zz = 0 is given; in plane stress the law sees to σ_zz = 0 and ignores
// ε_zz.

#include <array>
#include <memory>
#include <span>

#include "core/schema.hpp"

namespace ashlar::model {

/// What stands for the third direction. Axisymmetric scenes turn about x = 0: x is the radius, y the axis,
/// and zz the direction around; laws are then those of plane strain with ε_zz = u_x/x given.
enum class Plane { strain, stress, axisymmetric };

/// "plane strain", "plane stress", "axisymmetric".
inline const char* words(Plane plane) {
  return plane == Plane::strain ? "plane strain" : plane == Plane::stress ? "plane stress" : "axisymmetric";
}

/// The plane that a law is made for.
constexpr Plane law_plane(Plane plane) {
  return plane == Plane::stress ? Plane::stress : Plane::strain;
}

using Voigt = std::array<double, 4>;     ///< (xx, yy, xy, zz)
using Tangent = std::array<double, 16>;  ///< row by row, ∂σ_i/∂ε_j [Pa]

struct Response {
  Voigt stress{};  ///< [Pa]
  Tangent tangent{};
};

class Material {
 public:
  virtual ~Material() = default;
  /// True if the tangent never changes: a stage then needs no Newton iteration.
  virtual bool linear() const = 0;
  /// False if the tangent is unsymmetric (non-associated flow): the solver must then be for general matrices.
  virtual bool symmetric() const { return true; }
  /// Number of internal variables at each point, all 0 at first.
  virtual int internal_variables() const { return 0; }
  /// `committed` and `trial` hold internal_variables() entries. Pure, and safe on several threads at once.
  virtual Response respond(const Voigt& strain, std::span<const double> committed,
                           std::span<double> trial) const = 0;
  /// Weight per volume [N/m³] under gravity g [m/s²]; a law given by its unit weight ignores g. Negative: not
  /// given.
  virtual double unit_weight(double gravity) const = 0;
  virtual double shear_modulus() const = 0;  ///< μ [Pa]: scales stabilisation
  virtual double plane_modulus()
      const = 0;  ///< E' = E/(1−ν²) in plane strain, E in plane stress [Pa]: scales penalties
};

/// Two laws that stresses may be smoothed across.
inline bool same_stiffness(const Material& a, const Material& b) {
  return &a == &b || (a.shear_modulus() == b.shear_modulus() && a.plane_modulus() == b.plane_modulus());
}

/// A module registers a law as kind "material" with this signature. Mistakes that depend on the plane (ν =
/// 0.5 in plane strain) go to `mistakes` with the parameter's place; the result is then null.
using MakeMaterial = std::shared_ptr<const Material>(const core::Settings& settings, Plane plane,
                                                     core::Mistakes& mistakes);

}  // namespace ashlar::model
