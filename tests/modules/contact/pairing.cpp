// node_to_segment on lips that match, do not match, turn corners, cross and end in welded tips.

#include <gtest/gtest.h>

#include <numeric>

#include "modules/contact/blocks.hpp"

namespace ashlar::contact {
namespace {

using namespace ashlar::test;

/// What the last pairing said.
std::vector<std::string> remarks;

bool remarked(const std::string& words) {
  return std::ranges::any_of(
      remarks, [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

std::vector<ContactPoint> pairs(const model::Model& model, int slave = 0, Weight weight = Weight::tributary,
                                int joint = 0) {
  remarks.clear();
  return NodeToSegment(weight).pair(model, model.mesh.joints[joint], slave, &remarks);
}

double total(const std::vector<ContactPoint>& points, double ContactPoint::*length) {
  return std::accumulate(points.begin(), points.end(), 0.0,
                         [&](double sum, const ContactPoint& p) { return sum + p.*length; });
}

TEST(node_to_segment, matching_lips_pair_point_to_point) {
  const Blocks blocks = two_blocks(4, 4);
  const auto points = pairs(blocks.model);
  ASSERT_EQ(points.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_EQ(points[i].shares.size(), 2u);
    EXPECT_EQ(points[i].shares[0].at, points[i].shares[1].at);
    EXPECT_EQ(points[i].shares[1].factor, -1);
    EXPECT_EQ(points[i].gap, 0);
    EXPECT_EQ(points[i].normal, (Point{0, 1}));
    EXPECT_DOUBLE_EQ(points[i].s, 0.5 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(points[i].length, i % 4 == 0 ? 0.25 : 0.5);
    EXPECT_DOUBLE_EQ(points[i].h, 0.5);
    EXPECT_DOUBLE_EQ(points[i].modulus, plane_modulus);
  }
  EXPECT_DOUBLE_EQ(total(pairs(blocks.model, 1), &ContactPoint::area), 2);
}

TEST(node_to_segment, equal_weights_are_the_papers) {
  const Blocks blocks = two_blocks(3, 4);
  for (const ContactPoint& point : pairs(blocks.model, 0, Weight::equal)) EXPECT_DOUBLE_EQ(point.area, 0.5);
}

TEST(node_to_segment, points_between_master_points_share_by_xi_and_are_warned_of) {
  const Blocks blocks = two_blocks(4, 3);
  const auto points = pairs(blocks.model);
  ASSERT_EQ(points.size(), 4u);
  ASSERT_EQ(points[1].shares.size(), 3u);
  EXPECT_NEAR(points[1].shares[1].factor, -2.0 / 3, 1e-15);
  EXPECT_NEAR(points[1].shares[2].factor, -1.0 / 3, 1e-15);
  EXPECT_TRUE(remarked("do not match at 2 places"));
}

TEST(node_to_segment, the_softer_side_gives_the_modulus) {
  Blocks blocks = two_blocks(1, 1);
  auto soft = std::make_shared<PlainMaterial>();
  soft->modulus = 5;
  blocks.model.mesh.regions = {"rock", "clay"};
  blocks.model.materials = {blocks.model.materials[0], soft};
  blocks.model.mesh.cell_region[1] = 1;  // the upper cell of the lower block
  for (const int slave : {0, 1})
    for (const ContactPoint& point : pairs(blocks.model, slave)) EXPECT_EQ(point.modulus, 5);
}

TEST(node_to_segment, a_lip_beyond_the_other_carries_nothing_there_and_is_warned_of) {
  Blocks blocks = two_blocks(4, 4);
  blocks.model.mesh.joints[0].lips[1].pop_back();
  EXPECT_EQ(pairs(blocks.model).size(), 4u);
  EXPECT_TRUE(remarked("1 parts of the slave lip's edges face no edge"));
}

/// An inner square of unit side in the lower left corner of an L: the joint goes (0, 1) → (1, 1) → (1, 0).
model::Model corner() {
  // 0–3: the square's corners; 4–9: the L around it, cut along the diagonal.
  mesh::Mesh mesh =
      hand_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {1, 1}},
                {{0, 1, 2, 3}, {4, 5, 6, 9}, {9, 6, 7, 8}});
  mesh.joints.push_back({"bend", {"outer", "inner"}, {lip(mesh, {8, 9, 4}), lip(mesh, {3, 2, 1})}});
  return plain_model(std::move(mesh));
}

TEST(node_to_segment, corners_keep_the_normal_of_each_leg) {
  const model::Model model = corner();
  for (const int slave : {0, 1}) {
    const auto points = pairs(model, slave);
    ASSERT_EQ(points.size(), 4u);
    const double out = slave == 0 ? 1 : -1;  // normals leave the master
    EXPECT_EQ(points[0].normal, (Point{0, out}));
    EXPECT_EQ(points[1].normal, (Point{0, out}));
    EXPECT_EQ(points[2].normal, (Point{out, 0}));
    EXPECT_EQ(points[3].normal, (Point{out, 0}));
    EXPECT_EQ(points[1].s, points[2].s);
    for (const ContactPoint& point : points) {
      EXPECT_DOUBLE_EQ(point.area, 0.5);
      EXPECT_EQ(point.shares.size(), 2u);
      EXPECT_EQ(point.piece, 0);
    }
    // Slip of the first lip along the path: forward on the first leg, down on the second.
    EXPECT_EQ(points[0].tangent, (Point{slave == 0 ? 1.0 : -1.0, 0}));
    EXPECT_EQ(points[3].tangent, (Point{0, slave == 0 ? -1.0 : 1.0}));
  }
}

// Two cells above and two below a path that turns by an angle at (1, 0).
model::Model bent(double angle) {
  const Point end{1 + std::cos(angle), std::sin(angle)};
  std::vector<Point> points = {{0, -1}, {1, -1}, end - Point{0, 1}, {0, 0}, {1, 0}, end, {0, 0}, {1, 0}, end,
                               {0, 1},  {1, 1},  end + Point{0, 1}};
  mesh::Mesh mesh = hand_mesh(points, {{0, 1, 4, 3}, {1, 2, 5, 4}, {6, 7, 10, 9}, {7, 8, 11, 10}});
  mesh.joints.push_back({"bend", {"upper", "lower"}, {lip(mesh, {6, 7, 8}), lip(mesh, {3, 4, 5})}});
  return plain_model(std::move(mesh));
}

TEST(node_to_segment, gentle_kinks_are_one_point_with_the_normal_between_and_sharp_ones_two) {
  const double gentle = 0.35, sharp = 0.7;  // chords of a curve, corners of a path
  const model::Model curve = bent(gentle), corner = bent(sharp);
  const auto points = pairs(curve);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points[1].normal.x, -std::sin(gentle / 2), 1e-12);
  EXPECT_NEAR(points[1].normal.y, std::cos(gentle / 2), 1e-12);
  // A uniform pressure on both halves pushes along that normal with this length.
  EXPECT_NEAR(points[1].area, std::cos(gentle / 2), 1e-12);
  EXPECT_EQ(pairs(corner).size(), 4u);
  EXPECT_NEAR(total(pairs(corner), &ContactPoint::area), 2, 1e-12);
}

// Four unit squares around the origin, all apart: joint "level" along x, "upright" along y.
TEST(node_to_segment, crossings_pair_on_their_own_side) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> cells;
  for (const double y : {-1.0, 0.0})
    for (const double x : {-1.0, 0.0}) {
      const Index a = static_cast<Index>(points.size());
      for (const Point d : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}}) points.push_back(Point{x, y} + d);
      cells.push_back({a, a + 1, a + 2, a + 3});
    }
  mesh::Mesh mesh = hand_mesh(points, cells);
  const auto join = [](std::vector<mesh::LipEdge> first, std::vector<mesh::LipEdge> second) {
    second[0].s_from += 1;
    second[0].s_to += 1;
    first.push_back(second[0]);
    return first;
  };
  // Cells 0 and 1 lie below (points 0–3 and 4–7), 2 and 3 above (8–11 and 12–15).
  mesh.joints.push_back(
      {"level",
       {"up", "down"},
       {join(lip(mesh, {8, 9}), lip(mesh, {12, 13})), join(lip(mesh, {3, 2}), lip(mesh, {7, 6}))}});
  const model::Model model = plain_model(std::move(mesh));
  const auto found = pairs(model);
  ASSERT_EQ(found.size(), 4u);
  const Index expected[][2] = {{8, 3}, {9, 2}, {12, 7}, {13, 6}};
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(found[i].shares.size(), 2u);
    EXPECT_EQ(found[i].shares[0].dof, 2 * expected[i][0]);
    EXPECT_EQ(found[i].shares[1].dof, 2 * expected[i][1]);
    EXPECT_EQ(found[i].piece, i / 2);
    EXPECT_DOUBLE_EQ(found[i].area, 0.5);
  }
}

// Two cells above, two below; the left halves are apart, the right ones share the points (1, 0) and (2, 0).
TEST(node_to_segment, welded_tips_carry_no_contact) {
  mesh::Mesh mesh =
      hand_mesh({{0, -1}, {1, -1}, {2, -1}, {0, 0}, {1, 0}, {2, 0}, {0, 0}, {0, 1}, {1, 1}, {2, 1}},
                {{0, 1, 4, 3}, {1, 2, 5, 4}, {6, 4, 8, 7}, {4, 5, 9, 8}});
  mesh.joints.push_back({"crack", {"upper", "lower"}, {lip(mesh, {6, 4}), lip(mesh, {3, 4})}});
  const model::Model model = plain_model(std::move(mesh));
  const auto found = pairs(model);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].shares[0].dof, 12);
  EXPECT_EQ(found[0].shares[1].dof, 6);
  EXPECT_DOUBLE_EQ(found[0].area, 0.5);
}

}  // namespace
}  // namespace ashlar::contact
