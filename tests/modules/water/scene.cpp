// The stage's `water` as scripts write it.

#include "modules/support/scenario.hpp"
#include "water/water.hpp"

namespace ashlar::water {
namespace {

std::string mistakes_with(const std::string& stage) {
  const auto scenario = test::read_scenario(test::slab_script("friction = \"none\"", stage));
  if (scenario->mistakes.empty()) Water().check(scenario->scene, scenario->mistakes);
  return scenario->text();
}

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(water_scene, one_water_a_list_or_false) {
  EXPECT_EQ(mistakes_with("water = Water { level = 5*u.m, on = { \"rock.top\" } }"), "");
  EXPECT_EQ(mistakes_with("water = { Water { level = 5, on = { \"rock.top\", \"fault.left\" } }, "
                          "Water { level = 2, on = { \"rock.right\" }, density = 1025*u.kg/u.m^3 } }"),
            "");
  EXPECT_EQ(mistakes_with("water = false"), "");
}

TEST(water_scene, mistakes_have_their_place) {
  EXPECT_TRUE(holds(mistakes_with("water = Water { on = { \"rock.top\" } }"), "level: is missing"));
  EXPECT_TRUE(
      holds(mistakes_with("water = Water { level = 5*u.kN, on = { \"rock.top\" } }"), "must be in m"));
  const std::string edge = mistakes_with("water = Water { level = 5, on = { \"rock.tpo\" } }");
  EXPECT_TRUE(holds(edge, "rock.tpo") && holds(edge, "rock.top")) << edge;
  EXPECT_TRUE(holds(mistakes_with("water = true"), "neither level nor face"));
  EXPECT_TRUE(holds(mistakes_with("water = Water { level = 5, on = { \"rock.top\" }, unit_weight = -1 }"),
                    "must be above 0"));
  EXPECT_TRUE(
      holds(mistakes_with("water = Water { level = 5, on = { \"rock.top\" }, unit_weight = 9.81*u.kN/u.m^3, "
                          "density = 1000 }"),
            "both said"));
}

}  // namespace
}  // namespace ashlar::water
