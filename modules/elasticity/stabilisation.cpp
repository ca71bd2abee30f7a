#include "elasticity/stabilisation.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::elasticity {

Tensor2 BendingStabilisation::weigh(const CellShape& shape, const model::Material& material,
                                    std::span<double> d) const {
  std::fill(d.begin(), d.end(), 1.0);
  // Slivers flatter than 1:100 are treated as 1:100, so that no direction is left without stiffness.
  const Tensor2& j = shape.second_moment;
  const double least = 1e-4 * (j.xx + j.yy);
  const double xx = j.xx + least, yy = j.yy + least;
  const double scale = material.plane_modulus() / (3 * std::sqrt(xx * yy - j.xy * j.xy));
  return {scale * yy, -scale * j.xy, scale * xx};
}

Tensor2 ShearStabilisation::weigh(const CellShape&, const model::Material& material,
                                  std::span<double> d) const {
  std::fill(d.begin(), d.end(), 1.0);
  const double scale = factor_ * material.shear_modulus();
  return {scale, 0, scale};
}

Tensor2 DiagonalStabilisation::weigh(const CellShape& shape, const model::Material& material,
                                     std::span<double> d) const {
  double sum = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    d[i] = 1.5 * material.shear_modulus() * shape.area * dot(shape.slope[i], shape.slope[i]);
    sum += d[i];
  }
  // A corner between collinear short edges has next to no slope, yet needs a stiffness.
  for (double& weight : d) weight = std::max(weight, sum / static_cast<double>(d.size()));
  return {};
}

}  // namespace ashlar::elasticity
