#include "mesh/domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "framework/mesh/mesh_shapes.hpp"
#include "geometry/polygon.hpp"

namespace geo = ashlar::geometry;
namespace core = ashlar::core;
using namespace ashlar::mesh;

namespace {

Domain made(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints = {}) {
  core::Mistakes mistakes;
  Domain domain = make_domain(regions, joints, 0.5, mistakes);
  EXPECT_TRUE(mistakes.empty()) << core::to_string(mistakes.list().front());
  return domain;
}

std::string mistake(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints = {}) {
  core::Mistakes mistakes;
  make_domain(regions, joints, 0.5, mistakes);
  if (mistakes.list().size() != 1) return std::to_string(mistakes.list().size()) + " mistakes";
  return mistakes.list().front().what;
}

double area(const Domain& domain, Index region) {
  double sum = 0;
  for (Index f = 0; f < static_cast<Index>(domain.faces.size()); ++f) {
    if (domain.faces[f].region != region) continue;
    for (const auto& ring : domain.rings(f)) sum += geo::signed_area(ring);
  }
  return sum;
}

double border_length(const Domain& domain, const std::string& name) {
  double sum = 0;
  for (const auto& s : domain.segments) {
    if (std::count(s.borders.begin(), s.borders.end(), name)) {
      sum += geo::distance(domain.points[s.from], domain.points[s.to]);
    }
  }
  return sum;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::vector<RegionShape> dam_on_rock{
    region("rock", polygon({{0, 0}, {25, 0}, {25, 10}, {0, 10}}, {"bottom", "right", "ground", "left"})),
    region("dam",
           polygon({{10, 10}, {15, 10}, {12, 15}, {10, 15}}, {"base", "downstream", "crest", "upstream"}))};

}  // namespace

TEST(domain, regions_share_part_of_a_border) {
  const Domain domain = made(dam_on_rock);
  EXPECT_EQ(domain.faces.size(), 2u);
  EXPECT_EQ(domain.points.size(), 8u);
  EXPECT_DOUBLE_EQ(border_length(domain, "rock.ground"), 25);
  EXPECT_DOUBLE_EQ(border_length(domain, "dam.base"), 5);
  for (const auto& s : domain.segments) {
    if (s.left < 0 || s.right < 0) continue;
    EXPECT_EQ(s.borders, (std::vector<std::string>{"dam.base", "rock.ground"}));
  }
  EXPECT_EQ(domain.faces[domain.face_at({12, 12})].region, 1);
  EXPECT_EQ(domain.faces[domain.face_at({12, 5})].region, 0);
  EXPECT_EQ(domain.face_at({1, 12}), -1);
  EXPECT_GE(domain.face_at({12, 10}), 0);
}

TEST(domain, slanted_common_border_is_shared_exactly) {
  // The upper region's corners miss the slanted line y = x/3 by rounding.
  const auto domain = made({region("low", polygon({{0, 0}, {3, 1}, {3, -2}, {0, -2}})),
                            region("high", polygon({{0.9, 0.9 / 3}, {2.1, 2.1 / 3}, {2, 4}}))});
  EXPECT_EQ(domain.faces.size(), 2u);
  EXPECT_EQ(domain.points.size(), 7u);
  EXPECT_EQ(domain.segments.size(), 8u);
}

TEST(domain, booleans_with_holes_and_arcs) {
  const geo::Shape plate = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {"bottom", "right", "top", "left"});
  const geo::Shape disc = circle({4, 2}, 1, "notch");
  const auto cut = made({region("plate", operation(geo::Shape::Kind::difference, {plate, disc}))});
  EXPECT_NEAR(area(cut, 0), 16 - std::numbers::pi / 2, 0.01);
  EXPECT_NEAR(border_length(cut, "plate.notch"), std::numbers::pi, 0.01);
  EXPECT_DOUBLE_EQ(border_length(cut, "plate.right"), 2);
  const auto both = made({region("plate", operation(geo::Shape::Kind::unite, {plate, disc}))});
  EXPECT_EQ(both.faces.size(), 1u);
  EXPECT_NEAR(area(both, 0), 16 + std::numbers::pi / 2, 0.01);
  const auto common = made({region("plate", operation(geo::Shape::Kind::intersection, {plate, disc}))});
  EXPECT_NEAR(area(common, 0), std::numbers::pi / 2, 0.01);
  EXPECT_DOUBLE_EQ(border_length(common, "plate.right"), 2);

  geo::Shape holed = plate;
  holed.rings.push_back(circle({2, 2}, 1, "tunnel").rings[0]);
  const auto filled = made({region("rock", holed), region("core", circle({2, 2}, 1, "skin"))});
  EXPECT_EQ(filled.faces.size(), 2u);
  EXPECT_NEAR(area(filled, 0) + area(filled, 1), 16, 1e-12);
  EXPECT_NEAR(border_length(filled, "rock.tunnel"), border_length(filled, "core.skin"), 1e-15);
}

TEST(domain, arcs_shared_in_part_have_the_same_chords) {
  // Two sectors of one circle that meet at 50°, and outside of them a quarter of a ring that touches both.
  const auto on_circle = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Point{std::cos(angle), std::sin(angle)};
  };
  const auto sector = [&](Point a, Point b) {
    geo::Shape shape = polygon({{0, 0}, a, b});
    shape.rings[0][1].arc = geo::Arc{{0, 0}, true};
    return shape;
  };
  geo::Shape outside = polygon({{1, 0}, {2, 0}, {0, 2}, {0, 1}});
  outside.rings[0][3].arc = geo::Arc{{0, 0}, false};
  const auto domain = made({region("a", sector({1, 0}, on_circle(50))),
                            region("b", sector(on_circle(50), on_circle(140))), region("c", outside)});
  EXPECT_EQ(domain.faces.size(), 3u);
}

