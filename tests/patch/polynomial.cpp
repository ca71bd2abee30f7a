// Patch tests of degree k: displacements that are polynomials of the element's order, in equilibrium, come
// out exactly on every family of meshes.

#include <gtest/gtest.h>

#include "elasticity/fem.hpp"
#include "elasticity/vem_high.hpp"
#include "elasticity/vem_projected.hpp"
#include "modules/elasticity/cells.hpp"
#include "patch/exact.hpp"
#include "testing/meshes.hpp"

namespace ashlar::patch {
namespace {

using elasticity::Elastic;
using model::Plane;

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
        // Round-off in changes of volume weighs λ/μ times as much: 5000 at ν = 0.4999.
        const Errors found =
            patch_test(mesh, element, exact, law, tolerance[order - 1] * (nu > 0.4 ? 10 : 1));
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
