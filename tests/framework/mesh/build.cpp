#include <gtest/gtest.h>

#include <random>
#include <set>

#include "framework/mesh/mesh_shapes.hpp"
#include "geometry/polygon.hpp"
#include "mesh/domain.hpp"
#include "mesh/verify.hpp"
#include "testing/meshes.hpp"

namespace geo = ashlar::geometry;
namespace core = ashlar::core;
using namespace ashlar::mesh;
using namespace ashlar::testing;

namespace {

double area(const Mesh& mesh) {
  double sum = 0;
  std::vector<Point> corners;
  for (Index c = 0; c < mesh.cell_count(); ++c) sum += geo::signed_area(mesh.corners(c, corners));
  return sum;
}

double length(const Mesh& mesh, const std::string& group) {
  double sum = 0;
  for (const Index e : mesh.edge_groups.at(group)) {
    sum += geo::distance(mesh.points[mesh.edge_points[e][0]], mesh.points[mesh.edge_points[e][1]]);
  }
  return sum;
}

void expect_sound(const Mesh& mesh) {
  const auto faults = verify(mesh);
  EXPECT_TRUE(faults.empty()) << faults.size() << " faults, first: " << faults.front();
}

// Points at this place: 1 where the mesh is whole, more where joints have opened it.
int count_at(const Mesh& mesh, Point p) {
  int count = 0;
  for (const Point q : mesh.points) count += geo::distance(p, q) < 1e-9;
  return count;
}

int body_count(const Mesh& mesh) {
  Index count = 0;
  bodies(mesh, count);
  return count;
}

void expect_lips(const Mesh& mesh, std::size_t joint, double total) {
  const JointLips& lips = mesh.joints[joint];
  double sum = 0;
  for (std::size_t i = 0; i < lips.lips[0].size(); ++i) {
    sum += lips.lips[0][i].s_to - lips.lips[0][i].s_from;
    if (i > 0) {
      EXPECT_NEAR(lips.lips[0][i].s_from, lips.lips[0][i - 1].s_to, 1e-9);
    }
  }
  EXPECT_NEAR(sum, total, 1e-9);
  EXPECT_NEAR(length(mesh, lips.name + "." + lips.sides[0]), total, 1e-9);
  EXPECT_NEAR(length(mesh, lips.name + "." + lips.sides[1]), total, 1e-9);
}

JointLine welded(JointLine line, bool first, bool last) {
  line.weld = {first, last};
  return line;
}

}  // namespace

TEST(build, every_family_is_sound_and_named) {
  for (const auto& family : ugly_families()) {
    SCOPED_TRACE(family.name);
    const Mesh mesh = square_mesh(family.make(8));
    expect_sound(mesh);
    EXPECT_NEAR(area(mesh), 1, 1e-14);
    for (const char* side : {"square.bottom", "square.right", "square.top", "square.left"}) {
      EXPECT_NEAR(length(mesh, side), 1, 1e-14);
    }
    EXPECT_EQ(body_count(mesh), 1);
    EXPECT_EQ(mesh.point_count() - mesh.edge_count() + mesh.cell_count(), 1);  // Euler
  }
}

TEST(build, edges_go_with_their_first_cell) {
  const Mesh mesh = square_mesh(structured_square(2));
  EXPECT_EQ(mesh.edge_count(), 12);
  EXPECT_EQ(mesh.edge_cells[1], (std::array<Index, 2>{0, 1}));
  EXPECT_EQ(mesh.edge_points[1], (std::array<Index, 2>{1, 4}));
}

TEST(build, followed_joint_through_the_body_parts_it) {
  const Mesh mesh = square_mesh(structured_square(4), {joint("j", {{0, 0.5}, {1, 0.5}})});
  expect_sound(mesh);
  EXPECT_EQ(mesh.cell_count(), 16);
  EXPECT_EQ(mesh.point_count(), 30);
  EXPECT_EQ(body_count(mesh), 2);
  expect_lips(mesh, 0, 1);
  for (const auto& lip : mesh.joints[0].lips[0]) EXPECT_GE(lip.cell, 8);  // left of +x is above
}

