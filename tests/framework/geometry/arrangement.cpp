#include "geometry/arrangement.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geometry/polygon.hpp"

namespace geo = ashlar::geometry;
using geo::Index;
using geo::InputSegment;
using geo::Point;

namespace {

std::vector<InputSegment> ring(std::vector<Point> points, Index first) {
  std::vector<InputSegment> segments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    segments.push_back({points[i], points[(i + 1) % points.size()], first + static_cast<Index>(i)});
  }
  return segments;
}

std::vector<InputSegment> joined(std::vector<InputSegment> a, const std::vector<InputSegment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double area_of(const geo::Arrangement& arrangement, const geo::Arrangement::Face& face) {
  auto area = [&](const std::vector<Index>& entries) {
    std::vector<Point> points;
    for (const Index e : entries) {
      points.push_back(
          arrangement.points[e < 0 ? arrangement.segments[-1 - e].to : arrangement.segments[e].from]);
    }
    return points.empty() ? 0.0 : geo::signed_area(points);
  };
  double sum = area(face.outer);
  for (const auto& inner : face.inner) sum += area(inner);
  return sum;
}

}  // namespace

TEST(arrangement, squares_that_share_part_of_a_side) {
  const auto a = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0), b = ring({{1, 0.5}, {2, 0.5}, {2, 2}, {1, 2}}, 4);
  const auto result = geo::arrange(joined(a, b));
  EXPECT_EQ(result.faces.size(), 3u);
  EXPECT_EQ(result.points.size(), 8u);
  EXPECT_EQ(result.segments.size(), 9u);
  int shared = 0;
  for (const auto& s : result.segments) {
    if (s.sources.size() != 2) continue;
    ++shared;
    // The squares run against each other along their common side.
    EXPECT_EQ(s.sources, (std::vector<Index>{-1 - 7, 1}));
    EXPECT_EQ(result.points[s.from], (Point{1, 0.5}));
    EXPECT_EQ(result.points[s.to], (Point{1, 1}));
  }
  EXPECT_EQ(shared, 1);
}

TEST(arrangement, faces_lie_left_of_their_rings_and_know_a_point_inside) {
  const auto outer = ring({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0),
             hole = ring({{4, 4}, {6, 4}, {6, 6}, {4, 6}}, 4);
  auto segments = joined(outer, hole);
  segments.push_back({{1, 1}, {3, 3}, 8});   // an antenna on its own
  segments.push_back({{10, 5}, {8, 5}, 9});  // an antenna on the outer ring
  const auto result = geo::arrange(segments);
  ASSERT_EQ(result.faces.size(), 3u);
  double sum = 0;
  for (std::size_t f = 1; f < 3; ++f) {
    const double area = area_of(result, result.faces[f]);
    EXPECT_TRUE(std::abs(area - 96) < 1e-12 || std::abs(area - 4) < 1e-12);
    sum += area;
    for (const Index e : result.faces[f].outer) {
      const auto& s = result.segments[e < 0 ? -1 - e : e];
      EXPECT_EQ(e < 0 ? s.right : s.left, static_cast<Index>(f));
    }
    const Point p = result.faces[f].inside;
    const bool in_hole = p.x > 4 && p.x < 6 && p.y > 4 && p.y < 6;
    EXPECT_EQ(in_hole, std::abs(area - 4) < 1e-12);
    EXPECT_TRUE(in_hole || p.x != p.y);
  }
  EXPECT_NEAR(sum, 100, 1e-12);
}

TEST(arrangement, snaps_ends_to_each_other_and_to_lines) {
  // The third segment starts 1e-12 beside the slanted one: it must meet it in one point, without a stub.
  const std::vector<InputSegment> segments{
      {{0, 0}, {3, 1}, 0}, {{3 + 1e-12, 1}, {5, 5}, 1}, {{1.5, 0.5 - 1e-12}, {2, -3}, 2}};
  const auto result = geo::arrange(segments, 1e-9);
  EXPECT_EQ(result.points.size(), 5u);
  EXPECT_EQ(result.segments.size(), 4u);
  EXPECT_EQ(geo::arrange(segments).points.size(), 6u);
}

TEST(arrangement, three_lines_through_nearly_one_point_meet_in_one) {
  const std::vector<InputSegment> segments{
      {{0, 0}, {1, 0.7}, 0}, {{0, 0.7}, {1, 0}, 1}, {{0.5 + 1e-13, -1}, {0.5 + 1e-13, 2}, 2}};
  EXPECT_EQ(geo::arrange(segments, 1e-9).points.size(), 7u);
  EXPECT_EQ(geo::arrange(segments, 1e-9).faces.size(), 1u);
  EXPECT_GT(geo::arrange(segments).points.size(), 7u);
}

TEST(arrangement, random_lines_keep_euler_and_areas) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    auto segments = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0);
    for (Index i = 0; i < 12; ++i)
      segments.push_back({{at(random), at(random)}, {at(random), at(random)}, 4 + i});
    const auto result = geo::arrange(segments, 1e-9);
    double area = 0;
    for (std::size_t f = 1; f < result.faces.size(); ++f) area += area_of(result, result.faces[f]);
    EXPECT_NEAR(area, 1.0, 1e-12);
    std::size_t components = 0;
    for (const auto& face : result.faces) components += face.inner.size();
    // Euler: V − E + F = 1 + C, and every component is an inner ring of one face.
    EXPECT_EQ(result.points.size() + result.faces.size(), result.segments.size() + 1 + components);
  }
}
