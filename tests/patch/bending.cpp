#include <gtest/gtest.h>

#include <map>

#include "modules/elasticity/cells.hpp"
#include "patch/solid.hpp"
#include "testing/meshes.hpp"

namespace ashlar::patch {
namespace {

using elasticity::Elastic;
using model::Plane;

/// A mesh of given cells: edges in the order of their first cell.
mesh::Mesh make_mesh(std::vector<Point> points, std::vector<std::vector<Index>> cells) {
  mesh::Mesh mesh;
  mesh.points = std::move(points);
  mesh.regions = {"solid"};
  mesh.cell_region.assign(cells.size(), 0);
  std::map<std::array<Index, 2>, Index> known;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    mesh.cell_points.append(cells[c]);
    std::vector<Index> edges;
    for (std::size_t i = 0; i < cells[c].size(); ++i) {
      const Index a = cells[c][i], b = cells[c][(i + 1) % cells[c].size()];
      const auto [at, is_new] = known.emplace(std::array{std::min(a, b), std::max(a, b)}, mesh.edge_count());
      if (is_new) {
        mesh.edge_points.push_back({a, b});
        mesh.edge_cells.push_back({static_cast<Index>(c), -1});
      } else {
        mesh.edge_cells[at->second][1] = static_cast<Index>(c);
      }
      edges.push_back(at->second);
    }
    mesh.cell_edges.append(edges);
  }
  return mesh;
}

/// n × n quadrilaterals mapped by `place(s, t)`, s and t in [0, 1].
template <class Place>
mesh::Mesh mapped(Index n, Place place) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> cells;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) points.push_back(place(1.0 * i / n, 1.0 * j / n));
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      cells.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return make_mesh(std::move(points), std::move(cells));
}

/// The paper's Example 1: upper tip over exact for two quads whose inner edge is tilted by ±d.
double cantilever(double d, std::shared_ptr<const elasticity::Stabilisation> stabilisation) {
  const double length = 40, b = 8, moment = 16;
  Solid solid(make_mesh({{0, 0}, {length / 2 + d, 0}, {length, 0}, {length, b}, {length / 2 - d, b}, {0, b}},
                        {{0, 1, 4, 5}, {1, 2, 3, 4}}),
              std::make_shared<Elastic>(1000, 0, Plane::stress), std::move(stabilisation));
  for (const Index point : {0, 5}) solid.hold(point, 0, 0);
  solid.hold(0, 1, 0);
  solid.load[solid.model.dofs.of_point(2)] = moment / b;
  solid.load[solid.model.dofs.of_point(3)] = -moment / b;
  EXPECT_FALSE(solid.solve().empty());
  return solid.displacement(3).y / 0.3;
}

/// Prints figures for the read-me.
void print(const std::string& name, const std::vector<double>& figures) {
  std::printf("[ figures  ] %-22s", (name + ":").c_str());
  for (const double figure : figures) std::printf("  %.4f", figure);
  std::puts("");
}

// Elements with the four corner points alone: bilinear .2424 .1274 .0846, incompatible modes 1 .606 .412.
TEST(cantilever, two_quads_bend_as_well_as_four_points_can) {
  for (const auto& [name, stabilisation] : elasticity::testing::stabilisations()) {
    std::vector<double> tip;
    for (const double ratio : {0.0, 0.5, 1.0, 1.5, 2.0}) tip.push_back(cantilever(4 * ratio, stabilisation));
    print(name, tip);
    if (name != "bending") continue;
    EXPECT_NEAR(tip[0], 1, 1e-12);
    // This element's own figures; they guard it against silent change.
    EXPECT_NEAR(tip[2], 0.6246, 1e-3);
    EXPECT_NEAR(tip[4], 0.5583, 1e-3);
  }
}

