// Bodies that are meshed apart: their groups, their meshes as one, and the lips between them.

#include "mesh/groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "framework/mesh/mesh_shapes.hpp"
#include "framework/mesh/two_bodies.hpp"
#include "geometry/polygon.hpp"
#include "mesh/face_lips.hpp"
#include "mesh/verify.hpp"

namespace geo = ashlar::geometry;
namespace core = ashlar::core;
using namespace ashlar::mesh;

namespace {

std::vector<Domain> domains(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints) {
  core::Mistakes mistakes;
  auto made = make_domains(regions, joints, 0.5, mistakes);
  EXPECT_TRUE(mistakes.empty()) << core::to_string(mistakes.list().front());
  return made;
}

std::string mistake(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints) {
  core::Mistakes mistakes;
  make_domains(regions, joints, 0.5, mistakes);
  std::string all;
  for (const auto& each : mistakes.list()) all += each.what + "\n";
  return all;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

using Names = std::vector<std::string>;

}  // namespace

TEST(groups, without_faces_there_is_one_domain_as_ever) {
  const auto parts = domains({box("a", {0, 0}, {1, 1}), box("b", {1, 0}, {2, 1})}, {});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].faces.size(), 2u);
}

TEST(groups, bonded_regions_stay_together_and_faces_part_bodies) {
  const std::vector<RegionShape> regions{box("rock", {0, 0}, {4, 1}), box("dam", {1, 1}, {3, 2}),
                                         box("gate", {3, 1}, {4, 2})};
  const auto parts =
      domains(regions, {faces("lift", "rock.top", "dam.bottom"), faces("seat", "rock.top", "gate.bottom")});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].regions, Names{"rock"});
  EXPECT_EQ(parts[1].regions, (Names{"dam", "gate"}));
  EXPECT_DOUBLE_EQ(parts[0].area() + parts[1].area(), 7);
  const Domain all = together(parts);
  EXPECT_EQ(all.regions, (Names{"rock", "dam", "gate"}));
  EXPECT_EQ(all.joints.size(), 2u);
  EXPECT_EQ(all.faces[all.face_at({3.5, 1.5})].region, 2);
  EXPECT_EQ(all.faces[all.face_at({3.5, 0.5})].region, 0);
}

TEST(groups, joints_inside_a_body_go_with_it) {
  JointLine between;
  between.name = "seam";
  between.between = {"b", "c"};
  const auto parts = domains({box("a", {0, 0}, {2, 1}), box("b", {0, 1}, {1, 2}), box("c", {1, 1}, {2, 2})},
                             {faces("ab", "a.top", "b.bottom"), joint("crack", {{1, 0.5}, {1, 0}}), between,
                              faces("ac", "a.top", "c.bottom")});
  ASSERT_EQ(parts.size(), 2u);
  const auto marked = [](const Domain& domain, const std::string& name) {
    return std::ranges::any_of(domain.segments, [&](const auto& segment) {
      return segment.joint >= 0 && domain.joints[segment.joint].name == name;
    });
  };
  EXPECT_TRUE(marked(parts[0], "crack"));
  EXPECT_TRUE(marked(parts[1], "seam"));
  EXPECT_TRUE(marked(together(parts), "seam"));
}

TEST(groups, bodies_may_lie_apart_touch_in_a_point_or_overlap_a_little) {
  for (const double y : {2.5, 2.0, 1.9}) {
    const auto parts = domains({box("block", {0, 0}, {4, 1}), region("disc", circle({2, y}, 1, "rim"))},
                               {faces("touch", "disc.rim", "block.top")});
    EXPECT_EQ(parts.size(), 2u) << y;
  }
}

TEST(groups, a_disc_in_its_hole_is_parted_along_the_arc) {
  const auto hole =
      operation(geo::Shape::Kind::difference, {box("", {0, 0}, {4, 4}).shape, circle({2, 2}, 1, "wall")});
  const std::vector<RegionShape> regions{region("plate", hole), region("pin", circle({2, 2}, 1, "rim"))};
  EXPECT_EQ(domains(regions, {faces("fit", "pin.rim", "plate.wall")}).size(), 2u);
}

