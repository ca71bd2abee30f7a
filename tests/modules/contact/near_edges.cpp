// The broad phase against asking every edge.

#include "contact/pairing/near_edges.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geometry/polygon.hpp"

namespace ashlar::contact {
namespace {

using mesh::Point;

TEST(near_edges, finds_what_asking_all_edges_finds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Point> points;
  std::vector<mesh::LipEdge> edges;
  // A lip of uneven edges that winds about.
  for (int i = 0; i <= 200; ++i) {
    points.push_back({0.1 * i + 0.08 * any(random), std::sin(0.07 * i) + 0.02 * any(random)});
    if (i > 0) edges.push_back({i - 1, 0, i - 1, i, 0, 0});
  }
  const NearEdges near(points, edges);
  for (int trial = 0; trial < 300; ++trial) {
    const Point place{40 * any(random) - 10, 20 * any(random) - 10};
    const auto distance = [&](std::size_t i) {
      return geometry::distance_to_segment(place, points[edges[i].from], points[edges[i].to]);
    };
    double least = INFINITY;
    for (std::size_t i = 0; i < edges.size(); ++i) least = std::min(least, distance(i));
    EXPECT_EQ(near.nearest_distance(place), least);
    const double radius = least + 2 * any(random);
    const std::vector<std::size_t> found = near.within(place, radius);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (distance(i) <= radius) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i));
      }
  }
}

TEST(near_edges, of_no_edges_nothing_is_near) {
  const std::vector<Point> points;
  const std::vector<mesh::LipEdge> edges;
  const NearEdges near(points, edges);
  EXPECT_TRUE(std::isinf(near.nearest_distance({1, 2})));
  EXPECT_TRUE(near.within({1, 2}, 5).empty());
}

}  // namespace
}  // namespace ashlar::contact
