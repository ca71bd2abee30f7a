#include "meshing_structured/structured.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "framework/mesh/zoo.hpp"
#include "geometry/polygon.hpp"
#include "mesh/verify.hpp"

using namespace ashlar::mesh;
namespace core = ashlar::core;
namespace geo = ashlar::geometry;

namespace {

core::Value numbers(const std::vector<double>& values) {
  std::vector<core::Value> items;
  for (const double v : values) items.push_back(core::make_value(v));
  return list_of(items);
}

/// Settings of one region as `check` gives them.
GeneratorSettings& own_cells(GeneratorSettings& settings, const std::string& region,
                             const core::Value& cells) {
  core::Parameter parameter;
  parameter.forms = static_cast<unsigned>(core::Form::point);
  core::Schema schema{"structured_region", "structured_region", "", "", {}};
  for (const char* key : {"cells", "size", "grading"}) {
    parameter.key = key;
    schema.parameters.push_back(parameter);
  }
  core::Table table;
  table.entries = {{"cells", cells}};
  return settings.add("regions", region, core::make_value(table), schema);
}

RawMesh generate(const Domain& domain, const GeneratorSettings& said) {
  return ashlar::meshing_structured::generate(
      domain, said.with({{"cells", {}}, {"size", {}}, {"grading", core::make_value(1.0)}, {"regions", {}}}));
}

Mesh built(const Domain& domain, const GeneratorSettings& said) {
  Mesh mesh = build_mesh(generate(domain, said), domain);
  const auto faults = verify(mesh);
  EXPECT_TRUE(faults.empty()) << faults.front();
  double expected = 0;
  for (Index f = 0; f < static_cast<Index>(domain.faces.size()); ++f) {
    for (const auto& ring : domain.rings(f)) expected += geo::signed_area(ring);
  }
  EXPECT_NEAR(report(mesh).area, expected, 1e-13 * expected);
  return mesh;
}

std::string mistake(const Domain& domain, const GeneratorSettings& said) {
  try {
    generate(domain, said);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

GeneratorSettings sized(double size) {
  return GeneratorSettings().set("size", size);
}

}  // namespace

TEST(structured, rectangle_is_a_grid) {
  const Domain domain = zoo_domain({region("block", rectangle(4, 2))});
  const Mesh mesh = built(domain, GeneratorSettings().set("cells", numbers({8, 3})));
  EXPECT_EQ(mesh.cell_count(), 24);
  EXPECT_EQ(mesh.point_count(), 36);
  for (const Point p : mesh.points) {
    EXPECT_NEAR(2 * p.x, std::round(2 * p.x), 1e-14);
    EXPECT_NEAR(1.5 * p.y, std::round(1.5 * p.y), 1e-14);
  }
  EXPECT_EQ(built(domain, sized(0.5)).cell_count(), 32);
}

TEST(structured, grading_is_the_ratio_of_last_to_first) {
  const Domain domain = zoo_domain({region("block", rectangle(1, 1))});
  const Mesh mesh =
      built(domain, GeneratorSettings().set("cells", numbers({3, 2})).set("grading", numbers({4, 0.5})));
  std::vector<double> x;
  for (const Index e : mesh.edge_groups.at("block.bottom")) {
    x.push_back(geo::distance(mesh.points[mesh.edge_points[e][0]], mesh.points[mesh.edge_points[e][1]]));
  }
  ASSERT_EQ(x.size(), 3u);
  EXPECT_NEAR(x[0], 1.0 / 7, 1e-15);
  EXPECT_NEAR(x[1], 2.0 / 7, 1e-15);
  EXPECT_NEAR(x[2], 4.0 / 7, 1e-15);
  EXPECT_NE(nearest_point(mesh, {0, 2.0 / 3}), -1);
  EXPECT_NEAR(mesh.points[nearest_point(mesh, {0, 0.6})].y, 2.0 / 3, 1e-15);
}

TEST(structured, a_quadrilateral_may_be_as_flat_as_it_likes) {
  const Domain domain =
      zoo_domain({region("sliver", polygon({{0, 0}, {39.6, 0}, {0.4, 8}, {0, 8}}, {"", "", "", ""}))});
  EXPECT_EQ(built(domain, GeneratorSettings().set("cells", numbers({1, 1}))).cell_count(), 1);
  EXPECT_EQ(built(domain, GeneratorSettings().set("cells", numbers({6, 4}))).cell_count(), 24);
}

TEST(structured, mapped_sides_may_be_arcs) {
  geo::Shape sector = polygon({{1, 0}, {2, 0}, {0, 2}, {0, 1}}, {"", "outer", "", "inner"});
  sector.rings[0][1].arc = geo::Arc{{0, 0}, true};
  sector.rings[0][3].arc = geo::Arc{{0, 0}, false};
  const Domain domain = zoo_domain({region("ring", sector)}, {}, 0.3);
  const Mesh mesh = built(domain, GeneratorSettings().set("cells", numbers({4, 12})));
  EXPECT_EQ(mesh.cell_count(), 48);
  EXPECT_NEAR(report(mesh).area, 0.75 * std::numbers::pi, 0.01);
}

TEST(structured, neighbours_that_match_share_points_and_others_hang) {
  const Domain domain =
      zoo_domain({region("low", rectangle(6, 2)), region("high", polygon({{0, 2}, {6, 2}, {6, 4}, {0, 4}}))});
  const Mesh same = built(domain, sized(0.5));
  EXPECT_EQ(report(same).corners_max, 4);
  auto other = sized(0.5);
  const Mesh mesh = built(domain, own_cells(other, "high", numbers({5, 3})));
  EXPECT_GT(report(mesh).corners_max, 4);
  Index count = 0;
  bodies(mesh, count);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(mesh.point_count() - mesh.edge_count() + mesh.cell_count(), 1);
}

TEST(structured, dam_on_jointed_rock) {
  const Mesh mesh = built(jointed_dam(), sized(0.7));
  ASSERT_EQ(mesh.joints.size(), 1u);
  EXPECT_NEAR(mesh.joints[0].lips[0].back().s_to, std::hypot(6, 6), 1e-12);
  Index count = 0;
  bodies(mesh, count);
  EXPECT_EQ(count, 1);
}

TEST(structured, joints_through_and_across_regions) {
  const Domain domain = zoo_domain(
      {region("low", rectangle(6, 2)), region("high", polygon({{1, 2}, {5, 2}, {4, 4}, {2, 4}}))},
      {joint("a", {{0, 1.1}, {6, 0.7}}), joint("b", {{3.3, 4}, {2.6, 0.2}}), joint("c", {{1, 2}, {5, 2}})});
  const Mesh mesh = built(domain, sized(0.31));
  EXPECT_EQ(mesh.joints.size(), 3u);
  Index count = 0;
  bodies(mesh, count);
  EXPECT_EQ(count, 5);
}

TEST(structured, mistakes_say_what_to_do) {
  const Domain l_shape = zoo_domain({region("l", polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}))});
  EXPECT_TRUE(says(mistake(l_shape, sized(0.1)), "'l' is not four-sided"));
  EXPECT_TRUE(says(mistake(l_shape, sized(0.1)), "mesh.voronoi"));
  const Domain holed = zoo_domain({region("plate", without(rectangle(4, 4), circle({2, 2}, 0.5)))});
  EXPECT_TRUE(says(mistake(holed, sized(0.1)), "four-sided"));
  const Domain block = zoo_domain({region("block", rectangle(1, 1))});
  EXPECT_TRUE(says(mistake(block, GeneratorSettings()), "no cells and no size"));
  EXPECT_TRUE(says(mistake(block, sized(1e-5)), "20 million"));
}