TEST(groups, mistakes_name_what_is_wrong) {
  const auto a = box("a", {0, 0}, {2, 1}), b = box("b", {0, 1}, {2, 2});
  EXPECT_TRUE(says(mistake({a, b}, {faces("j", "a.right", "b.right")}),
                   "'a' and 'b' meet by contact, but they are bonded along another border from (0, 1)"));
  EXPECT_TRUE(says(mistake({a, b, box("c", {2, 0}, {3, 2})}, {faces("j", "a.top", "b.bottom")}),
                   "other regions or joints make them one body"));
  EXPECT_TRUE(says(mistake({a, b, box("c", {0, 2}, {1, 3})},
                           {faces("j", "a.top", "b.bottom"), faces("k", "a.bottom", "b.top")}),
                   "edge 'b.top' of joint 'k' is not on the border of its body from (0, 2) to (1, 2)"));
  EXPECT_TRUE(says(mistake({a, b}, {faces("j", "a.top", "b.bottom"), joint("crack", {{1, 0}, {1, 2}})}),
                   "joint 'crack' runs through 'a' and 'b', which are meshed apart"));
  const auto low = box("low", {0, 0.9}, {2, 2});
  EXPECT_TRUE(says(mistake({a, low}, {faces("j", "a.right", "low.right")}), "regions 'a' and 'low' overlap"));
  EXPECT_TRUE(says(mistake({a, b, box("c", {1, 1.5}, {3, 3})}, {faces("j", "a.top", "b.bottom")}),
                   "regions 'b' and 'c' overlap"));
  // The notch takes the whole edge away.
  const auto cut =
      operation(geo::Shape::Kind::difference, {a.shape, polygon({{-1, 0.5}, {3, 0.5}, {3, 2}, {-1, 2}})});
  EXPECT_TRUE(
      says(mistake({region("a", cut), b}, {faces("j", "a.top", "b.bottom")}), "nothing is left of it"));
}

TEST(merge, keeps_all_parts_sound_and_names_all_groups) {
  const Mesh mesh = two_blocks(3, 4);
  EXPECT_TRUE(verify(mesh).empty()) << verify(mesh).front();
  EXPECT_EQ(mesh.cell_count(), 3 * 3 + 4 * 4);
  Index count = 0;
  bodies(mesh, count);
  EXPECT_EQ(count, 2);
  EXPECT_EQ(mesh.regions, (Names{"up", "low"}));
  for (Index cell = 0; cell < 9; ++cell) EXPECT_EQ(mesh.cell_region[cell], 1) << "the lower body came first";
  EXPECT_EQ(mesh.edge_groups.at("low.top").size(), 3u);
  EXPECT_EQ(mesh.edge_groups.at("up.left").size(), 4u);
  EXPECT_EQ(mesh.edge_groups.at("touch.up").size(), 4u);
  for (const Index edge : mesh.edge_groups.at("up.bottom"))
    for (const Index p : mesh.edge_points[edge]) EXPECT_DOUBLE_EQ(mesh.points[p].y, 1);
}

