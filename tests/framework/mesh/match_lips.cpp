// Node insertion: the points of both lips correspond one to one, and the mesh stays sound.

#include "mesh/match_lips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "framework/mesh/mesh_shapes.hpp"
#include "framework/mesh/two_bodies.hpp"
#include "geometry/polygon.hpp"
#include "mesh/insert.hpp"
#include "mesh/verify.hpp"

namespace geo = ashlar::geometry;
using namespace ashlar::mesh;

namespace {

void expect_sound(const Mesh& mesh) {
  const auto faults = verify(mesh);
  EXPECT_TRUE(faults.empty()) << faults.size() << " faults, first: " << faults.front();
}

double area(const Mesh& mesh) {
  double sum = 0;
  std::vector<Point> corners;
  for (Index c = 0; c < mesh.cell_count(); ++c) sum += geo::signed_area(mesh.corners(c, corners));
  return sum;
}

std::set<Index> points_of(const std::vector<LipEdge>& lip) {
  std::set<Index> points;
  for (const LipEdge& edge : lip) points.insert({edge.from, edge.to});
  return points;
}

/// The greatest distance between two points of a pair.
double widest(const Mesh& mesh, std::size_t joint = 0) {
  double most = 0;
  for (const auto& [a, b] : mesh.joints[joint].pairs)
    most = std::max(most, geo::distance(mesh.points[a], mesh.points[b]));
  return most;
}

/// Two blocks whose common border goes through y = 1 at both ends, all points mapped.
Mesh mapped_blocks(int n, int m, const auto& map) {
  Mesh mesh = two_blocks(n, m);
  for (Point& p : mesh.points) p = map(p);
  return mesh;
}

Mesh turned_blocks(int n, int m, double angle) {
  return mapped_blocks(n, m, [angle](Point p) {
    return Point{3 + std::cos(angle) * p.x - std::sin(angle) * p.y,
                 std::sin(angle) * p.x + std::cos(angle) * p.y};
  });
}

}  // namespace

TEST(match_lips, each_lip_gets_the_points_of_the_other) {
  struct Case {
    int low, up;
    std::size_t pairs;
    Index inserted;
  };
  for (const auto& [low, up, pairs, inserted] :
       {Case{2, 6, 7, 4}, Case{5, 7, 12, 10}, Case{1, 1, 2, 0}, Case{3, 1, 4, 2}}) {
    for (const double angle : {0.0, 0.7, 2.0}) {
      Mesh mesh = turned_blocks(low, up, angle);
      const Index cells = mesh.cell_count(), points = mesh.point_count();
      EXPECT_EQ(match_lips(mesh, 0, 0.1), inserted);
      expect_sound(mesh);
      EXPECT_EQ(mesh.cell_count(), cells);
      EXPECT_EQ(mesh.point_count(), points + inserted);
      EXPECT_NEAR(area(mesh), 2, 1e-14);
      EXPECT_EQ(mesh.joints[0].pairs.size(), pairs);
      EXPECT_LT(widest(mesh), 1e-15);
      for (const auto& lip : mesh.joints[0].lips) EXPECT_EQ(points_of(lip).size(), pairs);
      for (const char* group : {"low.top", "up.bottom", "touch.low", "touch.up"})
        EXPECT_EQ(mesh.edge_groups.at(group).size(), pairs - 1) << group;
      EXPECT_EQ(match_lips(mesh, 0, 0.1), 0) << "they match already";
      EXPECT_EQ(mesh.joints[0].pairs.size(), pairs);
    }
  }
}

TEST(match_lips, s_of_both_lips_is_the_same_where_they_touch) {
  Mesh mesh = turned_blocks(4, 7, 0.3);
  match_lips(mesh, 0, 0.1);
  const auto& [first, second] = mesh.joints[0].lips;
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_NEAR(first[i].s_from, second[i].s_from, 1e-14);
    EXPECT_NEAR(first[i].s_to, second[i].s_to, 1e-14);
  }
}

