#include "model/support_check.hpp"

#include <gtest/gtest.h>

#include "model/free_motions.hpp"

namespace ashlar::model {
namespace {

// Two unit squares side by side, or apart from each other by `gap`.
mesh::Domain squares(double gap) {
  const auto square = [](const std::string& name, double x) {
    geometry::Shape shape;
    shape.rings = {{{{x, 0}, "bottom", {}, {}},
                    {{x + 1, 0}, "right", {}, {}},
                    {{x + 1, 1}, "top", {}, {}},
                    {{x, 1}, "left", {}, {}}}};
    return mesh::RegionShape{name, shape, {}};
  };
  core::Mistakes mistakes;
  mesh::Domain domain = mesh::make_domain({square("rock", 0), square("dam", 1 + gap)}, {}, 1, mistakes);
  EXPECT_TRUE(mistakes.empty());
  return domain;
}

SupportData held(const std::string& edge, const std::string& fix) {
  SupportData support;
  support.edge = edge;
  for (std::size_t c = 0; c < 2; ++c)
    if (fix.find("xy"[c]) != std::string::npos) support.move[c] = core::make_value(0.0);
  return support;
}

SupportData held_at(Point at, const std::string& fix) {
  SupportData support = held("", fix);
  support.at = at;
  return support;
}

std::string complaint(const mesh::Domain& domain, std::vector<SupportData> supports) {
  Scene scene;
  scene.stages.resize(1);
  scene.stages[0].name = "weight";
  scene.stages[0].supports = std::move(supports);
  core::Mistakes mistakes;
  check_support(scene, domain, mistakes);
  std::string text;
  for (const core::Mistake& mistake : mistakes.list()) text += mistake.what;
  return text;
}

TEST(support_check, names_the_body_and_its_free_motions) {
  const mesh::Domain joined = squares(0);
  EXPECT_EQ(complaint(joined, {held("rock.bottom", "xy")}), "");
  EXPECT_EQ(complaint(joined, {}),
            "nothing holds 'dam' with 'rock' in stage 'weight': it can slide in x, slide in y and rotate");
  EXPECT_EQ(complaint(joined, {held("rock.bottom", "y")}),
            "nothing holds 'dam' with 'rock' in stage 'weight': it can slide in x");
  EXPECT_EQ(complaint(joined, {held_at({2, 0}, "xy")}),
            "nothing holds 'dam' with 'rock' in stage 'weight': it can rotate about (2, 0)");
  EXPECT_EQ(complaint(joined, {held_at({2, 0}, "y")}),
            "nothing holds 'dam' with 'rock' in stage 'weight': it can slide in x and rotate");
  EXPECT_EQ(complaint(joined, {held_at({0, 0}, "xy"), held_at({1, 0}, "y")}), "");
  EXPECT_EQ(complaint(joined, {held("rock.left", "x"), held_at({1, 0}, "y")}), "");
  EXPECT_EQ(complaint(joined, {held("rock.bottom", "x"), held_at({1, 0}, "y")}),
            "nothing holds 'dam' with 'rock' in stage 'weight': it can rotate about (1, 0)");
}

TEST(support_check, each_body_needs_its_own) {
  EXPECT_EQ(complaint(squares(1), {held("rock.bottom", "xy")}),
            "nothing holds 'dam' in stage 'weight': it can slide in x, slide in y and rotate");
}

TEST(support_check, contact_may_hold_bodies_that_are_meshed_apart) {
  mesh::Domain domain = squares(1);
  mesh::JointLine line;
  line.name = "touch";
  line.faces = {"rock.right", "dam.left"};
  domain.joints.push_back(line);
  EXPECT_EQ(complaint(domain, {held("rock.bottom", "xy")}), "");
  EXPECT_EQ(complaint(domain, {held("rock.bottom", "y")}),
            "nothing holds 'dam' with 'rock' in stage 'weight': it can slide in x");
}

TEST(support_check, a_box_holds_what_lies_in_it) {
  const mesh::Domain joined = squares(0);
  SupportData box = held("", "xy");
  box.box = {Point{-0.1, -0.1}, Point{0.1, 0.1}};
  EXPECT_EQ(complaint(joined, {box}), "");
  box.box = {Point{3, 3}, Point{4, 4}};
  EXPECT_NE(complaint(joined, {box}), "");
}

TEST(support_check, probes_lie_in_the_body) {
  Scene scene;
  scene.probes = {{"crest", {1, 1}, "", {}, {}}, {"far", {3, 1}, "", {}, {"a.lua", 4, "x"}}};
  core::Mistakes mistakes;
  check_places(scene, squares(0), mistakes);
  ASSERT_EQ(mistakes.list().size(), 1u);
  EXPECT_EQ(to_string(mistakes.list()[0]),
            "a.lua:4: x: the point lies outside every region, 1 m from the nearest border");
}

TEST(support_check, the_advice_names_an_edge_of_the_body) {
  Scene scene;
  scene.stages.resize(1);
  core::Mistakes mistakes;
  check_support(scene, squares(1), mistakes);
  ASSERT_EQ(mistakes.list().size(), 2u);
  for (const core::Mistake& mistake : mistakes.list()) {
    const std::string name = mistake.what.find("'rock'") != std::string::npos ? "rock" : "dam";
    EXPECT_EQ(mistake.advice, "add to supports, for example [\"" + name + ".bottom\"] = \"xy\"");
  }
}

TEST(free_motions, oblique_slides_are_named_by_their_direction) {
  FreeMotions motions({0, 0}, 10);
  EXPECT_EQ(motions.words(), "slide in x, slide in y and rotate");
  motions.hold({0, 0}, 0);
  motions.hold({0, 0}, 1);
  EXPECT_EQ(motions.words(), "rotate about (0, 0)");
  motions.hold({0, 3}, 0);
  EXPECT_EQ(motions.words(), "");
}

}  // namespace
}  // namespace ashlar::model
