// Scenes as plain data, as a script would give them.

#include "model/scene.hpp"

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "model/plan.hpp"
#include "model/scene_names.hpp"

namespace ashlar::model {
namespace {

using core::Form;
using core::make_value;
using core::Table;
using core::Value;
using Entries = std::vector<std::pair<std::string, Value>>;

int line = 0;  // every table and word stands on a line of its own, counted from 1 in each scene

core::Place here() {
  return {"scene.lua", ++line, ""};
}
Value word(const std::string& text) {
  return make_value(text, here());
}
Value number(double x) {
  return make_value(x, here());
}
Value made(const std::string& constructor, std::vector<Value> items, Entries entries = {}) {
  return make_value(Table{constructor, std::move(items), std::move(entries)}, here());
}
Value corner(double x, double y, const std::string& edge) {
  return made("", {number(x), number(y), word(edge)});
}

core::Registry registry() {
  core::Registry made_registry;
  register_scene_kinds(made_registry);
  made_registry.add_schema({"material", "stone", "material.stone", "", {}});
  made_registry.add_schema({"mesh", "squares", "mesh.squares", "", {}});
  made_registry.add_schema({"element", "plain", "", "", {}});
  made_registry.add_schema({"solver", "direct", "", "", {}});
  core::Parameter weight, push;
  weight.key = "weight";
  weight.forms = Form::boolean | Form::number;
  push.key = "push";
  push.forms = static_cast<unsigned>(Form::map);
  push.refers = "edge";
  made_registry.extend("stage", "", {weight, push}, "loads");
  made_registry.add_effect({"solid", "solid", {"scene.geometry"}, false, "", ""});
  made_registry.add_effect({"weight", "loads", {"stage.weight"}, false, "", "no weight"});
  made_registry.add_effect({"push", "loads", {"stage.push"}, false, "", ""});
  made_registry.add_effect({"joints", "contact", {"scene.joints"}, true, "", "all is bonded"});
  return made_registry;
}

Value square(const std::string& edge = "bottom") {
  return made("Polygon",
              {corner(0, 0, edge), corner(1, 0, "right"), corner(1, 1, "top"), corner(0, 1, "left")},
              {{"material", word("stone")}});
}

// A sound scene with the given entries on top.
Value scene_with(Entries entries) {
  Entries all = {{"title", word("a square")},
                 {"plane", word("strain")},
                 {"geometry", made("", {}, {{"block", square()}})},
                 {"mesh", word("squares")},
                 {"supports", made("", {}, {{"block.bottom", word("xy")}})},
                 {"stages", made("", {made("Stage", {word("first")})})}};
  for (auto& said : entries) {
    std::erase_if(all, [&](const auto& entry) { return entry.first == said.first; });
    all.push_back(said);
  }
  return made("Scene", {}, std::move(all));
}

std::string mistakes_of(const Value& value) {
  core::Registry kinds = registry();
  core::Mistakes mistakes;
  read_scene(value, kinds, mistakes);
  std::string text;
  for (const core::Mistake& mistake : mistakes.list())
    text += (text.empty() ? "" : "\n") + mistake.what + (mistake.advice.empty() ? "" : "; " + mistake.advice);
  return text;
}

Scene sound(const Value& value, core::Registry& kinds) {
  core::Mistakes mistakes;
  Scene scene = read_scene(value, kinds, mistakes);
  EXPECT_TRUE(mistakes.empty()) << to_string(mistakes.list().front());
  return scene;
}

TEST(scene, a_sound_one_is_read_in_full) {
  core::Registry kinds = registry();
  const Scene scene = sound(scene_with({}), kinds);
  ASSERT_EQ(scene.regions.size(), 1u);
  EXPECT_EQ(scene.regions[0].shape.rings[0].size(), 4u);
  EXPECT_EQ(scene.regions[0].material.name, "stone");
  EXPECT_EQ(scene.element.name, "plain") << "the only one need not be said";
  EXPECT_EQ(scene.solver.name, "direct");
  ASSERT_EQ(scene.stages.size(), 1u);
  EXPECT_EQ(scene.stages[0].parent, -1);
  ASSERT_EQ(scene.stages[0].supports.size(), 1u);
  EXPECT_EQ(scene.stages[0].supports[0].edge, "block.bottom");
  EXPECT_TRUE(scene.stages[0].supports[0].move[0] && scene.stages[0].supports[0].move[1]);
}

TEST(scene, stages_inherit_what_they_do_not_say) {
  core::Registry kinds = registry();
  const Value push = made("", {}, {{"block.top", number(3)}});
  const Value scene_value =
      scene_with({{"stages", made("", {made("Stage", {word("a")}, {{"weight", number(10)}}),
                                       made("Stage", {word("b")}, {{"push", push}}),
                                       made("Stage", {word("c")},
                                            {{"push", make_value(false, here())},
                                             {"supports", made("", {}, {{"block.left", word("x")}})}}),
                                       made("Stage", {word("d")}, {{"parent", word("a")}})})}});
  const Scene scene = sound(scene_value, kinds);
  ASSERT_EQ(scene.stages.size(), 4u);
  EXPECT_EQ(scene.stages[1].parent, 0);
  EXPECT_EQ(scene.stages[1].settings.number("weight"), 10);
  EXPECT_FALSE(scene.stages[2].settings.has("push")) << "push = false ends it";
  EXPECT_EQ(scene.stages[2].settings.number("weight"), 10);
  EXPECT_EQ(scene.stages[2].supports.size(), 1u);
  EXPECT_EQ(scene.stages[2].supports[0].edge, "block.left");
  EXPECT_EQ(scene.stages[3].parent, 0);
  EXPECT_FALSE(scene.stages[3].settings.has("push"));
  EXPECT_EQ(scene.stages[3].supports[0].edge, "block.bottom");
}

TEST(plan, calls_what_a_stage_says_and_names_its_line) {
  core::Registry kinds = registry();
  const Value push = made("", {}, {{"block.top", number(3)}});
  const int push_line = push.place.line;
  const Scene scene = sound(scene_with({{"stages", made("", {made("Stage", {word("a")}),
                                                             made("Stage", {word("b")}, {{"push", push}}),
                                                             made("Stage", {word("c")})})}}),
                            kinds);
  const Plan plan = make_plan(scene, kinds);
  ASSERT_EQ(plan.stages.size(), 3u);
  ASSERT_EQ(plan.stages[0].calls.size(), 1u);
  EXPECT_EQ(plan.stages[0].calls[0].effect, "solid");
  ASSERT_EQ(plan.stages[2].calls.size(), 2u) << "inherited";
  EXPECT_EQ(plan.stages[2].calls[1].effect, "push");
  EXPECT_EQ(plan.stages[2].calls[1].place.line, push_line);
  ASSERT_EQ(plan.left_out.size(), 2u);
  EXPECT_EQ(plan.left_out[0].name, "weight");
  EXPECT_EQ(plan.left_out[1].name, "joints");
}

TEST(scene, words_that_name_nothing_are_reported_with_the_right_ones) {
  EXPECT_EQ(mistakes_of(scene_with({{"supports", made("", {}, {{"block.botom", word("xy")}})}})),
            "there is no edge 'block.botom'; did you mean 'block.bottom'? valid: block.bottom, block.right, "
            "block.top, block.left");
  EXPECT_EQ(mistakes_of(scene_with({{"supports", made("", {}, {{"top", word("xy")}})}})),
            "there is no edge 'top'; did you mean 'block.top'? valid: block.bottom, block.right, block.top, "
            "block.left");
  const Value stages =
      made("", {made("Stage", {word("a")}), made("Stage", {word("b")}, {{"parent", word("aa")}})});
  EXPECT_EQ(mistakes_of(scene_with({{"stages", stages}})), "there is no stage 'aa'; valid: a, b");
  const Value joint = made("Joint", {}, {{"between", made("", {word("block"), word("blok")})}});
  EXPECT_EQ(mistakes_of(scene_with({{"joints", made("", {}, {{"crack", joint}})}})),
            "there is no region 'blok'; did you mean 'block'? valid: block");
}

TEST(scene, faces_of_two_bodies_are_a_third_kind_of_joint) {
  core::Registry kinds = registry();
  const Value two = made("", {}, {{"block", square()}, {"lid", square("seat")}});
  const auto with_faces = [&](const std::string& first, const std::string& second, Entries more = {}) {
    more.emplace_back("faces", made("", {word(first), word(second)}));
    return scene_with({{"geometry", two}, {"joints", made("", {}, {{"touch", made("Joint", {}, more)}})}});
  };
  const mesh::JointLine line = sound(with_faces("block.top", "lid.seat"), kinds).joints[0].line;
  EXPECT_EQ(line.faces, (std::vector<std::string>{"block.top", "lid.seat"}));
  EXPECT_EQ(line.sides, (std::array<std::string, 2>{"block", "lid"})) << "the regions name the lips";
  EXPECT_TRUE(line.path.empty() && line.between.empty());
  const Value sides = made("", {word("a"), word("b")});
  EXPECT_EQ(mistakes_of(with_faces("block.top", "touch.b", {{"sides", sides}})),
            "'touch.b' is no edge of a region; give two edges as region.edge");
  EXPECT_EQ(mistakes_of(with_faces("block.top", "block.top")), "must be two different names");
  EXPECT_EQ(mistakes_of(with_faces("lid.top", "lid.seat")),
            "both edges belong to region 'lid'; give edges of two regions, or use `path` inside one");
}

TEST(scene, shapes_that_cannot_be_are_reported) {
  const auto with_corners = [](std::vector<Value> corners) {
    const Value polygon = made("Polygon", std::move(corners), {{"material", word("stone")}});
    return mistakes_of(
        scene_with({{"geometry", made("", {}, {{"block", polygon}})}, {"supports", made("", {})}}));
  };
  EXPECT_EQ(with_corners({corner(0, 0, "a"), corner(1, 0, "b")}), "needs at least 3 corners, got 2");
  EXPECT_EQ(with_corners({corner(0, 0, "a"), corner(1, 0, "b"), corner(1, 0, "c"), corner(0, 1, "d")}),
            "two neighbouring corners coincide at (1, 0)");
  EXPECT_EQ(with_corners({corner(0, 0, "a"), corner(1, 1, "b"), corner(1, 0, "c"), corner(0, 1, "d")}),
            "the border crosses or touches itself: the edge from (1, 0) meets the edge from (0, 0)");
}

TEST(scene, every_mistake_is_reported_at_once) {
  const Value geometry = made(
      "", {},
      {{"block", made("Disk", {}, {{"center", made("", {number(0), number(0)})}, {"radius", number(-1)}})}});
  const std::string text = mistakes_of(scene_with({{"geometry", geometry}, {"plane", word("strian")}}));
  EXPECT_NE(text.find("'strian' is none of the choices"), std::string::npos) << text;
  EXPECT_NE(text.find("must be above 0 m"), std::string::npos) << text;
  EXPECT_NE(text.find("what the region is made of"), std::string::npos) << text;
  EXPECT_EQ(text.find("there is no edge"), std::string::npos) << "follows from the broken region: " << text;
}

TEST(scene, loads_on_held_edges_are_warned_of) {
  core::Registry kinds = registry();
  const Scene scene = sound(
      scene_with(
          {{"stages",
            made("", {made("Stage", {word("first")},
                           {{"push", made("", {}, {{"block.bottom", number(1)}, {"block.top", number(1)}})}}),
                      made("Stage", {word("second")})})}}),
      kinds);
  core::log().clear();
  warn_of_held_loads(scene, kinds);
  ASSERT_EQ(core::log().lines().size(), 1u) << "once, although the second stage inherits it";
  EXPECT_NE(core::log().lines()[0].second.find("'block.bottom' is held in x and y in stage 'first'"),
            std::string::npos);
  Scene half = scene;
  for (StageData& stage : half.stages) stage.supports[0].move[0].reset();
  core::log().clear();
  warn_of_held_loads(half, kinds);
  EXPECT_TRUE(core::log().lines().empty());
}

TEST(scene, files_are_looked_for_from_the_scripts_folder) {
  const auto said = [](const std::string& file, const std::string& script) {
    core::Mistakes mistakes;
    check_name(file, "file", {script, 3, "mesh.path"}, {}, mistakes);
    return mistakes.empty() ? "" : mistakes.list()[0].what;
  };
  const std::string here = ASHLAR_SOURCE_DIR "/tests/framework/model";
  EXPECT_EQ(said("scene.cpp", here + "/scene.lua"), "");
  EXPECT_EQ(said(here + "/scene.cpp", "elsewhere/scene.lua"), "");
  EXPECT_EQ(said("nothing.msh", here + "/scene.lua"), "there is no file '" + here + "/nothing.msh'");
  EXPECT_EQ(said("../model", here + "/scene.lua"), "'" + here + "/../model' is no regular file");
}

TEST(scene, undefined_values_do_not_bring_mistakes_of_their_own) {
  // What an undefined name leaves behind was reported by the script's reader.
  const Value nothing{here(), {}};
  const Value holed = made("Rectangle", {},
                           {{"from", made("", {number(0), number(0)})},
                            {"to", made("", {nothing, number(1)})},
                            {"material", word("stone")}});
  EXPECT_EQ(mistakes_of(scene_with({{"geometry", made("", {}, {{"block", holed}})}})), "");
  const Value cut =
      made("Polygon", {corner(0, 0, "bottom"), made("", {nothing, number(0)}), corner(1, 1, "top")},
           {{"material", word("stone")}});
  core::Registry kinds = registry();
  core::Mistakes mistakes;
  const Scene scene = read_scene(scene_with({{"geometry", made("", {}, {{"block", cut}})}}), kinds, mistakes);
  EXPECT_TRUE(mistakes.empty());
  EXPECT_FALSE(scene.drawn) << "what is not whole must not be arranged";
}

}  // namespace
}  // namespace ashlar::model