TEST(match_lips, irrational_divisions_and_points_that_nearly_meet) {
  const RegionShape low = box("low", {0, 0}, {1, 1}), up = box("up", {0, 1}, {1, 2});
  for (const double off : {0.1, 1e-6, 1e-10}) {
    const double at = 1 / std::sqrt(2);
    std::vector<Mesh> parts;
    parts.push_back(build_mesh(lattice({0, at, 1}, steps(1)), alone(low)));
    parts.push_back(build_mesh(lattice({0, 1 / std::numbers::pi, at + off, 1}, steps(1, 1, 2)), alone(up)));
    Mesh mesh = merge(std::move(parts), {"low", "up"});
    add_face_joints(mesh, {faces("touch", "low.top", "up.bottom")});
    EXPECT_EQ(match_lips(mesh, 0, 0.1), off > 1e-8 ? 3 : 1) << off;
    expect_sound(mesh);
    EXPECT_LE(widest(mesh), off > 1e-8 ? 1e-15 : 2 * off);
    EXPECT_EQ(mesh.joints[0].pairs.size(), off > 1e-8 ? 5u : 4u);
  }
}

TEST(match_lips, bent_lips_meet_corner_to_corner_also_across_a_gap) {
  const auto roof = [](Point p) { return Point{p.x, p.y + 0.3 * (1 - std::abs(2 * p.x - 1))}; };
  for (const double gap : {0.0, 1e-3, 0.02}) {
    for (const double sense : {1.0, -1.0}) {
      Mesh mesh = mapped_blocks(2, 6, [&](Point p) {
        const Point q = roof(p);
        return Point{q.x, 1 + sense * (q.y - 1)};
      });
      if (sense < 0)  // the mirror turns cells round: turn the bend alone
        mesh = mapped_blocks(2, 6, [&](Point p) { return Point{p.x, 2 * p.y - roof(p).y}; });
      for (const Index p : points_of(mesh.joints[0].lips[1])) mesh.points[p].y += gap;
      match_lips(mesh, 0, 0.5);
      expect_sound(mesh);
      const auto corner = std::ranges::find_if(mesh.joints[0].pairs, [&](const auto& pair) {
        return std::abs(mesh.points[pair[0]].x - 0.5) < 1e-12;
      });
      ASSERT_NE(corner, mesh.joints[0].pairs.end());
      EXPECT_NEAR(mesh.points[(*corner)[1]].x, 0.5, 1e-12) << gap;
      EXPECT_GE(mesh.joints[0].pairs.size(), 5u);
      EXPECT_LE(widest(mesh), gap + 1e-15);
    }
  }
}

TEST(match_lips, beyond_the_other_lips_ends_points_stay_alone) {
  const RegionShape low = box("low", {0, 0}, {1, 1}), up = box("up", {0.3, 1}, {0.8, 2});
  std::vector<Mesh> parts;
  parts.push_back(build_mesh(lattice(steps(4), steps(2)), alone(low)));
  parts.push_back(build_mesh(lattice({0.3, 0.6, 0.8}, steps(2, 1, 2)), alone(up)));
  Mesh mesh = merge(std::move(parts), {"low", "up"});
  add_face_joints(mesh, {faces("touch", "low.top", "up.bottom")});
  EXPECT_EQ(match_lips(mesh, 0, 0.1), 3 + 2) << "0.3, 0.6 and 0.8 below; 0.5 and 0.75 above";
  expect_sound(mesh);
  EXPECT_EQ(mesh.joints[0].pairs.size(), 5u);
  EXPECT_EQ(mesh.joints[0].lips[0].size(), 7u);
}

TEST(match_lips, two_bodies_on_one_face_share_its_points) {
  std::vector<Mesh> parts;
  const RegionShape low = box("low", {0, 0}, {1, 1}), a = box("a", {0, 1}, {0.5, 2}),
                    b = box("b", {0.5, 1}, {1, 2});
  parts.push_back(build_mesh(lattice(steps(3), steps(3)), alone(low)));
  parts.push_back(build_mesh(lattice(steps(2, 0, 0.5), steps(2, 1, 2)), alone(a)));
  parts.push_back(build_mesh(lattice(steps(2, 0.5, 1), steps(2, 1, 2)), alone(b)));
  Mesh mesh = merge(std::move(parts), {"low", "a", "b"});
  add_face_joints(mesh, {faces("left", "low.top", "a.bottom"), faces("right", "b.bottom", "low.top")});
  EXPECT_EQ(match_lips(mesh, 0, 0.1), 2 + 1);
  expect_sound(mesh);
  EXPECT_EQ(match_lips(mesh, 1, 0.1), 1 + 1) << "0.5 is there already";
  expect_sound(mesh);
  EXPECT_EQ(mesh.joints[0].lips[0].size(), 6u);
  EXPECT_EQ(mesh.joints[1].lips[1].size(), 6u);
  EXPECT_LT(std::max(widest(mesh, 0), widest(mesh, 1)), 1e-15);
  EXPECT_EQ(mesh.joints[0].pairs.size(), 4u);
  EXPECT_EQ(mesh.joints[1].pairs.size(), 4u);
}

