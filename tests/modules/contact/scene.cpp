// The joint's keys as scripts write them, and the mistakes that contact finds in them.

#include "contact/contact.hpp"
#include "modules/support/scenario.hpp"

extern "C" void register_module(ashlar::core::Registry& registry);

namespace ashlar::contact {
namespace {

using test::read_scenario;
using test::slab_script;

/// Reads the joint, lets contact check it, and returns all mistakes.
std::string mistakes_with(const std::string& joint, model::Scene* scene = nullptr) {
  const auto scenario = read_scenario(slab_script(joint, "gravity = true"));
  if (scenario->mistakes.empty()) register_module(scenario->registry);
  if (scenario->mistakes.empty()) Contact(scenario->registry).check(scenario->scene, scenario->mistakes);
  const std::string text = scenario->text();
  if (scene) *scene = std::move(scenario->scene);
  return text;
}

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(contact_scene, defaults_are_the_papers_method_with_factor_100) {
  model::Scene scene;
  EXPECT_EQ(mistakes_with("friction = \"none\"", &scene), "");
  const core::Settings& joint = scene.joints.at(0).settings;
  EXPECT_EQ(joint.object("pairing").name, "node_to_segment");
  EXPECT_EQ(joint.object("pairing").text("weight"), "tributary");
  EXPECT_EQ(joint.object("normal_law").name, "unilateral");
  EXPECT_EQ(joint.object("enforce").name, "penalty");
  EXPECT_EQ(joint.object("enforce").number("factor"), 100);
  EXPECT_FALSE(joint.object("enforce").has("stiffness"));
  EXPECT_EQ(
      mistakes_with(
          "friction = \"none\", enforce = contact.penalty { stiffness = 5*u.GPa/u.m }, slave = \"right\", "
          "pairing = contact.node_to_segment { weight = \"equal\" }",
          &scene),
      "");
  EXPECT_EQ(scene.joints.at(0).settings.object("enforce").number("stiffness"), 5e9);
}

TEST(contact_scene, friction_must_be_said) {
  const std::string text = mistakes_with("");
  EXPECT_TRUE(holds(text, "joints.fault.friction: joint 'fault' does not say its friction")) << text;
  EXPECT_TRUE(holds(text, "none")) << text;
  EXPECT_TRUE(holds(mistakes_with("contact = false"), "unknown key 'contact'"));
  EXPECT_TRUE(holds(mistakes_with("friction = \"viscous\""), "there is no friction 'viscous'"));
}

TEST(contact_scene, penalties_are_positive_and_said_once) {
  const std::string start = "friction = \"none\", enforce = contact.penalty ";
  EXPECT_TRUE(
      holds(mistakes_with(start + "{ factor = 10, stiffness = 1e9 }"), "factor and stiffness are both said"));
  EXPECT_TRUE(holds(mistakes_with(start + "{ factor = 0 }"), "must be above 0"));
  EXPECT_TRUE(holds(mistakes_with(start + "{ factor = -3 }"), "must be above 0"));
  EXPECT_TRUE(holds(mistakes_with(start + "{ stiffness = 3*u.GPa }"), "must be in"));
  core::log().clear();
  EXPECT_EQ(mistakes_with(start + "{ factor = 1e9 }"), "");
  bool warned = false;
  for (const auto& [level, line] : core::log().lines()) warned = warned || holds(line, "is unusual");
  EXPECT_TRUE(warned);
}

TEST(contact_scene, the_slave_is_one_of_the_sides) {
  const std::string text =
      mistakes_with("friction = \"none\", sides = { \"upper\", \"lower\" }, slave = \"uper\"");
  EXPECT_TRUE(holds(text, "joint 'fault' has no lip 'uper'")) << text;
  EXPECT_TRUE(holds(text, "valid: fault.upper, fault.lower")) << text;
  for (const char* name : {"lower", "fault.lower"})
    EXPECT_EQ(mistakes_with("friction = \"none\", sides = { \"upper\", \"lower\" }, slave = \"" +
                            std::string(name) + "\""),
              "");
}

TEST(contact_scene, outputs_may_name_the_joints_fields) {
  const auto outputs = "joints = { fault = { \"opening\", \"slip\", \"pressure\" } }";
  EXPECT_EQ(read_scenario(slab_script("friction = \"none\"", "gravity = true", outputs))->text(), "");
}

TEST(contact_scene, every_part_that_the_manifest_names_has_a_maker) {
  const auto scenario = read_scenario(slab_script("friction = \"none\"", "gravity = true"));
  ASSERT_EQ(scenario->text(), "");
  register_module(scenario->registry);
  const core::Settings& joint = scenario->scene.joints.at(0).settings;
  EXPECT_NE(scenario->registry.make<MakePairing>("pairing", "node_to_segment")(joint.object("pairing")),
            nullptr);
  EXPECT_NE(scenario->registry.make<MakeNormalLaw>("normal_law", "unilateral")(joint.object("normal_law"),
                                                                               scenario->mistakes),
            nullptr);
  EXPECT_NE(
      scenario->registry.make<MakeFriction>("friction", "none")(joint.object("friction"), scenario->mistakes),
      nullptr);
  const auto penalty =
      scenario->registry.make<MakeEnforcement>("enforcement", "penalty")(joint.object("enforce"));
  ContactPoint point;
  point.modulus = 2e9;
  point.h = 0.5;
  EXPECT_DOUBLE_EQ(1 / penalty->hold(point, {0, 0}, 1).normal, 100 * 2e9 / 0.5);
  EXPECT_NE(scenario->registry.make<model::MakeEffect>("effect", "contact")(scenario->registry), nullptr);
}

}  // namespace
}  // namespace ashlar::contact