TEST(build, joint_with_a_tip_stays_welded_there_and_opens_at_the_mouth) {
  const Mesh mesh = square_mesh(structured_square(4), {joint("j", {{0, 0.5}, {0.5, 0.5}})});
  expect_sound(mesh);
  EXPECT_EQ(mesh.point_count(), 27);
  EXPECT_EQ(count_at(mesh, {0, 0.5}), 2);
  EXPECT_EQ(count_at(mesh, {0.25, 0.5}), 2);
  EXPECT_EQ(count_at(mesh, {0.5, 0.5}), 1);
  EXPECT_EQ(body_count(mesh), 1);
  const Mesh closed =
      square_mesh(structured_square(4), {welded(joint("j", {{0, 0.5}, {0.5, 0.5}}), true, false)});
  expect_sound(closed);
  EXPECT_EQ(count_at(closed, {0, 0.5}), 1);
  EXPECT_EQ(closed.point_count(), 26);
}

TEST(build, one_edge_with_both_ends_closed_still_has_two_lips) {
  const Mesh mesh = square_mesh(structured_square(4), {joint("j", {{0.25, 0.5}, {0.5, 0.5}})});
  expect_sound(mesh);
  EXPECT_EQ(mesh.point_count(), 25);
  ASSERT_EQ(mesh.joints[0].lips[0].size(), 1u);
  EXPECT_NE(mesh.joints[0].lips[0][0].edge, mesh.joints[0].lips[1][0].edge);
}

TEST(build, t_and_x_open_by_sectors) {
  const Mesh tee = square_mesh(structured_square(4),
                               {joint("a", {{0, 0.5}, {1, 0.5}}), joint("b", {{0.5, 0.5}, {0.5, 0}})});
  expect_sound(tee);
  EXPECT_EQ(count_at(tee, {0.5, 0.5}), 3);
  EXPECT_EQ(body_count(tee), 3);
  const Mesh bond = square_mesh(
      structured_square(4),
      {joint("a", {{0, 0.5}, {1, 0.5}}), welded(joint("b", {{0.5, 0.5}, {0.5, 0}}), true, false)});
  EXPECT_EQ(count_at(bond, {0.5, 0.5}), 2);
  const Mesh cross =
      square_mesh(structured_square(4), {joint("a", {{0, 0.5}, {1, 0.5}}), joint("b", {{0.5, 1}, {0.5, 0}})});
  expect_sound(cross);
  EXPECT_EQ(count_at(cross, {0.5, 0.5}), 4);
  EXPECT_EQ(body_count(cross), 4);
  const Mesh inner = square_mesh(
      structured_square(4), {joint("a", {{0.25, 0.5}, {0.75, 0.5}}), joint("b", {{0.5, 0.75}, {0.5, 0.25}})});
  expect_sound(inner);
  EXPECT_EQ(count_at(inner, {0.5, 0.5}), 4);
  EXPECT_EQ(inner.point_count(), 28);
}

TEST(build, joint_between_regions_names_each_lip_by_its_own_region) {
  JointLine between;
  between.name = "seam";
  between.between = {"low", "high"};
  between.sides = {"lower", "upper"};
  core::Mistakes mistakes;
  const Domain domain =
      make_domain({region("low", polygon({{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}}, {"", "", "roof", ""})),
                   region("high", polygon({{0, 0.5}, {1, 0.5}, {1, 1}, {0, 1}}, {"floor"}))},
                  {between}, 1, mistakes);
  ASSERT_TRUE(mistakes.empty());
  RawMesh raw = structured_square(4);
  for (Index c = 8; c < 16; ++c) raw.cell_region[c] = 1;
  const Mesh mesh = build_mesh(raw, domain);
  expect_sound(mesh);
  expect_lips(mesh, 0, 1);
  for (const auto& lip : mesh.joints[0].lips[0]) EXPECT_EQ(mesh.cell_region[lip.cell], 0);
  EXPECT_EQ(mesh.edge_groups.at("low.roof"), mesh.edge_groups.at("seam.lower"));
  EXPECT_EQ(mesh.edge_groups.at("high.floor"), mesh.edge_groups.at("seam.upper"));
  EXPECT_EQ(nearest_point(mesh, {0, 0.5}, "seam.upper"), 25);
  EXPECT_EQ(nearest_point(mesh, {0, 0.5}), 10);
}