TEST(domain, joint_along_an_edge_inside_a_united_region_is_no_border) {
  const auto left = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {"", "seam", "", ""});
  const auto right = polygon({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {"", "end", "", ""});
  const auto both = operation(geo::Shape::Kind::unite, {left, right});
  const auto domain = made({region("r", both)}, {joint("j", {{1, 0.2}, {1, 0.8}})});
  EXPECT_EQ(border_length(domain, "r.seam"), 0);
  EXPECT_EQ(border_length(domain, "r.end"), 1);
  EXPECT_EQ(domain.faces.size(), 1u);
}

TEST(domain, joints_cross_and_end_anywhere_inside) {
  const auto domain =
      made(dam_on_rock, {joint("fault", {{4, 10}, {10, 4}}), joint("other", {{5, 5}, {7, 7}, {9, 9}}),
                         joint("tee", {{7, 7}, {7, 0}})});
  double length = 0;
  for (const auto& s : domain.segments) {
    if (s.joint != 0) continue;
    const double d = geo::distance(domain.points[s.from], domain.points[s.to]);
    length += d;
    const Point first = domain.points[s.joint_reversed ? s.to : s.from];
    EXPECT_NEAR(s.joint_position, geo::distance({4, 10}, first), 1e-12);
  }
  EXPECT_NEAR(length, std::hypot(6, 6), 1e-12);
  EXPECT_EQ(domain.faces.size(), 3u);
}

TEST(domain, border_joint_is_ordered_with_the_first_region_on_the_left) {
  JointLine between;
  between.name = "base";
  between.between = {"rock", "dam"};
  const auto domain = made(dam_on_rock, {between});
  int found = 0;
  for (const auto& s : domain.segments) {
    if (s.joint < 0) continue;
    ++found;
    EXPECT_EQ(domain.faces[s.joint_reversed ? s.right : s.left].region, 0);
    EXPECT_EQ(s.joint_position, 0);
  }
  EXPECT_EQ(found, 1);
}

TEST(domain, works_far_from_the_origin) {
  const Point o{5e6, 3e6};
  const auto domain =
      made({region("low", polygon({o, o + Point{10, 0.1}, o + Point{10, -5}, o + Point{0, -5}})),
            region("high", polygon({o, o + Point{10, 0.1}, o + Point{0, 5}}))},
           {joint("j", {o + Point{0, -1}, o + Point{4, 0.04}})});
  EXPECT_EQ(domain.faces.size(), 3u);
}

TEST(domain, mistakes_name_what_is_wrong) {
  const auto square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {"bottom", "right", "top", "left"});
  const auto shifted = polygon({{0.5, 0.5}, {2, 0.5}, {2, 2}});
  EXPECT_TRUE(says(mistake({region("a", square), region("b", shifted)}), "'a' and 'b' overlap"));
  EXPECT_TRUE(says(mistake({region("a", polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}))}), "crosses itself"));
  EXPECT_TRUE(says(mistake({region("a", polygon({{0, 0}, {1, 1}}))}), "is empty"));
  EXPECT_TRUE(says(mistake({region("a", polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}))}), "no length"));
  EXPECT_TRUE(
      says(mistake({region("a", operation(geo::Shape::Kind::difference, {square, square}))}), "is empty"));
  EXPECT_TRUE(says(mistake({region("a", polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {"x", "y", "x", "y"}))}),
                   "2 mist"));
  EXPECT_TRUE(
      says(mistake({region("a", square)}, {joint("j", {{0.5, 0.5}, {1.5, 0.5}})}), "outside every region"));
  EXPECT_TRUE(says(mistake({region("a", square)}, {joint("j", {{3, 3}, {4, 4}})}), "outside every region"));
  EXPECT_TRUE(says(mistake({region("a", square)}, {joint("j", {{0, 0}, {0.5, 0}})}), "outer border"));
  EXPECT_TRUE(says(mistake({region("a", square)}, {joint("j", {{0.5, 0.5}, {0.5, 0.5}})}), "no length"));
  EXPECT_TRUE(
      says(mistake({region("a", square)}, {joint("j", {{0.2, 0.5}, {0.8, 0.5}, {0.4, 0.5}})}), "twice"));
  JointLine between;
  between.name = "j";
  between.between = {"a", "b"};
  EXPECT_TRUE(says(mistake({region("a", square)}, {between}), "does not exist"));
  EXPECT_TRUE(says(mistake({region("a", square), region("b", polygon({{2, 0}, {3, 0}, {3, 1}}))}, {between}),
                   "no common"));
  geo::Shape holed = square;
  holed.rings.push_back(polygon({{0.5, 0.5}, {1.5, 0.5}, {0.5, 0.7}}).rings[0]);
  EXPECT_TRUE(says(mistake({region("a", holed)}), "hole that leaves"));
}

TEST(domain, joint_end_that_misses_the_border_by_rounding_touches_it) {
  const auto domain =
      made({region("a", polygon({{0, 0}, {3, 1}, {0, 4}}))}, {joint("j", {{1.2, 0.4 - 1e-12}, {0.5, 1.5}})});
  EXPECT_EQ(domain.points.size(), 5u);
  EXPECT_EQ(domain.faces.size(), 1u);
}
