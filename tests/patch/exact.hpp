#pragma once
// Displacements that are polynomials, the stresses and body forces that go with them, and how far a solid is
// off.

#include <complex>
#include <string>

#include "patch/solid.hpp"

namespace ashlar::patch {

using Complex = std::complex<double>;

/// A displacement with its stress and the body force that it needs.
struct Exact {
  std::string name;
  std::function<Point(Point)> displacement;
  std::function<model::Voigt(Point)> stress;
  Point body_force;
};

/// Kolosov and Muskhelishov: 2μ(u + iv) = κ φ − z φ̄' − ψ̄ with φ = a zᵏ, ψ = b zᵏ; no body force.
inline Exact kolosov(int degree, double mu, double nu, model::Plane plane, Point centre = {0.3, 0.1}) {
  const double kappa = plane == model::Plane::strain ? 3 - 4 * nu : (3 - nu) / (1 + nu);
  const double n = degree;
  const Complex a{0.3, -0.2}, b{-0.1, 0.4};
  Exact exact;
  exact.name = "kolosov";
  exact.displacement = [=](Point p) {
    const Complex z{p.x - centre.x, p.y - centre.y};
    const Complex slope = n * a * std::pow(z, degree - 1);
    const Complex u =
        (kappa * a * std::pow(z, degree) - z * std::conj(slope) - std::conj(b * std::pow(z, degree))) /
        (2 * mu);
    return Point{u.real(), u.imag()};
  };
  exact.stress = [=](Point p) {
    const Complex z{p.x - centre.x, p.y - centre.y};
    const Complex slope = n * a * std::pow(z, degree - 1);
    const Complex curve = degree > 1 ? n * (n - 1) * a * std::pow(z, degree - 2) : 0.0;
    const double sum = 4 * slope.real();
    const Complex difference = 2.0 * (std::conj(z) * curve + n * b * std::pow(z, degree - 1));
    const double zz = plane == model::Plane::strain ? nu * sum : 0;
    return model::Voigt{(sum - difference.real()) / 2, (sum + difference.real()) / 2, difference.imag() / 2,
                        zz};
  };
  return exact;
}

/// u = (x² + xy, y² − 2xy): linear stresses that a constant body force holds in balance.
inline Exact weighed(const elasticity::Elastic& law, double mu) {
  Exact exact;
  exact.name = "weighed";
  const double scale = 0.1 / mu;
  exact.displacement = [=](Point p) {
    return Point{scale * (p.x * p.x + p.x * p.y), scale * (p.y * p.y - 2 * p.x * p.y)};
  };
  exact.stress = [=, &law](Point p) {
    return law
        .respond({scale * (2 * p.x + p.y), scale * (2 * p.y - 2 * p.x), scale * (p.x - 2 * p.y), 0}, {}, {})
        .stress;
  };
  const auto d = law.respond({}, {}, {}).tangent;
  // −∂σ_xx/∂x − ∂σ_xy/∂y and −∂σ_xy/∂x − ∂σ_yy/∂y.
  exact.body_force = {-scale * (d[0] * 2 + d[1] * -2 + d[10] * -2),
                      -scale * (d[10] * 1 + d[4] * 1 + d[5] * 2)};
  return exact;
}

struct Errors {
  double displacement = 0, stress = 0;
};

inline Errors errors(Solid& solid, const Exact& exact) {
  Errors worst;
  double u_scale = 0, s_scale = 0;
  const auto u = solid.state.committed(0);
  const auto compare = [&](Index dof, Point at) {
    const Point expected = exact.displacement(at);
    worst.displacement = std::max(worst.displacement, distance({u[dof], u[dof + 1]}, expected));
    u_scale = std::max(u_scale, norm(expected));
  };
  for (Index p = 0; p < solid.model.mesh.point_count(); ++p)
    compare(solid.model.dofs.of_point(p), solid.model.mesh.points[p]);
  for (Index e = 0; e < solid.model.mesh.edge_count(); ++e)
    for (int k = 0; k < solid.model.dofs.field().per_edge; ++k)
      compare(solid.model.dofs.of_edge(e, k), solid.edge_node(e, k));
  const auto cells = elasticity::cell_stresses(solid.model, elasticity::Layout(solid.model), u);
  for (const elasticity::Sample& sample : cells.sample) {
    if (sample.area == 0) continue;
    const model::Voigt expected = exact.stress(sample.at);
    for (std::size_t k = 0; k < 4; ++k) {
      worst.stress = std::max(worst.stress, std::abs(sample.stress[k] - expected[k]));
      s_scale = std::max(s_scale, std::abs(expected[k]));
    }
  }
  return {worst.displacement / u_scale, worst.stress / s_scale};
}

}  // namespace ashlar::patch
