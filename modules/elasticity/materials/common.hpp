#pragma once
// What the laws of this module share: weights, Hooke's isotropic law in four components.
// Voigt order (xx, yy, xy, zz) with the engineering shear strain, tension positive.

#include <optional>

#include "core/readings.hpp"
#include "model/material.hpp"

namespace ashlar::elasticity {

/// Weight per volume, said as such or by density; nothing said: no weight.
struct Weight {
  std::optional<double> unit_weight;  ///< [N/m³]
  std::optional<double> density;      ///< [kg/m³]
};

/// The keys "unit_weight" and "density".
Weight read_weight(const core::Settings& settings);
/// [N/m³] under `gravity` [m/s²]; −1 if nothing was said.
double weight_per_volume(const Weight& weight, double gravity);

/// Isotropic moduli in three dimensions. E > 0 [Pa], −1 < nu < ½.
struct Isotropic {
  double e = 1, nu = 0;
  double mu = 0.5, lambda = 0;  ///< Lamé [Pa]
  double bulk = 1.0 / 3;        ///< K [Pa]
};
Isotropic isotropic(double e, double nu);

/// σ = λ tr(ε) I + 2μ ε
model::Voigt stress_of(const Isotropic& moduli, const model::Voigt& strain);
/// ε = (σ − p I)/(2μ) + p/(3K) I, p the mean stress.
model::Voigt strain_of(const Isotropic& moduli, const model::Voigt& stress);
model::Tangent stiffness(const Isotropic& moduli);

/// False, and a mistake at nu, if nu = ½ leaves no solution out of plane stress.
bool check_nu(const core::Settings& settings, model::Plane plane, core::Mistakes& mistakes);

using core::AngleRange;
using core::read_angle;

}  // namespace ashlar::elasticity
