#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/predicates.hpp"
#include "geometry/shape.hpp"

namespace geo = ashlar::geometry;
using geo::Point;
using geo::Ring;

namespace {

Ring moved(const Ring& ring, Point by) {
  Ring result;
  for (const Point p : ring) result.push_back(p + by);
  return result;
}

const Ring chevron{{0, 0}, {2, 1}, {4, 0}, {2, 3}};
const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// Star-shaped about the origin, with random radii: simple, mostly not convex.
Ring random_star(std::mt19937& random, int corners) {
  std::uniform_real_distribution<double> radius(0.3, 1.0);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, r = radius(random);
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return ring;
}

}  // namespace

TEST(polygon, area_and_centroid_of_a_chevron) {
  EXPECT_DOUBLE_EQ(geo::signed_area(chevron), 4.0);
  EXPECT_NEAR(geo::centroid(chevron).x, 2.0, 1e-15);
  EXPECT_NEAR(geo::centroid(chevron).y, (6.0 * 1.0 - 2.0 * (1.0 / 3)) / 4.0, 1e-15);
  Ring turned(chevron.rbegin(), chevron.rend());
  EXPECT_DOUBLE_EQ(geo::signed_area(turned), -4.0);
  EXPECT_NEAR(geo::diameter(chevron), 4.0, 0);
}

TEST(polygon, keeps_its_digits_far_from_the_origin) {
  const Ring far = moved(chevron, {1e9, -3e9});
  EXPECT_DOUBLE_EQ(geo::signed_area(far), 4.0);
  const auto near = geo::monomial_integrals(chevron, {2, 1}, 4);
  const auto there = geo::monomial_integrals(far, Point{2, 1} + Point{1e9, -3e9}, 4);
  for (std::size_t i = 0; i < near.size(); ++i) EXPECT_DOUBLE_EQ(near[i], there[i]);
  EXPECT_NEAR(geo::centroid(far).x - 1e9, geo::centroid(chevron).x, 2e-7);
}

TEST(polygon, moments_of_a_rectangle_are_products) {
  const Ring rectangle{{-1, 2}, {3, 2}, {3, 5}, {-1, 5}};
  const Point center{0.5, 1};
  const auto moments = geo::monomial_integrals(rectangle, center, 6);
  auto power = [](double a, double b, int p) { return (std::pow(b, p + 1) - std::pow(a, p + 1)) / (p + 1); };
  std::size_t m = 0;
  for (int d = 0; d <= 6; ++d) {
    for (int q = 0; q <= d; ++q, ++m) {
      const double exact = power(-1.5, 2.5, d - q) * power(1, 4, q);
      EXPECT_NEAR(moments[m], exact, 1e-13 * std::max(1.0, std::abs(exact))) << d - q << ' ' << q;
    }
  }
}

TEST(polygon, moments_add_up_over_triangles) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Ring ring = random_star(random, 5 + trial % 9);
    const auto whole = geo::monomial_integrals(ring, {0.1, -0.2}, 5);
    std::vector<double> sum(whole.size(), 0.0);
    for (const auto& t : geo::triangulate(ring)) {
      const Ring triangle{ring[t[0]], ring[t[1]], ring[t[2]]};
      ASSERT_GT(geo::signed_area(triangle), 0);
      const auto part = geo::monomial_integrals(triangle, {0.1, -0.2}, 5);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
    }
    for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(sum[i], whole[i], 1e-14);
  }
}

TEST(polygon, contains_counts_the_border) {
  EXPECT_TRUE(geo::contains(chevron, {2, 2}));
  EXPECT_FALSE(geo::contains(chevron, {2, 0.5}));
  EXPECT_TRUE(geo::contains(chevron, {2, 1}));
  EXPECT_TRUE(geo::contains(chevron, {1, 0.5}));
  EXPECT_FALSE(geo::contains(square, {1.0000000000000002, 0.5}));
}

TEST(polygon, finds_the_first_crossing) {
  EXPECT_TRUE(geo::is_simple(chevron));
  const Ring bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  EXPECT_EQ(geo::first_crossing(bow), std::pair(0, 2));
  const Ring spike{{0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}};
  EXPECT_FALSE(geo::is_simple(spike));
  const Ring collinear{{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(geo::is_simple(collinear));
  const Ring touching{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}};
  EXPECT_FALSE(geo::is_simple(touching));
}

TEST(polygon, triangulation_skips_collinear_corners) {
  const Ring ring{{0, 0}, {0.25, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
  double area = 0;
  for (const auto& t : geo::triangulate(ring)) {
    const Ring triangle{ring[t[0]], ring[t[1]], ring[t[2]]};
    ASSERT_GT(geo::signed_area(triangle), 0);
    area += geo::signed_area(triangle);
  }
  EXPECT_DOUBLE_EQ(area, 1.0);
}

TEST(polygon, orientation_is_exact) {
  // On the line y = x up to the last bit: the rounded determinant alone errs.
  EXPECT_EQ(geo::orientation({0.5, 0.5}, {12, 12}, {24, 24}), 0);
  const double up = std::nextafter(0.5, 1.0);
  EXPECT_EQ(geo::orientation({12, 12}, {24, 24}, {0.5, up}), 1);
  EXPECT_EQ(geo::orientation({12, 12}, {24, 24}, {up, 0.5}), -1);
}

TEST(polygon, distance_to_a_segment_knows_its_place) {
  double t = -1;
  EXPECT_DOUBLE_EQ(geo::distance_to_segment({1, 1}, {0, 0}, {4, 0}, &t), 1.0);
  EXPECT_DOUBLE_EQ(t, 0.25);
  EXPECT_DOUBLE_EQ(geo::distance_to_segment({-3, 4}, {0, 0}, {4, 0}, &t), 5.0);
  EXPECT_DOUBLE_EQ(t, 0.0);
}

TEST(arc, points_lie_on_it_and_match_from_both_sides) {
  const Point start{1, 0}, end{0, 1};
  const auto there = geo::points_on_arc(start, end, {{0, 0}, true}, 0.2, 1);
  auto back = geo::points_on_arc(end, start, {{0, 0}, false}, 0.2, 1);
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(there, back);
  EXPECT_EQ(there.front(), start);
  EXPECT_EQ(there.back(), end);
  for (std::size_t i = 0; i < there.size(); ++i) {
    EXPECT_NEAR(geo::norm(there[i]), 1, 1e-15);
    EXPECT_LE(geo::distance(there[i > 0 ? i - 1 : 1], there[i]), 0.2);
  }
  EXPECT_EQ(geo::points_on_arc(start, start, {{0, 0}, true}, 10, std::numbers::pi / 4).size(), 9u);
}

TEST(arc, through_three_points) {
  const auto arc = geo::arc_through({1, 0}, {0, 1}, {-1, 0});
  ASSERT_TRUE(arc);
  EXPECT_NEAR(geo::norm(arc->center), 0, 1e-16);
  EXPECT_TRUE(arc->counter_clockwise);
  EXPECT_FALSE(geo::arc_through({1, 0}, {0, -1}, {-1, 0})->counter_clockwise);
  EXPECT_FALSE(geo::arc_through({0, 0}, {1, 1}, {2, 2}));
}