TEST(match_lips, a_disc_over_a_block_within_reach) {
  for (const bool disc_first : {true, false}) {
    std::size_t before = 0;
    for (const double reach : {0.02, 0.2, 0.45}) {
      Mesh mesh = disc_on_block(disc_first);
      match_lips(mesh, 0, reach);
      expect_sound(mesh);
      const JointLips& joint = mesh.joints[0];
      EXPECT_GT(joint.pairs.size(), before);
      before = joint.pairs.size();
      const std::size_t disc = disc_first ? 0 : 1;
      double last = disc_first ? -1e9 : 1e9;  // the first lip's sense
      for (const auto& pair : joint.pairs) {
        const Point rim = mesh.points[pair[disc]], top = mesh.points[pair[1 - disc]];
        EXPECT_EQ(top.y, 1);
        EXPECT_NEAR(geo::distance(rim, {2, 2}), 1, 1e-12) << "inserted points lie on the arc";
        EXPECT_LE(rim.y - 1, reach + 1e-9) << "the block's edges are the longer ones";
        EXPECT_EQ(disc_first, top.x > last);
        last = top.x;
      }
    }
  }
}

TEST(match_lips, random_lips_with_a_gap_keep_their_order) {
  unsigned seed = 7;
  const auto random = [&seed] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<double>(seed >> 8) / (1 << 24);
  };
  for (int round = 0; round < 40; ++round) {
    Mesh mesh = mapped_blocks(3 + round % 7, 4 + round % 5, [](Point p) {
      return Point{p.x, p.y + 0.1 * std::sin(5 * p.x)};
    });
    for (const LipEdge& edge : mesh.joints[0].lips[1]) mesh.points[edge.from].y += 0.03 * random();
    for (const LipEdge& edge : mesh.joints[0].lips[0]) mesh.points[edge.to].x -= 0.02 * random();
    match_lips(mesh, 0, 1);
    expect_sound(mesh);
    const auto position = [&](int side, Index point) {
      const auto& lip = mesh.joints[0].lips[side];
      const auto edge = std::ranges::find(lip, point, &LipEdge::from);
      return edge == lip.end() ? lip.back().s_to : edge->s_from;
    };
    EXPECT_GE(mesh.joints[0].pairs.size(), 5u);
    for (std::size_t i = 1; i < mesh.joints[0].pairs.size(); ++i)
      for (int side = 0; side < 2; ++side)
        EXPECT_GT(position(side, mesh.joints[0].pairs[i][side]),
                  position(side, mesh.joints[0].pairs[i - 1][side]));
  }
}

TEST(match_lips, lips_that_split_a_mesh_have_their_points) {
  ashlar::core::Mistakes mistakes;
  const Domain domain =
      make_domain({box("a", {0, 0}, {1, 1})}, {joint("crack", {{0.5, 0}, {0.5, 0.5}})}, 1, mistakes);
  Mesh mesh = build_mesh(lattice(steps(4), steps(4)), domain);
  EXPECT_EQ(match_lips(mesh, 0, 1), 0);
  EXPECT_EQ(mesh.joints[0].pairs.size(), 2u) << "the tip is one point";
  expect_sound(mesh);
}

TEST(insert_points, keeps_everything_that_knows_the_edge) {
  Mesh mesh = disc_on_block(false);
  const LipEdge rim = mesh.joints[0].lips[1].front();
  const auto made = insert_points(mesh, std::vector<PointOnEdge>{{rim.edge, 0.75}, {rim.edge, 0.25}});
  expect_sound(mesh);
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(mesh.joints[0].lips[1].size(), 50u);
  EXPECT_EQ(mesh.edge_groups.at("disc.rim").size(), 50u);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(mesh.joints[0].lips[1][static_cast<std::size_t>(i)].arc);
  for (const Index p : made) EXPECT_NEAR(geo::distance(mesh.points[p], {2, 2}), 1, 1e-14);
  // The second lip runs against its edges.
  EXPECT_EQ(mesh.joints[0].lips[1][0].to, made[0]);
  EXPECT_EQ(mesh.cell_points.count(rim.cell), 5);
  EXPECT_EQ(mesh.arcs.size(), 50u);
}
