#include <gtest/gtest.h>

#include "framework/mesh/conformity.hpp"
#include "framework/mesh/zoo.hpp"
#include "meshing_gmsh/gmsh_mesh.hpp"

using namespace ashlar::mesh;
namespace core = ashlar::core;
namespace geo = ashlar::geometry;

namespace {

RawMesh generate(const Domain& domain, const GeneratorSettings& said) {
  return ashlar::meshing_gmsh::generate(domain,
                                        said.with({{"size", {}},
                                                   {"refine", {}},
                                                   {"cells", core::make_value(std::string("triangles"))},
                                                   {"algorithm", core::make_value(std::string("frontal"))},
                                                   {"grading", core::make_value(0.3)}}));
}

int count_corners(const RawMesh& mesh, int corners) {
  int count = 0;
  for (Index c = 0; c < mesh.cell_points.size(); ++c) count += mesh.cell_points.count(c) == corners;
  return count;
}

double length_near(const RawMesh& mesh, Point p, double radius) {
  double sum = 0;
  int count = 0;
  for (Index c = 0; c < mesh.cell_points.size(); ++c) {
    const auto cell = mesh.cell_points[c];
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Point a = mesh.points[cell[k]], b = mesh.points[cell[(k + 1) % cell.size()]];
      if (geo::distance(0.5 * (a + b), p) > radius) continue;
      sum += geo::distance(a, b);
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

TEST(gmsh, conforms_over_the_zoo) {
  for (const auto& [name, domain, size] : zoo()) {
    for (const std::string cells : {"triangles", "quads"}) {
      const RawMesh mesh = generate(domain, GeneratorSettings().set("size", size).set("cells", cells));
      EXPECT_EQ(Conformity(domain, mesh).faults(), "") << name << ' ' << cells;
    }
  }
}

TEST(gmsh, every_algorithm_conforms) {
  const Domain domain = jointed_dam();
  for (const std::string algorithm : {"frontal", "delaunay", "meshadapt"}) {
    const RawMesh mesh = generate(domain, GeneratorSettings().set("size", 0.7).set("algorithm", algorithm));
    EXPECT_EQ(Conformity(domain, mesh).faults(), "") << algorithm;
    EXPECT_EQ(count_corners(mesh, 3), mesh.cell_points.size());
  }
}

TEST(gmsh, quads_are_mostly_quads) {
  const RawMesh mesh =
      generate(jointed_dam(), GeneratorSettings().set("size", 0.4).set("cells", std::string("quads")));
  EXPECT_GT(count_corners(mesh, 4), 10 * count_corners(mesh, 3));
  EXPECT_EQ(count_corners(mesh, 3) + count_corners(mesh, 4), mesh.cell_points.size());
}

TEST(gmsh, same_settings_same_bits) {
  const auto mesh = [] {
    return generate(jointed_dam(), GeneratorSettings().set("size", 0.4).set("cells", std::string("quads")));
  };
  const RawMesh a = mesh(), b = mesh();
  EXPECT_EQ(a.points, b.points);
  EXPECT_TRUE(std::ranges::equal(a.cell_points.values(), b.cell_points.values()));
}

TEST(gmsh, follows_sizes) {
  core::Table map;
  map.entries = {{"rock", core::make_value(1.0)}, {"dam", core::make_value(0.25)}};
  const auto settings = GeneratorSettings()
                            .set("size", core::make_value(map))
                            .refine("joint", core::make_value(std::string("fault")), 0.1, 0.2);
  const RawMesh mesh = generate(jointed_dam(), settings);
  EXPECT_EQ(Conformity(jointed_dam(), mesh).faults(), "");
  EXPECT_NEAR(length_near(mesh, {20, 4}, 2), 1.0, 0.2);
  EXPECT_NEAR(length_near(mesh, {11.5, 12.5}, 1), 0.25, 0.05);
  EXPECT_NEAR(length_near(mesh, {7, 7}, 0.15), 0.1, 0.03);
}
