#include "model/place.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/log.hpp"

namespace ashlar::model {
namespace {

// Two unit squares, one on the other, parted along y = 1: points 2 and 4, 3 and 5 lie together.
mesh::Mesh parted() {
  mesh::Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}, {0, 1}, {1, 2}, {0, 2}};
  mesh.edge_points = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {5, 4}, {4, 6}, {6, 7}, {7, 5}};
  const mesh::LipEdge above{4, 1, 5, 4, 0, 1}, below{2, 0, 3, 2, 0, 1};
  mesh.joints.push_back({"bed", {"upper", "lower"}, {{{above}, {below}}}});
  mesh.edge_groups = {{"bed.upper", {4}}, {"bed.lower", {2}}};
  return mesh;
}

struct Found {
  Index point = -1;
  std::string complaint;
};

Found find(Point at, const std::string& lip = {}) {
  core::Mistakes mistakes;
  Found found;
  found.point = point_at(parted(), {at, lip, {"a.lua", 3, "probe"}}, mistakes);
  for (const core::Mistake& mistake : mistakes.list()) found.complaint += core::to_string(mistake);
  return found;
}

bool warned_of(const std::string& words) {
  return std::ranges::any_of(core::log().lines(),
                             [&](const auto& line) { return line.second.find(words) != std::string::npos; });
}

TEST(place, a_point_is_the_nearest_and_told_where_it_is_off) {
  core::log().clear();
  EXPECT_EQ(find({1, 0.02}).point, 1);
  EXPECT_FALSE(warned_of("is taken"));
  EXPECT_EQ(find({1, 0.3}).point, 1);
  EXPECT_TRUE(warned_of("a.lua:3: probe: the mesh point (1 m, 0 m) is taken, 300 mm from the place"));
}

TEST(place, outside_the_mesh_there_is_none) {
  const Found found = find({4, 0});
  EXPECT_EQ(found.point, -1);
  EXPECT_NE(
      found.complaint.find("(4 m, 0 m) lies outside the mesh: its nearest point (1 m, 0 m) is 3 m away"),
      std::string::npos)
      << found.complaint;
}

TEST(place, on_a_joint_a_lip_must_be_named) {
  const Found open = find({1, 1});
  EXPECT_EQ(open.point, -1);
  EXPECT_NE(open.complaint.find("(1 m, 1 m) lies on a joint, whose sides move apart"), std::string::npos);
  EXPECT_NE(open.complaint.find("bed.upper, bed.lower"), std::string::npos) << open.complaint;
  EXPECT_EQ(find({1, 1}, "bed.upper").point, 4);
  EXPECT_EQ(find({1, 1}, "bed.lower").point, 2);
}

TEST(place, a_lip_that_is_not_there_is_told) {
  const Found found = find({1, 1}, "bed.uper");
  EXPECT_EQ(found.point, -1);
  EXPECT_NE(found.complaint.find("the mesh has no lip 'bed.uper'"), std::string::npos);
  EXPECT_NE(found.complaint.find("bed.upper"), std::string::npos) << found.complaint;
}

}  // namespace
}  // namespace ashlar::model
