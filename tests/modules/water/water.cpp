#include "water/water.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "modules/support/hand_mesh.hpp"
#include "modules/support/said.hpp"

namespace ashlar::water {
namespace {

using namespace ashlar::test;

constexpr double gamma_w = 9810;
const Point foot{10, 10}, crest{14, 25};

/// One polygon whose left side, from crest down to foot, is cut into n unequal edges: group "face".
model::Model slanted_face(int n, int order, double thickness) {
  std::vector<Point> points{{40, 10}, crest};
  for (int i = 1; i < n; ++i) {
    const double t = i == n / 2 ? 0.5 : (i + 0.3 * std::sin(i)) / n;
    points.push_back((1 - t) * crest + t * foot);
  }
  points.push_back(foot);
  std::vector<Index> cell(points.size());
  for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = static_cast<Index>(i);
  mesh::Mesh mesh = hand_mesh(points, {cell});
  for (int i = 1; i <= n; ++i) mesh.edge_groups["face"].push_back(edge_between(mesh, i, i + 1));
  return plain_model(std::move(mesh), order, thickness);
}

/// With η the height above the foot, wet up to e: F = γ (De − e²/2) / sin α, moment by the same integrals.
model::Resultant closed_form(double level, double thickness) {
  const double depth = std::max(0.0, level - foot.y), e = std::min(depth, crest.y - foot.y);
  const Point d{(crest.x - foot.x) / (crest.y - foot.y), 1};  // along the face for each metre of height
  const double length = geometry::norm(d);
  const Point inward = {d.y / length, -d.x / length};  // the body is on the right
  const double i0 = gamma_w * thickness * length * (depth * e - e * e / 2);
  const double i1 = gamma_w * thickness * length * (depth * e * e / 2 - e * e * e / 3);
  return {i0 * inward.x, i0 * inward.y, i0 * geometry::cross(foot, inward) + i1 * geometry::cross(d, inward)};
}

Settings water_at(double level, const char* edge = "face") {
  Said water;
  water.say("level", value(level))
      .say("on", list({value(edge)}))
      .silent("joints")
      .silent("unit_weight")
      .silent("density");
  return Said().object("water", water.settings).settings;
}

// Heights are rounded to ε·y, depths with them: the thrust of a depth h is known to some ε·y/h.
TEST(water, thrust_and_moment_are_exact_for_any_level_and_number_of_edges) {
  double worst = 0;
  for (const int order : {1, 2}) {
    for (const int n : {1, 2, 3, 7, 10, 100, 1000}) {
      const model::Model model = slanted_face(n, order, 0.7);
      std::vector<double> levels{10.001, 11, 13.37, 17.5, 24.999, 25, 25.5, 60};
      for (const Index point : {2, n / 2 + 1}) levels.push_back(model.mesh.points[point].y + 1e-9);
      for (int i = 1; i <= n; i += std::max(1, n / 5)) {
        levels.push_back(model.mesh.points[i].y);
        levels.push_back(0.5 * (model.mesh.points[i].y + model.mesh.points[i + 1].y));
      }
      for (const double level : levels) {
        if (level <= foot.y) continue;
        Water water;
        const model::Resultant found = resultant(model, contribute(water, model, water_at(level)).force);
        const model::Resultant exact = closed_form(level, 0.7);
        const double scale = std::hypot(exact.x, exact.y);
        for (const double error : {(found.x - exact.x) / scale, (found.y - exact.y) / scale,
                                   (found.moment - exact.moment) / (scale * geometry::norm(crest))}) {
          EXPECT_LT(std::abs(error), 3e-16 * (20 + crest.y / (level - foot.y)))
              << "n " << n << " level " << level << " order " << order;
          worst = std::max(worst, std::abs(error));
        }
      }
    }
  }
  std::printf("largest relative error of force or moment: %.1e\n", worst);
}

TEST(water, a_level_at_the_foot_or_below_leaves_the_face_dry_with_a_warning) {
  const model::Model model = slanted_face(10, 1, 1);
  core::log().clear();
  Water water;
  for (const double f : contribute(water, model, water_at(3)).force) EXPECT_EQ(f, 0);
  EXPECT_TRUE(
      logged("3 m is below the whole of edge 'face', whose lowest point is at 10 m", core::Level::warning));
  const std::size_t lines = core::log().lines().size();
  contribute(water, model, water_at(3));
  EXPECT_EQ(core::log().lines().size(), lines) << "one warning a stage";
  contribute(water, model, water_at(3), "filling");
  EXPECT_EQ(core::log().lines().size(), lines + 1);
  EXPECT_TRUE(logged("stage 'filling': the water level 3 m is below", core::Level::warning));
}

TEST(water, several_waters_add_up_and_density_gives_the_unit_weight) {
  const model::Model model = slanted_face(4, 1, 1);
  Said heavy;
  heavy.say("level", value(20.0)).say("on", list({value("face"), value("face")})).silent("joints");
  heavy.say("density", value(1000.0)).silent("unit_weight");
  Settings light = *water_at(20).entry("water").object;
  Water water;
  const Settings both = Said().objects("water", {{"1", heavy.settings}, {"2", light}}).settings;
  const auto sum = resultant(model, contribute(water, model, both).force);
  EXPECT_NEAR(sum.x, closed_form(20, 1).x * (1 + 9806.65 / gamma_w), 1e-9 * sum.x);
}

TEST(water, faces_must_exist_and_lie_outside) {
  // Two squares side by side: their common edge is inner; "top" has one border and one inner edge.
  mesh::Mesh mesh = hand_mesh({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {{0, 1, 4, 5}, {1, 2, 3, 4}});
  mesh.edge_groups["inside"] = {edge_between(mesh, 1, 4)};
  mesh.edge_groups["top"] = {edge_between(mesh, 1, 4), edge_between(mesh, 4, 5)};
  const model::Model model = plain_model(std::move(mesh));
  Water water;
  const auto unknown = contribute(water, model, water_at(5, "tpo"));
  ASSERT_EQ(unknown.mistakes.list().size(), 1u);
  EXPECT_EQ(unknown.mistakes.list()[0].what, "there is no edge 'tpo'");
  EXPECT_NE(unknown.mistakes.list()[0].advice.find("did you mean 'top'"), std::string::npos);
  const auto inside = contribute(water, model, water_at(5, "inside"));
  ASSERT_EQ(inside.mistakes.list().size(), 1u);
  EXPECT_NE(inside.mistakes.list()[0].what.find("lies inside the body"), std::string::npos);
  core::log().clear();
  const auto top = contribute(water, model, water_at(5, "top"));
  EXPECT_TRUE(top.mistakes.empty());
  EXPECT_NEAR(resultant(model, top.force).y, -4 * gamma_w, 1e-9);
  EXPECT_TRUE(logged("1 m of edge 'top' lie between two regions", core::Level::info));
}

TEST(water, mistakes_in_the_scene) {
  EXPECT_EQ(mistakes_of(Water(), Said().say("water", value(true)).settings).size(), 1u);
  EXPECT_EQ(mistakes_of(Water(), Said().say("water", value(false)).settings).size(), 0u);
}

}  // namespace
}  // namespace ashlar::water
