#include "mesh/near_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "framework/mesh/two_bodies.hpp"
#include "framework/mesh/zoo.hpp"

namespace ashlar::mesh {
namespace {

constexpr double h = 0.25;

/// The mistakes' texts; empty if there is none.
std::vector<std::string> said_of(const auto& check) {
  std::vector<std::string> texts;
  try {
    check();
  } catch (const core::InputError& error) {
    for (const auto& mistake : error.mistakes()) texts.push_back(core::to_string(mistake));
  }
  return texts;
}

Domain block_with(const std::vector<JointLine>& joints) {
  return zoo_domain({box("block", {0, 0}, {4, 2})}, joints);
}

/// Squares of h, cut by the joints.
std::vector<std::string> on_squares(const std::vector<JointLine>& joints,
                                    const std::vector<double>& y = steps(8, 0, 2)) {
  const Mesh mesh = build_mesh(lattice(steps(16, 0, 4), y), block_with(joints));
  return said_of([&] { require_lines_apart(mesh, joints); });
}

/// By the size asked for.
std::vector<std::string> on_paper(const std::vector<JointLine>& joints) {
  const Domain domain = block_with(joints);
  SizeField sizes(domain, h, 0.3);
  sizes.prepare();
  return said_of([&] { require_lines_apart(domain, sizes); });
}

void expect_one(const std::vector<std::string>& said, const std::vector<std::string>& words) {
  ASSERT_EQ(said.size(), 1u);
  for (const auto& word : words) EXPECT_NE(said[0].find(word), std::string::npos) << word << "\n" << said[0];
}

std::vector<JointLine> parallel(double apart) {
  return {joint("low", {{1, 1}, {3, 1}}), joint("high", {{1, 1 + apart}, {3, 1 + apart}})};
}

std::vector<JointLine> meeting(double degrees, bool one) {
  const double angle = degrees * std::numbers::pi / 180;
  const Point tip{1 + 0.9 * std::cos(angle), 1 + 0.9 * std::sin(angle)};
  if (one) return {joint("bent", {{3, 1}, {1, 1}, tip})};
  return {joint("low", {{1, 1}, {3, 1}}), joint("high", {{1, 1}, tip})};
}

TEST(near_lines, joints_side_by_side_need_a_tenth_of_an_edge) {
  for (const double part : {1e-6, 1e-3, 0.0999})
    expect_one(on_squares(parallel(part * h)), {"joints 'low' and 'high' are ", " apart around (1, 1",
                                                "edges of 250 mm", "smaller cells there, of at most "});
  for (const double part : {0.1001, 0.5, 1.0, 1.3}) EXPECT_TRUE(on_squares(parallel(part * h)).empty());
  expect_one(on_squares(parallel(0.01)), {"are 10 mm apart", "of at most 100 mm"});
}

TEST(near_lines, and_a_fiftieth_of_a_size_that_follows_them) {
  expect_one(on_paper(parallel(0.0199 * h)), {"joints 'low' and 'high' are ", "size asked for is 250 mm"});
  for (const double part : {0.0201, 0.1, 1.0}) EXPECT_TRUE(on_paper(parallel(part * h)).empty());
}

TEST(near_lines, the_cure_for_cells_is_one) {
  const auto thin = on_squares(parallel(0.02));
  expect_one(thin, {"of at most 200 mm"});
  EXPECT_TRUE(said_of([&] {
                const auto joints = parallel(0.02);
                require_lines_apart(build_mesh(lattice(steps(20, 0, 4), steps(10, 0, 2)), block_with(joints)),
                                    joints);
              }).empty());
}

TEST(near_lines, two_rows_of_thin_cells_are_the_users_wish) {
  const std::vector<double> two{0, 0.5, 1, 1.005, 1.01, 1.5, 2}, one{0, 0.5, 1, 1.01, 1.5, 2};
  EXPECT_TRUE(on_squares(parallel(0.01), two).empty());
  EXPECT_EQ(on_squares(parallel(0.01), one).size(), 1u);
}

TEST(near_lines, joints_meet_at_angles_down_to_three_degrees) {
  for (const bool one : {false, true}) {
    for (const double degrees : {3.1, 10.0, 45.0, 90.0, 150.0})
      EXPECT_TRUE(on_squares(meeting(degrees, one)).empty()) << degrees;
    for (const double degrees : {2.8, 1.0, 0.01})
      expect_one(on_squares(meeting(degrees, one)),
                 {"around (1.5, 1.", "meet at no less than 2.9°",
                  one ? "joint 'bent' comes within " : "joints 'low' and"});
    for (const double degrees : {0.7, 10.0}) EXPECT_TRUE(on_paper(meeting(degrees, one)).empty()) << degrees;
    expect_one(on_paper(meeting(0.4, one)), {"meet at no less than 0.6°"});
  }
}

TEST(near_lines, crossings_ends_on_other_joints_and_borders_are_legal) {
  const std::vector<JointLine> joints{
      joint("level", {{0, 0.87}, {4, 0.87}}), joint("steep", {{1.1, 0}, {1.3, 2}}),
      joint("end", {{2.5, 1.7}, {2.4, 0.87}}), joint("corner", {{4, 2}, {3.1, 1.3}})};
  EXPECT_TRUE(on_squares(joints).empty());
  EXPECT_TRUE(on_paper(joints).empty());
}

TEST(near_lines, a_joint_that_stops_just_before_another_line) {
  const auto stops = [](double y) {
    return std::vector{joint("level", {{1, 1}, {3, 1}}), joint("stops", {{2, 1.7}, {2, 1 + y}})};
  };
  expect_one(on_squares(stops(1e-3)), {"'level' and 'stops'", "are 1 mm apart around (2, 1.001)", "end on"});
  expect_one(on_paper(stops(1e-3)), {"'stops'", "are 1 mm apart around (2, 1.001)"});
  EXPECT_TRUE(on_squares(stops(0.03)).empty());
  const std::vector<JointLine> under{joint("under", {{1, 1.999}, {3, 1.999}})};
  expect_one(on_squares(under), {"joint 'under' and edge 'block.top' are 1 mm apart", "or move the joint"});
  expect_one(on_paper(under), {"joint 'under' and edge 'block.top' are 1 mm apart"});
}

TEST(near_lines, a_joint_beside_the_border_of_regions) {
  const std::vector<RegionShape> regions{box("low", {0, 0}, {4, 1}), box("high", {0, 1}, {4, 2})};
  const std::vector<JointLine> joints{joint("crack", {{1, 1.001}, {3, 1.001}})};
  RawMesh raw = lattice(steps(16, 0, 4), steps(8, 0, 2));
  for (std::size_t c = 64; c < 128; ++c) raw.cell_region[c] = 1;
  const Mesh mesh = build_mesh(raw, zoo_domain(regions, joints));
  expect_one(said_of([&] { require_lines_apart(mesh, joints); }), {"joint 'crack' and edge '", "1 mm apart"});
}

TEST(near_lines, thin_layers_are_no_matter_of_joints) {
  const std::vector<RegionShape> regions{box("low", {0, 0}, {4, 1}), box("seam", {0, 1}, {4, 1.005}),
                                         box("high", {0, 1.005}, {4, 2})};
  const std::vector<JointLine> joints{joint("crack", {{1, 0.5}, {3, 0.5}})};
  RawMesh raw = lattice(steps(16, 0, 4), {0, 0.5, 1, 1.005, 2});
  for (std::size_t c = 32; c < 64; ++c) raw.cell_region[c] = c < 48 ? 1 : 2;
  const Domain domain = zoo_domain(regions, joints);
  const Mesh mesh = build_mesh(raw, domain);
  EXPECT_TRUE(said_of([&] { require_lines_apart(mesh, joints); }).empty());
  SizeField sizes(domain, h, 0.3);
  sizes.prepare();
  EXPECT_TRUE(said_of([&] { require_lines_apart(domain, sizes); }).empty());
}

TEST(near_lines, joints_on_both_faces_of_a_plate) {
  const auto plate = [](double thick) {
    const auto part = [](const std::string& name, std::vector<double> y) {
      return build_mesh(lattice(steps(16, 0, 4), y), alone(box(name, {0, y.front()}, {4, y.back()})));
    };
    std::vector<Mesh> parts;
    parts.push_back(part("low", steps(4)));
    parts.push_back(part("plate", {1, 1 + thick}));
    parts.push_back(part("up", steps(4, 1 + thick, 2)));
    Mesh mesh = merge(std::move(parts), {"low", "plate", "up"});
    const std::vector<JointLine> joints{faces("under", "low.top", "plate.bottom"),
                                        faces("over", "plate.top", "up.bottom")};
    add_face_joints(mesh, joints);
    return said_of([&] { require_lines_apart(mesh, joints); });
  };
  expect_one(plate(0.02), {"joints 'under' and 'over' are 20 mm apart"});
  EXPECT_TRUE(plate(0.026).empty());
}

TEST(near_lines, each_two_lines_are_named_once_and_all_of_them) {
  const std::vector<JointLine> joints{joint("a", {{1, 1}, {3, 1}}), joint("b", {{1, 1.001}, {3, 1.001}}),
                                      joint("c", {{1, 1.002}, {3, 1.002}})};
  EXPECT_EQ(on_squares(joints).size(), 2u);
}

}  // namespace
}  // namespace ashlar::mesh
