// Patch tests of degree k: displacements that are polynomials of the element's order, in equilibrium, come
// out exactly on every family of meshes.

#include <gtest/gtest.h>

#include <complex>

#include "elasticity/fem.hpp"
#include "elasticity/vem_high.hpp"
#include "elasticity/vem_projected.hpp"
#include "modules/elasticity/cells.hpp"
#include "patch/solid.hpp"
#include "testing/meshes.hpp"

namespace ashlar::patch {
namespace {

using elasticity::Elastic;
using model::Plane;
using Complex = std::complex<double>;

/// A displacement with its stress and the body force that it needs.
struct Exact {
  std::string name;
  std::function<Point(Point)> displacement;
  std::function<model::Voigt(Point)> stress;
  Point body_force;
};

/// Kolosov and Muskhelishov: 2μ(u + iv) = κ φ − z φ̄' − ψ̄ with φ = a zᵏ, ψ = b zᵏ; no body force.
Exact kolosov(int degree, double mu, double nu, Plane plane) {
  const double kappa = plane == Plane::strain ? 3 - 4 * nu : (3 - nu) / (1 + nu);
  const double n = degree;
  const Complex a{0.3, -0.2}, b{-0.1, 0.4};
  Exact exact;
  exact.name = "kolosov";
  exact.displacement = [=](Point p) {
    const Complex z{p.x - 0.3, p.y - 0.1};
    const Complex slope = n * a * std::pow(z, degree - 1);
    const Complex u =
        (kappa * a * std::pow(z, degree) - z * std::conj(slope) - std::conj(b * std::pow(z, degree))) /
        (2 * mu);
    return Point{u.real(), u.imag()};
  };
  exact.stress = [=](Point p) {
    const Complex z{p.x - 0.3, p.y - 0.1};
    const Complex slope = n * a * std::pow(z, degree - 1);
    const Complex curve = degree > 1 ? n * (n - 1) * a * std::pow(z, degree - 2) : 0.0;
    const double sum = 4 * slope.real();
    const Complex difference = 2.0 * (std::conj(z) * curve + n * b * std::pow(z, degree - 1));
    const double zz = plane == Plane::strain ? nu * sum : 0;
    return model::Voigt{(sum - difference.real()) / 2, (sum + difference.real()) / 2, difference.imag() / 2,
                        zz};
  };
  return exact;
}

/// u = (x² + xy, y² − 2xy): linear stresses that a constant body force holds in balance.
Exact weighed(const Elastic& law, double mu) {
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

Errors errors(Solid& solid, const Exact& exact) {
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

class Degree : public ::testing::TestWithParam<testing::MeshFamily> {};
INSTANTIATE_TEST_SUITE_P(patch, Degree, ::testing::ValuesIn(testing::ugly_families()), [](const auto& info) {
  std::string name = info.param.name;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

/// Solves the patch test and holds its errors against the tolerances; returns them.
Errors patch_test(const mesh::Mesh& mesh, const std::shared_ptr<const model::Element>& element,
                  const Exact& exact, const std::shared_ptr<const Elastic>& law, double tolerance,
                  Plane plane = Plane::strain) {
  SCOPED_TRACE(exact.name);
  Solid solid(mesh, law, element, plane);
  solid.hold_border(exact.displacement);
  solid.weigh(exact.body_force);
  if (solid.solve().empty()) {
    ADD_FAILURE() << solid.failure;
    return {};
  }
  const Errors found = errors(solid, exact);
  EXPECT_LT(found.displacement, tolerance);
  // Stresses differentiate over a cell: the error grows by the number of cells across.
  EXPECT_LT(found.stress, 100 * tolerance);
  return found;
}

bool takes_all(const model::Element& element, const mesh::Mesh& mesh) {
  std::vector<Point> corners;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (!element.refuses({mesh.corners(cell, corners)}).empty()) return false;
  return true;
}

TEST_P(Degree, polynomials_of_the_elements_order_are_exact) {
  const double tolerance[] = {1e-12, 1e-11, 1e-10};
  const mesh::Mesh mesh = testing::square_mesh(GetParam().make(5));
  for (int order = 2; order <= 3; ++order) {
    Errors worst;
    for (const auto& [choice, stabilisation] : elasticity::testing::stabilisations())
      for (const Plane plane : {Plane::strain, Plane::stress})
        for (const double nu : {0.0, 0.3, 0.4999}) {
          SCOPED_TRACE(choice + ", order " + std::to_string(order) + ", nu " + std::to_string(nu));
          const double mu = 1e10;
          const auto law = std::make_shared<Elastic>(2 * mu * (1 + nu), nu, plane);
          const auto element = std::make_shared<elasticity::VemHigh>(order, stabilisation);
          std::vector<Exact> fields = {weighed(*law, mu)};
          for (int degree = 1; degree <= order; ++degree) fields.push_back(kolosov(degree, mu, nu, plane));
          for (const Exact& exact : fields) {
            const Errors found = patch_test(mesh, element, exact, law, tolerance[order - 1]);
            worst.displacement = std::max(worst.displacement, found.displacement);
            worst.stress = std::max(worst.stress, found.stress);
          }
        }
    std::printf("%s, order %d: displacement %.1e, stress %.1e\n", GetParam().name.c_str(), order,
                worst.displacement, worst.stress);
  }
}

TEST_P(Degree, finite_elements_pass_on_the_cells_that_they_take) {
  const mesh::Mesh mesh = testing::square_mesh(GetParam().make(5));
  std::vector<Point> corners;
  for (const auto& [order, incompatible] : {std::pair{1, false}, {1, true}, {2, false}}) {
    SCOPED_TRACE("order " + std::to_string(order) + (incompatible ? ", incompatible" : ""));
    const auto element = std::make_shared<elasticity::FiniteElement>(order, incompatible);
    bool triangles = true;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      mesh.corners(cell, corners);
      triangles = triangles && corners.size() == 3;
    }
    if (!takes_all(*element, mesh)) continue;
    const auto law = std::make_shared<Elastic>(2.6e10, 0.3, Plane::strain);
    patch_test(mesh, element, kolosov(1, 1e10, 0.3, Plane::strain), law, 1e-12);
    // Serendipity quadrilaterals hold all quadratics on parallelograms only.
    if (order == 2 && triangles) patch_test(mesh, element, weighed(*law, 1e10), law, 1e-11);
  }
}

TEST_P(Degree, polynomials_are_exact_without_stabilisation) {
  const double tolerance[] = {1e-12, 1e-11, 1e-10};
  const mesh::Mesh mesh = testing::square_mesh(GetParam().make(4));
  for (int order = 1; order <= 3; ++order) {
    Errors worst;
    for (const double nu : {0.3, 0.4999}) {
      SCOPED_TRACE("order " + std::to_string(order) + ", nu " + std::to_string(nu));
      const double mu = 1e10;
      const auto law = std::make_shared<Elastic>(2 * mu * (1 + nu), nu, Plane::strain);
      const auto element = std::make_shared<elasticity::VemProjected>(order, false, nullptr);
      if (!takes_all(*element, mesh)) continue;
      std::vector<Exact> fields;
      if (order > 1) fields.push_back(weighed(*law, mu));
      for (int degree = 1; degree <= order; ++degree)
        fields.push_back(kolosov(degree, mu, nu, Plane::strain));
      for (const Exact& exact : fields) {
        const Errors found = patch_test(mesh, element, exact, law, tolerance[order - 1]);
        worst.displacement = std::max(worst.displacement, found.displacement);
        worst.stress = std::max(worst.stress, found.stress);
      }
    }
    std::printf("%s, order %d without stabilisation: displacement %.1e, stress %.1e\n",
                GetParam().name.c_str(), order, worst.displacement, worst.stress);
  }
}

/// u_r = α r z, u_z = β z² + γ r² is in balance by itself if 2μ γ = −(μ α + λ (α + β) + 2μ β); degree 1: u_r
/// = α r, u_z = β z.
Exact around_the_axis(int degree, const Elastic& law, double mu, double nu) {
  const double alpha = 0.3 / mu, beta = -0.5 / mu, lambda = 2 * mu * nu / (1 - 2 * nu);
  const double gamma = -(mu * alpha + lambda * (alpha + beta) + 2 * mu * beta) / (2 * mu);
  Exact exact;
  exact.name = "around the axis, degree " + std::to_string(degree);
  if (degree == 1) {
    exact.displacement = [=](Point p) { return Point{alpha * p.x, beta * p.y}; };
    exact.stress = [=, &law](Point) { return law.respond({alpha, beta, 0, alpha}, {}, {}).stress; };
    return exact;
  }
  exact.displacement = [=](Point p) {
    return Point{alpha * p.x * p.y, beta * p.y * p.y + gamma * p.x * p.x};
  };
  exact.stress = [=, &law](Point p) {
    return law.respond({alpha * p.y, 2 * beta * p.y, (alpha + 2 * gamma) * p.x, alpha * p.y}, {}, {}).stress;
  };
  return exact;
}

TEST_P(Degree, polynomials_are_exact_around_an_axis) {
  const double tolerance[] = {1e-12, 1e-11, 1e-10}, mu = 1e10;
  const mesh::Mesh mesh = testing::square_mesh(GetParam().make(4));
  for (int order = 1; order <= 3; ++order)
    for (const double nu : {0.3, 0.4999})
      for (const bool stabilised : {true, false}) {
        SCOPED_TRACE("order " + std::to_string(order) + (stabilised ? "" : ", not stabilised"));
        const auto bending = std::make_shared<elasticity::BendingStabilisation>();
        std::shared_ptr<const model::Element> rest;
        if (stabilised && order == 1) rest = std::make_shared<elasticity::VemElement>(bending);
        if (stabilised && order > 1) rest = std::make_shared<elasticity::VemHigh>(order, bending);
        const auto element = std::make_shared<elasticity::VemProjected>(order, true, rest);
        if (!takes_all(*element, mesh)) continue;
        const auto law = std::make_shared<Elastic>(2 * mu * (1 + nu), nu, Plane::strain);
        for (int degree = 1; degree <= std::min(order, 2); ++degree)
          // Round-off in changes of volume weighs λ/μ times as much: 5000 at ν = 0.4999.
          patch_test(mesh, element, around_the_axis(degree, *law, mu, nu), law,
                     tolerance[order - 1] * (nu > 0.4 ? 10 : 1), Plane::axisymmetric);
      }
}

}  // namespace
}  // namespace ashlar::patch
