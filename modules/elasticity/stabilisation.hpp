#pragma once
// What the projection does not see, u − Πu in the dofs, gets the energy ½ t Σ_i d_i (u−Πu)_i · T (u−Πu)_i.
// A choice of stabilisation says T and d. It must be positive definite, turn with the cell, and stay bounded
// for ν → ½: it may use the shear modulus or the plane modulus (at most 4μ), never λ.

#include <memory>
#include <span>

#include "elasticity/cell_shape.hpp"
#include "model/material.hpp"

namespace ashlar::elasticity {

class Stabilisation {
 public:
  virtual ~Stabilisation() = default;
  /// Order 1: returns T [Pa] and fills d (one number a corner).
  virtual Tensor2 weigh(const CellShape& shape, const model::Material& material,
                        std::span<double> d) const = 0;
  /// Orders 2 and 3: T = I, and d [Pa] for each scalar dof. `slope`: |E| |∇Πφ_i|² of each, its share in the
  /// consistent stiffness for a modulus of one.
  virtual void weigh_dofs(const model::Material& material, std::span<const double> slope,
                          std::span<double> d) const = 0;
};

/// A module registers a choice as kind "stabilisation" with this signature.
using MakeStabilisation = std::shared_ptr<const Stabilisation>(const core::Settings& settings);

/// As stiff as the cell is against bending, for every aspect and every ν. d = 1 and
///   quadrilaterals:  T = E'/3 · |E|/4 (a⊗a/|a|⁴ + b⊗b/|b|⁴), a and b half their midlines: what the linear
///                    stresses of Pian and Sumihara's hybrid element resist (1984), exact on parallelograms;
///   other polygons:  T = E'/3 · (√(λ₂/λ₁) along the long axis, 1 across), λ₁ ≥ λ₂ their second moments: as
///                    rectangles along; across, their corners see quadratic bending that four corners do not;
///   orders 2 and 3:  the diagonal recipe. Their projection sees bending, and d = μ gives up to
///                    3.6 (order 2) and 24 times (order 3) the error on squares.
class BendingStabilisation final : public Stabilisation {
 public:
  Tensor2 weigh(const CellShape& shape, const model::Material& material, std::span<double> d) const override;
  void weigh_dofs(const model::Material& material, std::span<const double> slope,
                  std::span<double> d) const override;
};

/// T = factor μ I, d = 1.
class ShearStabilisation final : public Stabilisation {
 public:
  explicit ShearStabilisation(double factor) : factor_(factor) {}
  Tensor2 weigh(const CellShape& shape, const model::Material& material, std::span<double> d) const override;
  void weigh_dofs(const model::Material& material, std::span<const double> slope,
                  std::span<double> d) const override;

 private:
  double factor_;
};

/// The diagonal recipe, with the shear part of the consistent stiffness alone: T = I and d_i = 3/2 μ |E|
/// |g_i|² (half the trace of corner i's block), at least its mean over the corners. The same for every dof of
/// orders 2 and 3.
class DiagonalStabilisation final : public Stabilisation {
 public:
  Tensor2 weigh(const CellShape& shape, const model::Material& material, std::span<double> d) const override;
  void weigh_dofs(const model::Material& material, std::span<const double> slope,
                  std::span<double> d) const override;
};

}  // namespace ashlar::elasticity
