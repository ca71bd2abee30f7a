// The stage's loads as scripts write them.

#include "loads/loads.hpp"
#include "modules/support/hand_mesh.hpp"
#include "modules/support/said.hpp"
#include "modules/support/scenario.hpp"

namespace ashlar::loads {
namespace {

std::unique_ptr<test::Scenario> read(const std::string& stage) {
  auto scenario = test::read_scenario(test::slab_script("friction = \"none\"", stage));
  if (scenario->mistakes.empty()) Loads().check(scenario->scene, scenario->mistakes);
  return scenario;
}

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

// All four kinds in one stage, from the script to the force vector on a slab of one cell.
TEST(loads_scene, from_script_to_forces) {
  const auto scenario = read(R"(
    tractions = { ["rock.top"] = { x = 10, y = function(x, y) return -x*x end } },
    pressures = { ["rock.right"] = { {0, 2*u.kPa}, {3, 0} }, ["rock.left"] = function(x, y) return y end },
    forces = { Force { at = {0, 3}, x = 7*u.kN } },
    couples = { Couple { between = { {0, 0}, {6, 0} }, moment = 12*u.kN*u.m } })");
  ASSERT_EQ(scenario->text(), "");
  mesh::Mesh mesh = test::hand_mesh({{0, 0}, {6, 0}, {6, 3}, {0, 3}}, {{0, 1, 2, 3}});
  mesh.edge_groups = {{"rock.right", {1}}, {"rock.top", {2}}, {"rock.left", {3}}};
  const model::Model model = test::plain_model(std::move(mesh));
  Loads loads;
  const auto found = test::contribute(loads, model, scenario->scene.stages.at(0).settings);
  EXPECT_TRUE(found.mistakes.empty());
  const auto sum = test::resultant(model, found.force);
  EXPECT_NEAR(sum.x, 10 * 6 - 3000 + 4.5 + 7000, 1e-9);
  EXPECT_NEAR(sum.y, -72, 1e-11);
  EXPECT_NEAR(sum.moment, -3 * 60 - 324 + 3000 - 9 - 3 * 7000 + 12000, 1e-8);
}

TEST(loads_scene, mistakes_have_their_place) {
  const auto text = [](const std::string& stage) { return read(stage)->text(); };
  EXPECT_TRUE(holds(text("pressures = { [\"rock.tpo\"] = 1 }"), "rock.top"));
  EXPECT_TRUE(holds(text("pressures = { [\"rock.top\"] = 1*u.m }"), "must be in Pa"));
  EXPECT_TRUE(holds(text("pressures = { [\"rock.top\"] = { {0, 1}, {0, 2} } }"), "heights must ascend"));
  EXPECT_TRUE(holds(text("tractions = { [\"rock.top\"] = { z = 1 } }"), "unknown key 'z'"));
  EXPECT_TRUE(holds(text("tractions = { [\"rock.top\"] = {} }"), "needs at least one of x and y"));
  EXPECT_TRUE(holds(text("forces = { Force { at = {1, 1} } }"), "needs at least one of x and y"));
  EXPECT_EQ(text("forces = { Force { at = {1, 1}, x = 1, y = 1 } }"), "");
  EXPECT_TRUE(holds(text("forces = { Force { x = 1 } }"), "at: is missing"));
  EXPECT_TRUE(holds(text("forces = { Force { at = {1, 1}, x = 1, lip = \"fault.uper\" } }"), "fault.left"));
  EXPECT_TRUE(holds(text("couples = { Couple { between = { {1, 1} }, moment = 1 } }"), "two places"));
  EXPECT_TRUE(holds(text("forces = true"), "says no load"));
}

}  // namespace
}  // namespace ashlar::loads