TEST(face_lips, both_run_along_the_path_with_s_by_projection) {
  const Mesh mesh = two_blocks(3, 4);
  ASSERT_EQ(mesh.joints.size(), 1u);
  const JointLips& joint = mesh.joints[0];
  EXPECT_TRUE(joint.apart);
  EXPECT_EQ(joint.sides, (std::array<std::string, 2>{"low", "up"}));
  // The lower body is on the left of its top edge, which runs from right to left.
  EXPECT_DOUBLE_EQ(mesh.points[joint.lips[0].front().from].x, 1);
  EXPECT_DOUBLE_EQ(joint.lips[0].back().s_to, 1);
  ASSERT_EQ(joint.lips[1].size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(joint.lips[1][i].s_from, 0.25 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(joint.lips[1][i].s_to, 0.25 * static_cast<double>(i + 1), 1e-12);
    EXPECT_NEAR(mesh.points[joint.lips[1][i].from].x, 1 - 0.25 * static_cast<double>(i), 1e-12);
  }
}

TEST(face_lips, a_ring_is_cut_where_it_is_farthest_and_s_grows_all_round) {
  for (const bool disc_first : {true, false}) {
    const Mesh mesh = disc_on_block(disc_first);
    EXPECT_TRUE(verify(mesh).empty()) << verify(mesh).front();
    const JointLips& joint = mesh.joints[0];
    const auto& rim = joint.lips[disc_first ? 0 : 1];
    ASSERT_EQ(rim.size(), 48u);
    EXPECT_EQ(rim.front().from, rim.back().to);
    EXPECT_NEAR(mesh.points[rim.front().from].y, 3, 1e-12) << "the top is farthest from the block";
    double total = 0;
    for (const LipEdge& edge : rim) total += edge.s_to - edge.s_from;
    if (disc_first) {
      EXPECT_NEAR(total, 96 * std::sin(std::numbers::pi / 48), 1e-12);
    }
    // At the bottom both run with the same s.
    const auto at = [&](const std::vector<LipEdge>& lip, Point p) {
      const auto edge = std::ranges::find_if(
          lip, [&](const LipEdge& each) { return geo::distance(mesh.points[each.from], p) < 1e-9; });
      return edge == lip.end() ? -1e9 : edge->s_from;
    };
    EXPECT_NEAR(at(joint.lips[0], {2, 1}), at(joint.lips[1], {2, 1}), 1e-12);
  }
}

TEST(arcs, edges_know_them_and_their_points_are_put_on_them) {
  for (const bool disc_first : {true, false}) {
    const Mesh mesh = disc_on_block(disc_first, true);
    EXPECT_TRUE(verify(mesh).empty()) << verify(mesh).front();
    const int side = disc_first ? 0 : 1;
    ASSERT_EQ(mesh.joints[0].lips[side].size(), 96u) << "each chord has a point in its middle";
    for (const LipEdge& edge : mesh.joints[0].lips[side]) {
      ASSERT_TRUE(edge.arc);
      EXPECT_EQ(edge.arc->center, (Point{2, 2}));
      EXPECT_EQ(edge.arc->radius, 1);
      const Point a = mesh.points[edge.from] - Point{2, 2}, b = mesh.points[edge.to] - Point{2, 2};
      EXPECT_NEAR(norm(a), 1, 1e-15);
      EXPECT_EQ(cross(a, b) > 0, edge.arc->counter_clockwise);
      EXPECT_EQ(edge.arc->counter_clockwise, disc_first) << "the body is on the left of the first lip";
    }
    for (const LipEdge& edge : mesh.joints[0].lips[1 - side]) EXPECT_FALSE(edge.arc);
  }
}

TEST(arcs, of_faces_have_chords_that_are_off_by_a_twentieth_of_the_least_cell) {
  const auto chords = [](const std::vector<JointLine>& joints, double chord) {
    core::Mistakes mistakes;
    const auto parts = make_domains({box("block", {0, 0}, {4, 1}), region("disc", circle({2, 2}, 1, "rim"))},
                                    joints, chord, mistakes);
    return std::ranges::count_if(together(parts).segments, [](const auto& s) { return s.arc.has_value(); });
  };
  const JointLine touch = faces("touch", "disc.rim", "block.top");
  EXPECT_NEAR(static_cast<double>(chords({}, 0.01)), 2 * std::numbers::pi / 0.01, 1);
  EXPECT_NEAR(static_cast<double>(chords({touch}, 0.01)), 2 * std::numbers::pi / std::sqrt(0.004), 1);
  EXPECT_EQ(chords({touch}, 0.1), 48) << "they turn by 7.5° at most";
}

TEST(arcs, a_point_stays_on_its_chord_where_a_cell_is_too_thin) {
  // A hole: its chords lie in the void, and their middles move into the body.
  const auto sagitta = 1 - std::cos(std::numbers::pi / 48);
  for (const double thickness : {0.5 * sagitta, 2 * sagitta}) {
    Mesh mesh = chord_of_a_hole(thickness);
    const Index middle = 4;
    ASSERT_NEAR(norm(mesh.points[middle]), 1 - sagitta, 1e-12);
    add_face_joints(mesh, {faces("touch", "plate.wall", "pin.rim")});
    EXPECT_TRUE(verify(mesh).empty()) << verify(mesh).front();
    EXPECT_NEAR(norm(mesh.points[middle]), thickness < sagitta ? 1 - sagitta : 1, 1e-12);
  }
}

TEST(arcs, joints_inside_a_body_know_them_too) {
  core::Mistakes mistakes;
  JointLine line;
  line.name = "seam";
  line.between = {"disc", "plate"};
  const auto hole =
      operation(geo::Shape::Kind::difference, {box("", {-2, -2}, {2, 2}).shape, circle({0, 0}, 1)});
  const Domain domain =
      make_domain({region("plate", hole), region("disc", circle({0, 0}, 1, "rim"))}, {line}, 1, mistakes);
  ASSERT_TRUE(mistakes.empty());
  int arcs = 0;
  for (const auto& segment : domain.segments) {
    EXPECT_EQ(segment.arc.has_value(), segment.left >= 0 && segment.right >= 0);
    if (!segment.arc) continue;
    ++arcs;
    EXPECT_EQ(segment.arc->counter_clockwise,
              cross(domain.points[segment.from], domain.points[segment.to]) > 0);
  }
  EXPECT_EQ(arcs, 48);
}

TEST(face_lips, mistakes_of_meshes_from_files) {
  const auto fault = [](Mesh mesh, const JointLine& line) -> std::string {
    mesh.joints.clear();
    try {
      add_face_joints(mesh, {line});
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "none";
  };
  const Mesh mesh = two_blocks(3, 4);
  EXPECT_EQ(fault(mesh, faces("t", "low.top", "up.bottom")), "none");
  EXPECT_TRUE(says(fault(mesh, faces("t", "low.tip", "up.bottom")), "no edges named 'low.tip'"));
  EXPECT_TRUE(says(fault(mesh, faces("t", "low.top", "low.bottom")), "belong to one body"));
  const Mesh whole = as_one_block(3);
  EXPECT_TRUE(says(fault(whole, faces("t", "low.top", "up.bottom")), "not on the border"));
}