TEST(build, oblique_joint_cuts_every_family) {
  for (const auto& family : ugly_families()) {
    SCOPED_TRACE(family.name);
    const Mesh mesh = square_mesh(family.make(8), {joint("j", {{0.1, 1}, {0.62, 0.37}})});
    expect_sound(mesh);
    EXPECT_NEAR(area(mesh), 1, 1e-14);
    expect_lips(mesh, 0, geo::distance({0.1, 1}, {0.62, 0.37}));
    EXPECT_EQ(count_at(mesh, {0.1, 1}), 2);
    EXPECT_EQ(count_at(mesh, {0.62, 0.37}), 1);
    EXPECT_EQ(body_count(mesh), 1);
    for (const auto& lip : mesh.joints[0].lips[1]) {
      EXPECT_LT(geo::distance_to_segment(mesh.points[lip.from], {0.1, 1}, {0.62, 0.37}), 1e-9);
    }
  }
}

TEST(build, joint_inside_one_cell_is_extended_at_both_ends) {
  const Mesh mesh = square_mesh(structured_square(2), {joint("j", {{0.1, 0.2}, {0.2, 0.25}, {0.3, 0.2}})});
  expect_sound(mesh);
  EXPECT_EQ(mesh.cell_count(), 6);
  EXPECT_EQ(count_at(mesh, {0.2, 0.25}), 2);
  EXPECT_EQ(count_at(mesh, {0.1, 0.2}), 1);
  expect_lips(mesh, 0, 2 * std::hypot(0.1, 0.05));
}

TEST(build, free_points_near_the_joint_move_onto_it) {
  const Mesh mesh = square_mesh(structured_square(4), {joint("j", {{0, 0.5005}, {1, 0.5005}})});
  expect_sound(mesh);
  EXPECT_EQ(mesh.joints[0].lips[0].size(), 4u);
  EXPECT_EQ(count_at(mesh, {0.5, 0.5005}), 2);
  EXPECT_EQ(count_at(mesh, {0.5, 0.5}), 0);
  EXPECT_EQ(count_at(mesh, {0, 0.5}), 1);  // a border's point does not move
}

TEST(build, random_joints_keep_area_and_soundness) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(0.02, 0.98);
  for (int trial = 0; trial < 150; ++trial) {
    SCOPED_TRACE(trial);
    const auto& family = ugly_families()[trial % ugly_families().size()];
    SCOPED_TRACE(family.name);
    std::vector<JointLine> joints;
    for (int j = 0; j < 1 + trial % 4; ++j) {
      std::vector<Point> path;
      for (int k = 0; k < 2 + (trial + j) % 3; ++k) path.push_back({at(random), at(random)});
      joints.push_back(joint("j" + std::to_string(j), path));
    }
    const Mesh mesh = square_mesh(family.make(5 + trial % 4), joints);
    expect_sound(mesh);
    EXPECT_NEAR(area(mesh), 1, 1e-14);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      double total = 0;
      for (std::size_t k = 1; k < joints[j].path.size(); ++k)
        total += geo::distance(joints[j].path[k - 1], joints[j].path[k]);
      expect_lips(mesh, j, total);
    }
    // A second run gives the same bits.
    const Mesh again = square_mesh(family.make(5 + trial % 4), joints);
    EXPECT_EQ(mesh.points, again.points);
    EXPECT_TRUE(std::equal(mesh.cell_points.values().begin(), mesh.cell_points.values().end(),
                           again.cell_points.values().begin()));
  }
}

TEST(build, paths_that_meet_themselves_or_turn_back_in_one_cell) {
  const std::vector<std::vector<Point>> paths{
      {{0.5688, 0.62}, {0.1318, 0.5983}, {0.125, 0.4904}, {0.25, 1}},
      {{0.4061, 0.4686}, {0.4619, 0.7813}, {0.213, 0.3822}, {0.5079, 0.125}},
      {{0.5322, 0.8863}, {0.75, 0.0321}, {0.4208, 0.875}, {0.7435, 1}}};
  for (const auto& family : ugly_families()) {
    SCOPED_TRACE(family.name);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      for (int n = 2; n <= 6; ++n) {
        const Mesh mesh = square_mesh(family.make(n), {joint("j", paths[k])});
        expect_sound(mesh);
        EXPECT_NEAR(area(mesh), 1, 1e-14);
      }
    }
  }
}

TEST(build, closed_loop_frees_a_block) {
  for (int n : {1, 2, 4, 7}) {
    const Mesh mesh =
        square_mesh(structured_square(n), {joint("loop", {{0.3, 0.3}, {0.7, 0.35}, {0.6, 0.7}, {0.3, 0.3}})});
    expect_sound(mesh);
    EXPECT_NEAR(area(mesh), 1, 1e-14);
    EXPECT_EQ(body_count(mesh), 2);
  }
}

