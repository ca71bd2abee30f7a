#include "loads/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "loads/edge_values.hpp"
#include "modules/support/hand_mesh.hpp"
#include "modules/support/said.hpp"

namespace ashlar::loads {
namespace {

using namespace ashlar::test;

/// A slab [0, 6] × [0, 3] of n × 1 cells with groups "top" and "right", and "seam" between two cells.
model::Model slab(int n, int order = 1, double thickness = 1) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> cells;
  for (int i = 0; i <= n; ++i) {
    points.push_back({6.0 * i / n, 0});
    points.push_back({6.0 * i / n, 3});
  }
  for (Index i = 0; i < n; ++i) cells.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  mesh::Mesh mesh = hand_mesh(points, cells);
  for (Index i = 0; i < n; ++i) mesh.edge_groups["top"].push_back(edge_between(mesh, 2 * i + 1, 2 * i + 3));
  mesh.edge_groups["right"] = {edge_between(mesh, 2 * n, 2 * n + 1)};
  if (n > 1) mesh.edge_groups["seam"] = {edge_between(mesh, 2, 3)};
  return plain_model(std::move(mesh), order, thickness);
}

Said nothing() {
  Said stage;
  for (const char* key : {"tractions", "pressures", "forces", "couples"}) stage.silent(key);
  return stage;
}

void set(Said& stage, const std::string& key, const Settings::Entry& entry) {
  for (Settings::Entry& known : stage.settings.entries)
    if (known.key == key) known = entry;
}

Settings pressure_on(const std::string& edge, core::Value p) {
  Said stage = nothing();
  set(stage, "pressures",
      {"pressures", core::make_value(core::Table{{}, {}, {{edge, std::move(p)}}}), true, {}, {}, {}});
  return stage.settings;
}

Settings objects(const std::string& key, const std::string& name, const Settings& object) {
  Said stage = nothing();
  set(stage, key, {key, list({}), true, {}, {}, {{name, object}}});
  return stage.settings;
}

TEST(loads, tractions_are_per_area_and_functions_of_degree_8_are_exact) {
  const auto y = [](double x, double) { return std::pow(x, 8); };
  const Settings components = Said().say("x", value(50.0)).say("y", function(y)).settings;
  for (const int order : {1, 2}) {
    const model::Model model = slab(5, order, 0.25);
    Loads loads;
    const auto sum =
        resultant(model, contribute(loads, model, objects("tractions", "top", components)).force);
    EXPECT_NEAR(sum.x, 50 * 6 * 0.25, 1e-12);
    EXPECT_NEAR(sum.y, std::pow(6, 9) / 9 * 0.25, 1e-13 * std::pow(6, 9));
    EXPECT_NEAR(sum.moment, 0.25 * (std::pow(6, 10) / 10 - 3 * 50 * 6), 1e-13 * std::pow(6, 10));
  }
}

TEST(loads, pressures_push_against_the_outward_normal) {
  const model::Model model = slab(3);
  Loads loads;
  const auto top = resultant(model, contribute(loads, model, pressure_on("top", value(7.0))).force);
  EXPECT_NEAR(top.x, 0, 1e-14);
  EXPECT_NEAR(top.y, -42, 1e-13);
  const auto f = [](double x, double y) { return x * y; };
  const auto right = resultant(model, contribute(loads, model, pressure_on("right", function(f))).force);
  EXPECT_NEAR(right.x, -27, 1e-13);         // −∫ 6y dy
  EXPECT_NEAR(right.moment, 6 * 9, 1e-12);  // −y·Fx = ∫ 6y² dy
}

// p is a straight line between (0, 10), (1.3, 40) and (3, 0): kinks inside the one edge of the side.
TEST(loads, tables_of_pressure_are_integrated_exactly) {
  const model::Model model = slab(1, 2);
  Loads loads;
  const core::Value table = list({pair(0, 10), pair(1.3, 40), pair(3, 0)});
  const auto sum = resultant(model, contribute(loads, model, pressure_on("right", table)).force);
  EXPECT_NEAR(sum.x, -(25 * 1.3 + 20 * 1.7), 1e-12);
  const double first = 10 * 1.3 * 1.3 / 2 + 30 / 1.3 * std::pow(1.3, 3) / 3;
  const double second = 40 * 1.7 / 2 * (1.3 + 1.7 / 3);
  EXPECT_NEAR(sum.moment, first + second, 1e-12);
}

TEST(loads, a_table_must_cover_the_edge) {
  const model::Model model = slab(1);
  Loads loads;
  const auto low = contribute(loads, model, pressure_on("right", list({pair(0, 10), pair(2.5, 0)})));
  ASSERT_EQ(low.mistakes.list().size(), 1u);
  EXPECT_NE(low.mistakes.list()[0].what.find(
                "covers heights from 0 m to 2.5 m, but edge 'right' goes from 0 m to 3 m"),
            std::string::npos)
      << low.mistakes.list()[0].what;
}

TEST(loads, a_function_must_return_a_finite_number) {
  const model::Model model = slab(1);
  Loads loads;
  const auto f = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
  const auto wrong = contribute(loads, model, pressure_on("top", function(f)));
  ASSERT_EQ(wrong.mistakes.list().size(), 1u);
  EXPECT_NE(wrong.mistakes.list()[0].what.find("not finite at (5."), std::string::npos);
  EXPECT_EQ(wrong.mistakes.list()[0].place.line, 9);
}

TEST(loads, edges_inside_the_body_carry_nothing) {
  const model::Model model = slab(2);
  Loads loads;
  EXPECT_EQ(contribute(loads, model, pressure_on("seam", value(1.0))).mistakes.list().size(), 1u);
}

TEST(loads, a_force_acts_whole_at_the_nearest_point) {
  const model::Model model = slab(3, 1, 0.1);
  Loads loads;
  Said force;
  force.say("at", pair(2.1, 2.9)).say("y", value(-500.0)).silent("x").silent("lip");
  const auto result = contribute(loads, model, objects("forces", "1", force.settings));
  EXPECT_EQ(result.force[model.dofs.of_point(3) + 1], -500);
  EXPECT_EQ(resultant(model, result.force).y, -500);
}

TEST(loads, a_couple_is_a_moment_and_no_force) {
  const model::Model model = slab(3);
  Loads loads;
  Said couple;
  couple.say("between", list({pair(2, 0), pair(4, 3)})).say("moment", value(80.0));
  const auto sum = resultant(model, contribute(loads, model, objects("couples", "1", couple.settings)).force);
  EXPECT_NEAR(sum.x, 0, 1e-14);
  EXPECT_NEAR(sum.y, 0, 1e-14);
  EXPECT_NEAR(sum.moment, 80, 1e-13);
  Said flat;
  flat.say("between", list({pair(2, 0), pair(2.01, 0)})).say("moment", value(80.0));
  EXPECT_EQ(contribute(loads, model, objects("couples", "1", flat.settings)).mistakes.list().size(), 1u);
}

TEST(loads, mistakes_in_the_scene) {
  const auto count = [](const Settings& stage) { return mistakes_of(Loads(), stage).size(); };
  EXPECT_EQ(count(nothing().settings), 0u);
  EXPECT_EQ(count(pressure_on("top", list({pair(0, 1), pair(3, 0)}))), 0u);
  EXPECT_EQ(count(pressure_on("top", list({pair(3, 1), pair(0, 0)}))), 1u);  // descends
  EXPECT_EQ(count(pressure_on("top", list({pair(3, 1)}))), 1u);              // one row
  EXPECT_EQ(count(pressure_on("top", list({value(3.0), pair(3, 1)}))), 1u);  // no row
  EXPECT_EQ(count(objects("couples", "1", Said().say("between", list({pair(0, 0)})).settings)), 1u);
  Said flag = nothing();
  set(flag, "forces", {"forces", value(true), true, {}, {}, {}});
  EXPECT_EQ(count(flag.settings), 1u);
}

}  // namespace
}  // namespace ashlar::loads
