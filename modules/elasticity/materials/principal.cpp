#include "elasticity/materials/principal.hpp"

#include <cmath>

namespace ashlar::elasticity {

namespace {

// Trial values nearer than this share of the greatest stress count as one: their quotient would be rounding.
constexpr double same = 1e-8;

}  // namespace

PrincipalAxes principal_axes(const model::Voigt& stress) {
  const double mean = (stress[0] + stress[1]) / 2, half = (stress[0] - stress[1]) / 2;
  const double radius = std::hypot(half, stress[2]);
  PrincipalAxes axes;
  if (radius > 0) axes.cos2 = half / radius, axes.sin2 = stress[2] / radius;
  axes.stress = {mean + radius, mean - radius, stress[3]};
  return axes;
}

std::array<int, 3> descending(const Eigen::Vector3d& values) {
  // n ≥ t already: only z seeks its place.
  if (values[2] > values[0]) return {2, 0, 1};
  if (values[2] > values[1]) return {0, 2, 1};
  return {0, 1, 2};
}

model::Tangent turned(const Eigen::Matrix4d& local, double cos2, double sin2) {
  const double cc = (1 + cos2) / 2, ss = (1 - cos2) / 2, cs = sin2 / 2;
  Eigen::Matrix4d r;  // ε in the axes = R ε, and σ = Rᵀ σ in the axes
  r << cc, ss, cs, 0, ss, cc, -cs, 0, -2 * cs, 2 * cs, cos2, 0, 0, 0, 0, 1;
  const Eigen::Matrix4d product = r.transpose() * local * r;
  model::Tangent tangent;
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(tangent.data()) = product;
  return tangent;
}

model::Response in_components(const PrincipalAxes& trial, const PrincipalAnswer& answer, double mu) {
  const double n = answer.stress[0], t = answer.stress[1];
  const auto& d = answer.tangent;
  const double apart = trial.stress[0] - trial.stress[1];
  const double spin = apart > same * trial.stress.cwiseAbs().maxCoeff()
                          ? mu * (n - t) / apart
                          : (d(0, 0) - d(0, 1) - d(1, 0) + d(1, 1)) / 4;
  Eigen::Matrix4d local;
  local << d(0, 0), d(0, 1), 0, d(0, 2), d(1, 0), d(1, 1), 0, d(1, 2), 0, 0, spin, 0, d(2, 0), d(2, 1), 0,
      d(2, 2);
  const double cc = (1 + trial.cos2) / 2, ss = (1 - trial.cos2) / 2;
  return {{cc * n + ss * t, ss * n + cc * t, trial.sin2 / 2 * (n - t), answer.stress[2]},
          turned(local, trial.cos2, trial.sin2)};
}

}  // namespace ashlar::elasticity