TEST(build, file_mesh_without_domain) {
  RawMesh raw = structured_square(4);
  raw.regions = {"low", "high"};
  for (Index c = 8; c < 16; ++c) raw.cell_region[c] = 1;
  raw.edge_groups["floor"] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  raw.point_groups["corner"] = {10, 99};
  raw.points.resize(100, {7, 7});
  JointLine between;
  between.name = "seam";
  between.between = {"low", "high"};
  core::Mistakes mistakes;
  const Domain domain = make_domain({}, {joint("j", {{0.3, 0}, {0.3, 0.25}}), between}, 1, mistakes);
  ASSERT_TRUE(mistakes.empty());
  const Mesh mesh = build_mesh(raw, domain);
  expect_sound(mesh);
  EXPECT_EQ(mesh.joints.size(), 2u);
  expect_lips(mesh, 0, 0.25);
  expect_lips(mesh, 1, 1);
  EXPECT_NEAR(length(mesh, "floor"), 1, 1e-14);
  EXPECT_EQ(mesh.edge_groups.at("floor").size(), 5u);
  EXPECT_EQ(mesh.point_groups.at("corner").size(), 2u);
  EXPECT_EQ(body_count(mesh), 2);
}

TEST(build, mistakes_are_said) {
  core::Mistakes mistakes;
  const Domain outside = make_domain({}, {joint("j", {{0.5, 0.5}, {1.5, 0.6}})}, 1, mistakes);
  RawMesh raw = structured_square(4);
  raw.regions = {"square"};
  EXPECT_THROW(build_mesh(raw, outside), core::InputError);
  RawMesh doubled = structured_square(2);
  doubled.cell_points.append(std::array<Index, 4>{0, 1, 4, 3});
  doubled.cell_region.push_back(0);
  EXPECT_THROW(square_mesh(doubled), core::InputError);
  RawMesh small = structured_square(2);
  for (Point& p : small.points) p = 0.5 * p;
  EXPECT_THROW(square_mesh(small), core::InputError);
}

TEST(verify, finds_planted_faults) {
  const Mesh good = square_mesh(structured_square(3), {joint("j", {{0, 1.0 / 3}, {1, 1.0 / 3}})});
  expect_sound(good);
  auto faulty = [&](auto change) {
    Mesh mesh = good;
    change(mesh);
    return !verify(mesh).empty();
  };
  EXPECT_TRUE(faulty([](Mesh& m) { std::swap(m.cell_points.values()[0], m.cell_points.values()[1]); }));
  EXPECT_TRUE(faulty([](Mesh& m) { m.points[5] = {5, 5}; }));
  EXPECT_TRUE(faulty([](Mesh& m) { m.points.push_back({0, 0}); }));
  EXPECT_TRUE(faulty([](Mesh& m) { std::swap(m.edge_points[3][0], m.edge_points[3][1]); }));
  EXPECT_TRUE(faulty([](Mesh& m) { std::swap(m.joints[0].lips[0], m.joints[0].lips[1]); }));
  EXPECT_TRUE(faulty([](Mesh& m) { m.joints[0].lips[0].pop_back(); }));
  EXPECT_TRUE(faulty([](Mesh& m) { m.edge_groups["x"] = {1000}; }));
  EXPECT_TRUE(faulty([](Mesh& m) { m.cell_region[2] = 7; }));
}

TEST(report, counts_and_shapes) {
  const MeshReport r = report(square_mesh(structured_square(4)));
  EXPECT_EQ(r.cells, 16);
  EXPECT_EQ(r.edges, 40);
  EXPECT_DOUBLE_EQ(r.area, 1);
  EXPECT_DOUBLE_EQ(r.size_mean, 0.25);
  EXPECT_DOUBLE_EQ(r.shortest_edge, 0.25);
  EXPECT_DOUBLE_EQ(r.shortest_edge_ratio, std::sqrt(0.5));
  EXPECT_NEAR(r.roundness_min, 3.14159265358979 / 4, 1e-14);
  EXPECT_EQ(r.corners_max, 4);
  EXPECT_NEAR(report(square_mesh(short_edge_square(4))).shortest_edge, 0.25e-8, 1e-15);
}
