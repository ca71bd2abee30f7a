// Sections against statics and closed forms, through the whole program.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polygon.hpp"
#include "support/scene_run.hpp"

namespace ashlar::test {
namespace {

using geometry::Point;
using model::SectionForces;
using model::SectionResult;

std::filesystem::path scene(const std::string& name) {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "crosscheck" / "scenes" / (name + ".lua");
}

const SectionResult& section(const model::StageResult& stage, const std::string& name) {
  const auto found = std::ranges::find(stage.sections, name, &SectionResult::name);
  if (found == stage.sections.end()) throw std::runtime_error("no section '" + name + "'");
  return *found;
}

// The beam of scenes/sections.lua: 10 × 2, thickness 0.5.
constexpr double thickness = 0.5, weight = 30e3, pressure = 80e3, pull = 200e3, push = -60e3;

/// The resultant over a line from `bottom` to `top` (whose right is the beam's free part) in balance with all
/// that loads this part.
SectionForces in_balance(const std::vector<Point>& line) {
  std::vector<Point> free_part = line;
  std::ranges::reverse(free_part);
  free_part.insert(free_part.end(), {{10, 0}, {10, 2}});
  std::rotate(free_part.begin(), free_part.begin() + 1, free_part.end());
  const double area = std::abs(geometry::signed_area(free_part));
  const Point middle = 0.5 * (line.front() + line.back());
  const double loaded = 10 - line.back().x;
  struct Force {
    Point at, force;
  };
  const Force forces[] = {{geometry::centroid(free_part), {0, -weight * area * thickness}},
                          {{10 - loaded / 2, 2}, {0, -pressure * loaded * thickness}},
                          {{10, 1}, {pull * 2 * thickness, push * 2 * thickness}}};
  Point sum;
  double moment = 0;
  for (const auto& [at, force] : forces) {
    sum = sum - force;
    moment -= geometry::cross(at - middle, force);
  }
  const Point t = (1 / geometry::distance(line.front(), line.back())) * (line.back() - line.front());
  return {geometry::dot(sum, geometry::left_of(t)), geometry::dot(sum, t), moment};
}

void expect_forces(const SectionForces& found, const SectionForces& exact, double scale) {
  EXPECT_NEAR(found.normal, exact.normal, scale);
  EXPECT_NEAR(found.shear, exact.shear, scale);
  EXPECT_NEAR(found.moment, exact.moment, 10 * scale);
}

struct Choice {
  const char *mesh, *element, *order, *yields;
};

class Beam : public testing::TestWithParam<Choice> {};

TEST_P(Beam, has_the_forces_of_statics_over_any_line_that_divides_it) {
  const Choice& choice = GetParam();
  const SceneRun run = run_scene(scene("sections"), {{"mesh", choice.mesh},
                                                     {"element", choice.element},
                                                     {"order", choice.order},
                                                     {"yields", choice.yields}});
  const model::StageResult& stage = run.stage("load");
  // Nodal forces are differences of forces of the cells' stiffness times the deflection: 1e-9 of the loads.
  const double round_off = 1e-9 * 1.2e6;
  const std::vector<std::pair<std::string, std::vector<Point>>> lines = {
      {"upright", {{3.37, 0}, {3.37, 2}}},
      {"beyond", {{3.37, 0}, {3.37, 2}}},
      {"on_edges", {{5, 0}, {5, 2}}},
      {"inclined", {{3, 0}, {4.5, 2}}},
      {"kinked", {{3, 0}, {4.1, 1.05}, {3.2, 2}}},
      {"support", {{0, 0}, {0, 2}}}};
  for (const auto& [name, line] : lines) {
    SCOPED_TRACE(name);
    expect_forces(section(stage, name).forces, in_balance(line), round_off);
    EXPECT_FALSE(section(stage, name).ends_inside);
  }
  // The other sense: N and V stay, M changes its sign. The edge runs down, its region on the left.
  for (const auto& [name, line] : {lines[0], lines[5]}) {
    SectionForces exact = in_balance(line);
    exact.moment = -exact.moment;
    expect_forces(section(stage, name == "upright" ? "turned" : "edge").forces, exact, round_off);
  }
  // On the loaded end the line itself carries the traction: t is up, n points into the beam.
  expect_forces(section(stage, "loaded").forces, {pull, -push, 0}, round_off);
  EXPECT_TRUE(section(stage, "part").ends_inside);
}

TEST_P(Beam, has_a_profile_whose_integral_comes_near_them) {
  const Choice& choice = GetParam();
  const SceneRun run = run_scene(scene("sections"), {{"mesh", choice.mesh},
                                                     {"element", choice.element},
                                                     {"order", choice.order},
                                                     {"yields", choice.yields}});
  const SectionResult& cut = section(run.stage("load"), "upright");
  // Three to four cells over the height, of constant stress at order 1; fibres are extrapolated.
  const bool low = choice.order[0] == '1';
  EXPECT_LT(cut.difference, low ? 0.03 : 0.01);
  EXPECT_GT(cut.difference, 0);
  const double area = thickness * 2, bending = 6 * cut.forces.moment / (thickness * 4);
  const double mean = cut.forces.normal / area, most = std::abs(bending);
  EXPECT_NEAR(cut.rows.front().values[5], mean - bending, 0.1 * most);
  EXPECT_NEAR(cut.rows.back().values[5], mean + bending, 0.1 * most);
  EXPECT_NEAR(cut.rows.back().s, 2, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, Beam,
    testing::Values(Choice{"voronoi", "vem", "1", "false"}, Choice{"voronoi", "vem", "2", "false"},
                    Choice{"voronoi", "vem", "3", "false"}, Choice{"quads", "vem", "1", "false"},
                    Choice{"quads", "fem", "2", "false"}, Choice{"triangles", "fem", "2", "false"},
                    Choice{"voronoi", "vem", "2", "true"}),
    [](const auto& info) {
      return std::string(info.param.mesh) + info.param.element + info.param.order +
             (info.param.yields[0] == 't' ? "yields" : "");
    });

constexpr double soft = 1e9, stiff = 3e9, strain = 1e-3;

class Layers : public testing::TestWithParam<const char*> {};

TEST_P(Layers, keep_both_values_of_a_jump_across_the_line_and_along_it) {
  const SceneRun run = run_scene(scene("layers"), {{"order", GetParam()}});
  const model::StageResult& stage = run.stage("stretch");
  const double round_off = 1e-9 * stiff * strain;
  const SectionResult& across = section(stage, "across");
  for (const SectionResult::Row& row : across.rows) {
    EXPECT_NEAR(row.values[2], (row.region == "lower" ? soft : stiff) * strain, round_off) << row.s;
    EXPECT_EQ(row.piece, row.region == "lower" ? 0 : 1);
    if (!std::isnan(row.values[0])) {
      EXPECT_NEAR(row.values[0], 1.7 * strain, 1e-9 * strain);
    }
  }
  const auto at_border = [](const SectionResult::Row& row) { return std::abs(row.s - 1) < 1e-9; };
  EXPECT_EQ(std::ranges::count_if(across.rows, at_border), 2);
  expect_forces(across.forces, {(soft + stiff) * strain, 0, -0.5 * (soft - stiff) * strain}, round_off);
  EXPECT_LT(across.difference, 1e-9);
  // Along the border: the stress of both sides, and no traction.
  const SectionResult& border = section(stage, "border");
  for (const SectionResult::Row& row : border.rows) {
    const bool left = row.side == SectionResult::Side::left;
    EXPECT_TRUE(left || row.side == SectionResult::Side::right);
    EXPECT_EQ(row.region, left ? "upper" : "lower");
    EXPECT_NEAR(row.values[2], (left ? stiff : soft) * strain, round_off);
    EXPECT_NEAR(row.values[5], 0, round_off);
  }
  expect_forces(border.forces, {0, 0, 0}, round_off);
}

INSTANTIATE_TEST_SUITE_P(Orders, Layers, testing::Values("1", "2", "3"));

TEST(Section, along_a_joint_carries_what_is_put_on_and_across_it_nothing_is_lost) {
  const SceneRun run = run_scene(scene("layers"), {{"joint", "true"}});
  const model::StageResult& stage = run.stage("press");
  // Pressure from 1 to 2 MPa; push at half the upper layer's height against the corner's support.
  const double force = 6e6, moment = -1e6 * 4 * 4 / 12 + 0.2e6 * 0.5 - 0.2e6 * 1;
  const double round_off = 1e-9 * force;
  expect_forces(section(stage, "border").forces, {-force, 0, moment}, round_off);
  expect_forces(section(stage, "edge").forces, {-force, 0, moment}, round_off);
  expect_forces(section(stage, "backward").forces, {-force, 0, -moment}, round_off);
  EXPECT_LT(section(stage, "border").difference, 0.02);
  // Through the upper layer alone; the contact below it has no friction.
  EXPECT_NEAR(section(stage, "upper").forces.normal, -0.2e6, round_off);
  EXPECT_FALSE(section(stage, "upper").ends_inside);
  const SectionResult& across = section(stage, "across");
  EXPECT_EQ(across.rows.front().region, "lower");
  EXPECT_EQ(across.rows.back().region, "upper");
  EXPECT_EQ(across.rows.back().piece, 1);
  EXPECT_LT(across.difference, 0.06);
}

class Standing : public testing::TestWithParam<std::pair<const char*, const char*>> {};

// Reactions come by nodes; each line divides those of the edge that it crosses, or ends on.
TEST_P(Standing, divides_the_reactions_of_its_base_where_the_line_meets_it) {
  const SceneRun run =
      run_scene(scene("standing"), {{"mesh", GetParam().first}, {"order", GetParam().second}});
  const double pressure = 1e6, round_off = 1e-9 * pressure * 10;
  for (const SectionResult& each : run.stage("pressure").sections) {
    SCOPED_TRACE(each.name);
    const bool slanted = each.name == "slanted";
    // On the slanted line σ_y = −p acts over 1 m across, at its middle.
    const double along = 5 / std::hypot(1, 5), across = 1 / std::hypot(1, 5);
    expect_forces(each.forces,
                  slanted ? SectionForces{-pressure * across, -pressure * along, 0} : SectionForces{},
                  round_off);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Standing,
                         testing::Values(std::pair{"voronoi", "1"}, std::pair{"voronoi", "2"},
                                         std::pair{"quads", "1"}, std::pair{"quads", "3"}));

// Lamé: σ_r = p a²/(b² − a²) (1 − b²/r²).
TEST(Section, of_a_body_of_revolution_has_a_profile_and_no_resultants) {
  const SceneRun run = run_scene(scene("ring"));
  const SectionResult& wall = section(run.stage("pressure"), "wall");
  EXPECT_FALSE(wall.summed);
  EXPECT_FALSE(wall.integrated);
  ASSERT_EQ(wall.rows.size(), 41u);
  for (const SectionResult::Row& row : wall.rows)
    EXPECT_NEAR(row.values[2], 10e6 / 3 * (1 - 4 / (row.at.x * row.at.x)), 0.01 * 10e6) << row.at.x;
}

// Weight, water and a base of two materials: to round-off, whatever the stresses at heel and toe.
TEST(Section, along_the_base_of_a_dam_balances_weight_and_water) {
  const SceneRun run = run_scene(std::filesystem::path(ASHLAR_SOURCE_DIR) / "examples" / "gravity_dam");
  const double own = ((70 + 19.25) / 2 * 66.5 + (19.25 + 14.8) / 2 * 36.5) * 2643 * 9.80665;
  const double depth = 91.75, water = 9810 * depth * depth / 2;
  const SectionForces dry = section(run.stage("own weight"), "base").forces;
  EXPECT_NEAR(dry.normal, -own, 1e-10 * own);
  EXPECT_NEAR(dry.shear, 0, 1e-10 * own);
  const SectionForces full = section(run.stage("reservoir"), "base").forces;
  EXPECT_NEAR(full.normal, -own, 1e-10 * own);
  EXPECT_NEAR(full.shear, water, 1e-10 * own);
  EXPECT_NEAR(full.moment - dry.moment, -water * depth / 3, 1e-10 * own * 70);
}

}  // namespace
}  // namespace ashlar::test