/// Pure bending of a beam `length` × 1 on a mesh of the unit square stretched to it: mean turn of the free
/// end over the exact one.
double beam(mesh::Mesh mesh, double length, std::shared_ptr<const elasticity::Stabilisation> stabilisation) {
  const double e = 100, nu = 0.3, curvature = 1e-3;
  for (Point& p : mesh.points) p = {length * p.x, p.y - 0.5};
  Solid solid(std::move(mesh), std::make_shared<Elastic>(e, nu, Plane::stress), std::move(stabilisation));
  const auto exact = [&](Point p) {
    return Point{curvature * p.x * p.y, -0.5 * curvature * (p.x * p.x + nu * p.y * p.y)};
  };
  for (const Index edge : solid.model.mesh.edge_groups.at("square.left"))
    for (const Index p : solid.model.mesh.edge_points[edge]) {
      solid.hold(p, 0, exact(solid.model.mesh.points[p]).x);
      solid.hold(p, 1, exact(solid.model.mesh.points[p]).y);
    }
  double work = 0, exact_work = 0;
  for (const Index edge : solid.model.mesh.edge_groups.at("square.right")) {
    const auto [a, b] = solid.model.mesh.edge_points[edge];
    const double ya = solid.model.mesh.points[a].y, yb = solid.model.mesh.points[b].y;
    const double pull = e * curvature * std::abs(yb - ya) / 6;
    solid.load[solid.model.dofs.of_point(a)] += pull * (2 * ya + yb);
    solid.load[solid.model.dofs.of_point(b)] += pull * (ya + 2 * yb);
  }
  EXPECT_FALSE(solid.solve().empty());
  for (Index p = 0; p < solid.model.mesh.point_count(); ++p) {
    const double force = solid.load[solid.model.dofs.of_point(p)];
    work += force * solid.displacement(p).x;
    exact_work += force * exact(solid.model.mesh.points[p]).x;
  }
  return work / exact_work;
}

TEST(beam, polygons_bend_alike_whatever_the_stabilisation) {
  for (const auto& family : testing::ugly_families()) {
    for (const auto& [name, stabilisation] : elasticity::testing::stabilisations()) {
      std::vector<double> turn;
      for (const double length : {1.0, 4.0})
        for (const int n : {4, 8, 16, 32})
          turn.push_back(beam(testing::square_mesh(family.make(n)), length, stabilisation));
      print(family.name + ", " + name, turn);
      EXPECT_NEAR(turn.back(), 1, 0.05);
    }
  }
}

Point cook(double s, double t) {
  return {48 * s, 44 * s + t * (44 + s * (16 - 44))};
}

Solid cook_membrane(Index n, double e, double nu, Plane plane, double shear,
                    std::shared_ptr<const elasticity::Stabilisation> stabilisation) {
  Solid solid(mapped(n, cook), std::make_shared<Elastic>(e, nu, plane), std::move(stabilisation));
  const mesh::Mesh& mesh = solid.model.mesh;
  for (Index p = 0; p < mesh.point_count(); ++p)
    if (mesh.points[p].x == 0)
      for (const int c : {0, 1}) solid.hold(p, c, 0);
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto [a, b] = mesh.edge_points[edge];
    if (mesh.points[a].x == 48 && mesh.points[b].x == 48) solid.pull(edge, {0, shear});
  }
  EXPECT_FALSE(solid.solve().empty());
  return solid;
}

TEST(cook, plane_stress_tends_to_the_reference) {
  for (const auto& [name, stabilisation] : elasticity::testing::stabilisations()) {
    std::vector<double> tip;
    for (const Index n : {4, 8, 16, 32, 64}) {
      const Solid solid = cook_membrane(n, 1, 1.0 / 3, Plane::stress, 1.0 / 16, stabilisation);
      tip.push_back(solid.displacement((n / 2) * (n + 1) + n).y);
    }
    print(name, tip);
    EXPECT_NEAR(tip.back(), 23.967, 0.05) << name;
  }
}

TEST(cook, near_incompressible_plane_strain_does_not_lock) {
  for (const auto& [name, stabilisation] : elasticity::testing::stabilisations()) {
    std::vector<double> tip;
    for (const Index n : {4, 8, 16, 32, 64}) {
      const Solid solid = cook_membrane(n, 250, 0.4999, Plane::strain, 6.25, stabilisation);
      tip.push_back(solid.displacement((n + 1) * (n + 1) - 1).y);
    }
    print(name, tip);
    EXPECT_NEAR(tip.back(), 7.765, 0.08) << name;
  }
}

}  // namespace
}  // namespace ashlar::patch
