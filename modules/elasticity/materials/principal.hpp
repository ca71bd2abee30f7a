#pragma once
// From components to principal axes and back. z is always a principal axis here, so only the axes in the
// plane turn; a law written in principal stresses needs no more than this file. E. A. de Souza Neto, D.
// Perić, D. R. J. Owen, Computational Methods for Plasticity, Wiley 2008, appendix A.

#include <Eigen/Core>

#include "model/material.hpp"

namespace ashlar::elasticity {

/// Axes n and t in the plane by their double angle from x, and z. Components: (n, t, z), σ_n ≥ σ_t.
struct PrincipalAxes {
  double cos2 = 1, sin2 = 0;
  Eigen::Vector3d stress;  ///< principal stresses (n, t, z)
};
PrincipalAxes principal_axes(const model::Voigt& stress);

/// Places of the greatest, middle and least of three values; equal ones keep their order.
std::array<int, 3> descending(const Eigen::Vector3d& values);

/// An isotropic law's answer in principal axes. The trial stress has the same axes.
struct PrincipalAnswer {
  Eigen::Vector3d stress;
  Eigen::Matrix3d tangent;  ///< ∂σ_i/∂ε_j
};

/// Stress and tangent in components. The tangent's shear entry in the axes (n, t) is the spin of the axes,
/// μ (σ_n − σ_t)/(σ_n − σ_t)_trial, and its limit where the trial values are the same to 10⁻⁸.
model::Response in_components(const PrincipalAxes& trial, const PrincipalAnswer& answer, double mu);

/// RᵀDR: a tangent in axes turned counter-clockwise by half the double angle, in components x, y.
model::Tangent turned(const Eigen::Matrix4d& local, double cos2, double sin2);

}  // namespace ashlar::elasticity
