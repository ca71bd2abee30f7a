// Nearly incompressible bodies in plane strain: no locking.

#include <gtest/gtest.h>

#include <cmath>

#include "convergence/families.hpp"
#include "convergence/norms.hpp"
#include "testing/meshes.hpp"

namespace ashlar::convergence {
namespace {

struct Family {
  const char* name;
  int order;
};
std::string name_of(const ::testing::TestParamInfo<Family>& info) {
  return std::string(info.param.name) + std::to_string(info.param.order);
}

class Incompressible : public ::testing::TestWithParam<Family> {};

// The field keeps its volume, so that the exact displacement is the same for every ν.
TEST_P(Incompressible, errors_do_not_grow_with_nu) {
  const auto [family, order] = GetParam();
  const double mu = 1e9;
  const mesh::Mesh mesh = family_mesh(family, 12);
  Norms soft;
  for (const double nu : {0.3, 0.49, 0.4999, 0.4999999}) {
    patch::Solid solid(mesh,
                       std::make_shared<elasticity::Elastic>(2 * mu * (1 + nu), nu, model::Plane::strain),
                       vem(order, std::make_shared<elasticity::BendingStabilisation>()));
    const Norms error = solved_norms(solid, swirl(mu));
    if (nu == 0.3) soft = error;
    std::printf("%s, order %d, nu %.7g: %.3e (L2), %.3e (energy)\n", family, order, nu, error.displacement,
                error.energy);
    // Locking multiplies errors by hundreds; the best approximation that keeps its volume costs up to a half.
    EXPECT_LT(error.displacement, 1.5 * soft.displacement) << "nu " << nu;
    EXPECT_LT(error.energy, 1.5 * soft.energy) << "nu " << nu;
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Incompressible,
                         ::testing::Values(Family{"structured", 1}, Family{"distorted", 1},
                                           Family{"voronoi", 1}, Family{"structured", 2},
                                           Family{"distorted", 2}, Family{"voronoi", 2},
                                           Family{"triangles", 2}),
                         name_of);

class Cook : public ::testing::TestWithParam<Family> {};

// E = 250, ν = 0.4999, a shear of 6.25 on the right: its upper corner moves by 7.765 (256 × 256 cells).
TEST_P(Cook, nearly_incompressible_tip_is_right_on_32_by_32_cells) {
  const auto [family, order] = GetParam();
  mesh::RawMesh raw = family_raw(family, 32);
  for (Point& p : raw.points) p = {48 * p.x, 44 * p.x + p.y * (44 + p.x * (16 - 44))};
  raw.regions = {"panel"};
  patch::Solid solid(mesh::build_mesh(std::move(raw), mesh::Domain{}),
                     std::make_shared<elasticity::Elastic>(250, 0.4999, model::Plane::strain),
                     vem(order, std::make_shared<elasticity::BendingStabilisation>()));
  const mesh::Mesh& mesh = solid.model.mesh;
  Index corner = 0;
  for (Index p = 0; p < mesh.point_count(); ++p)
    if (mesh.points[static_cast<std::size_t>(p)] == Point{48, 60}) corner = p;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto [from, to] = mesh.edge_points[static_cast<std::size_t>(edge)];
    const double a = mesh.points[static_cast<std::size_t>(from)].x,
                 b = mesh.points[static_cast<std::size_t>(to)].x;
    if (a == 0 && b == 0) hold(solid, edge, [](Point) { return Point{}; });
    if (a == 48 && b == 48) pull(solid, edge, [](Point) { return Point{0, 6.25}; });
  }
  ASSERT_FALSE(solid.solve().empty()) << solid.failure;
  const double tip = solid.displacement(corner).y;
  std::printf("%s, order %d: %.4f\n", family, order, tip);
  // Straight edges across a bending field converge with h²: twice the half per cent of curved ones.
  EXPECT_NEAR(tip, 7.765, (order == 1 ? 0.01 : 0.005) * 7.765);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Cook,
                         ::testing::Values(Family{"structured", 1}, Family{"voronoi", 1},
                                           Family{"structured", 2}, Family{"voronoi", 2},
                                           Family{"triangles", 2}),
                         name_of);

}  // namespace
}  // namespace ashlar::convergence
