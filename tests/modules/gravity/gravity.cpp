#include "gravity/gravity.hpp"

#include <gtest/gtest.h>

#include "modules/support/hand_mesh.hpp"
#include "modules/support/said.hpp"

namespace ashlar::gravity {
namespace {

using namespace ashlar::test;

Settings stage(core::Value gravity) {
  return Said().say("gravity", std::move(gravity)).settings;
}

/// A square of 2 × 2 m and a triangle of 2 m² on its right, in two regions.
model::Model two_regions() {
  mesh::Mesh mesh = hand_mesh({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  mesh.regions = {"dam", "rock"};
  mesh.cell_region = {0, 1};
  model::Model model = plain_model(std::move(mesh), 1, 0.5);
  auto dense = std::make_shared<PlainMaterial>();
  dense->density = 2000;
  auto light = std::make_shared<PlainMaterial>();
  light->weight = 1000;
  model.materials = {dense, light};
  return model;
}

TEST(gravity, weighs_each_region_with_its_own_unit_weight_and_the_thickness) {
  const model::Model model = two_regions();
  core::Registry registry;
  Gravity gravity(registry);
  const auto sum = resultant(model, contribute(gravity, model, stage(value(true))).force);
  EXPECT_EQ(sum.x, 0);
  EXPECT_DOUBLE_EQ(sum.y, -0.5 * (4 * 2000 * 9.80665 + 2 * 1000));
  // Both cells of the test's element weigh in the mean of their corners: x = 1 and x = 8/3.
  EXPECT_NEAR(sum.moment, -0.5 * (4 * 2000 * 9.80665 * 1 + 2 * 1000 * 8 / 3.0), 1e-9);
  const auto moon = resultant(model, contribute(gravity, model, stage(value(1.62))).force);
  EXPECT_DOUBLE_EQ(moon.y, -0.5 * (4 * 2000 * 1.62 + 2 * 1000));
}

TEST(gravity, false_or_zero_is_none_and_the_same_load_serves_all_stages) {
  const model::Model model = two_regions();
  core::Registry registry;
  Gravity gravity(registry);
  EXPECT_TRUE(contribute(gravity, model, stage(value(false))).terms.loads.empty());
  EXPECT_TRUE(contribute(gravity, model, stage(value(0.0))).terms.loads.empty());
  const auto first = contribute(gravity, model, stage(value(true)));
  EXPECT_EQ(first.terms.loads, contribute(gravity, model, stage(value(true))).terms.loads);
  EXPECT_NE(first.terms.loads, contribute(gravity, model, stage(value(5.0))).terms.loads);
}

/// A registry whose materials read "weight" and "density" alone.
core::Registry registry_of_materials() {
  core::Registry registry;
  registry.add_schema({"material", "plain", "", "", {}});
  registry.add_make(
      "material", "plain",
      std::function<model::MakeMaterial>([](const Settings& said, model::Plane, core::Mistakes&) {
        auto material = std::make_shared<PlainMaterial>();
        material->weight = said.number("weight", -1);
        material->density = said.number("density", -1);
        return material;
      }));
  return registry;
}

model::RegionData region(const std::string& name, Said material) {
  model::RegionData data;
  data.name = name;
  data.material = std::move(material.settings);
  data.material.name = "plain";
  data.material.place = {"scene.lua", 4, "geometry." + name + ".material"};
  return data;
}

TEST(gravity, a_region_without_weight_is_a_mistake_once) {
  core::Registry registry = registry_of_materials();
  model::Scene scene;
  scene.regions = {region("dam", Said().silent("weight").silent("density")),
                   region("rock", Said().say("weight", value(0.0)).silent("density"))};
  scene.stages.resize(3);
  scene.stages[0].settings = stage(value(false));
  scene.stages[1].settings = scene.stages[2].settings = stage(value(true));
  core::Mistakes mistakes;
  Gravity(registry).check(scene, mistakes);
  ASSERT_EQ(mistakes.list().size(), 1u);
  EXPECT_EQ(core::to_string(mistakes.list()[0].place), "scene.lua:4: geometry.dam.material");
  EXPECT_NE(mistakes.list()[0].what.find("region 'dam' has no weight"), std::string::npos);
}

TEST(gravity, an_acceleration_that_a_unit_weight_ignores_is_warned_of) {
  core::Registry registry = registry_of_materials();
  model::Scene scene;
  scene.regions = {region("dam", Said().say("weight", value(24e3)).silent("density"))};
  scene.stages.resize(1);
  core::Mistakes mistakes;
  core::log().clear();
  scene.stages[0].settings = stage(value(true));
  Gravity(registry).check(scene, mistakes);
  EXPECT_TRUE(core::log().lines().empty());
  scene.stages[0].settings = stage(value(19.6));
  Gravity(registry).check(scene, mistakes);
  EXPECT_TRUE(logged("region 'dam' is given by its unit weight", core::Level::warning));
  EXPECT_TRUE(mistakes.empty());
}

}  // namespace
}  // namespace ashlar::gravity
