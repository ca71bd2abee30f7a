#include "elasticity/stabilisation.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::elasticity {

namespace {

/// Slivers flatter than 1:100 are treated as 1:100, so that no direction is left without stiffness.
constexpr double least_aspect = 1e-2;

/// |E|/4 (a⊗a/|a|⁴ + b⊗b/|b|⁴), a and b the half lengths of a quadrilateral's midlines.
Tensor2 of_quadrilateral(const CellShape& shape) {
  const Scratch<Point>& x = shape.offset;
  const Point a = 0.25 * (x[1] + x[2] - x[0] - x[3]), b = 0.25 * (x[2] + x[3] - x[0] - x[1]);
  const double least = least_aspect * least_aspect * std::max(dot(a, a), dot(b, b));
  const double aa = std::max(dot(a, a), least), bb = std::max(dot(b, b), least);
  const double to_a = 0.25 * shape.area / (aa * aa), to_b = 0.25 * shape.area / (bb * bb);
  return {to_a * a.x * a.x + to_b * b.x * b.x, to_a * a.x * a.y + to_b * b.x * b.y,
          to_a * a.y * a.y + to_b * b.y * b.y};
}

/// √(λ₂/λ₁) along the long axis of J (moments λ₁ ≥ λ₂), 1 across it.
Tensor2 of_polygon(const CellShape& shape) {
  const Tensor2& j = shape.second_moment;
  const double middle = 0.5 * (j.xx + j.yy), half = 0.5 * (j.xx - j.yy);
  const double greatest = middle + std::sqrt(half * half + j.xy * j.xy);
  const double least = std::max(2 * middle - greatest, least_aspect * least_aspect * greatest);
  // I − (J − λ₂ I)/(λ₁ + √(λ₁λ₂)), which knows no special case for round cells.
  const double share = 1 / (greatest + std::sqrt(greatest * least));
  return {1 - share * (j.xx - least), -share * j.xy, 1 - share * (j.yy - least)};
}

/// 3/2 μ of each dof's share in the consistent stiffness, at least their mean.
void diagonal_weights(const model::Material& material, std::span<const double> slope, std::span<double> d) {
  double sum = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    d[i] = 1.5 * material.shear_modulus() * slope[i];
    sum += d[i];
  }
  // A corner between collinear short edges has next to no slope, yet needs a stiffness.
  for (double& weight : d) weight = std::max(weight, sum / static_cast<double>(d.size()));
}

}  // namespace

Tensor2 BendingStabilisation::weigh(const CellShape& shape, const model::Material& material,
                                    std::span<double> d) const {
  std::fill(d.begin(), d.end(), 1.0);
  const Tensor2 t = d.size() == 4 ? of_quadrilateral(shape) : of_polygon(shape);
  const double scale = material.plane_modulus() / 3;
  return {scale * t.xx, scale * t.xy, scale * t.yy};
}

void BendingStabilisation::weigh_dofs(const model::Material& material, std::span<const double> slope,
                                      std::span<double> d) const {
  diagonal_weights(material, slope, d);
}

void ShearStabilisation::weigh_dofs(const model::Material& material, std::span<const double>,
                                    std::span<double> d) const {
  std::fill(d.begin(), d.end(), factor_ * material.shear_modulus());
}

Tensor2 ShearStabilisation::weigh(const CellShape&, const model::Material& material,
                                  std::span<double> d) const {
  std::fill(d.begin(), d.end(), 1.0);
  const double scale = factor_ * material.shear_modulus();
  return {scale, 0, scale};
}

Tensor2 DiagonalStabilisation::weigh(const CellShape& shape, const model::Material& material,
                                     std::span<double> d) const {
  Scratch<double> slope(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) slope[i] = shape.area * dot(shape.slope[i], shape.slope[i]);
  weigh_dofs(material, slope, d);
  return {};
}

void DiagonalStabilisation::weigh_dofs(const model::Material& material, std::span<const double> slope,
                                       std::span<double> d) const {
  diagonal_weights(material, slope, d);
}

}  // namespace ashlar::elasticity
