// Bodies that are meshed apart, through the whole program.

#include <gtest/gtest.h>

#include "program.hpp"

namespace ashlar::test {
namespace {

const char* const two_bodies = R"(
local rock = material.elastic { E = 10*units.GPa, nu = 0.3, unit_weight = 24e3 }
return Scene {
  title = "A drum on a block", plane = "strain",
  geometry = {
    drum  = Disk { center = {3,4}, radius = 2, material = rock },
    block = Rectangle { from = {0,0}, to = {6,2}, material = rock },
  },
  joints = { touch = Joint { faces = {"drum.rim", "block.top"}, friction = "none" } },
  mesh = mesh.voronoi { cells = 150, refine = { { joint = "touch", size = 0.3, radius = 0.1 } } }, element = "vem",
  supports = { ["block.bottom"] = "xy", pin = Support { at = {3,4}, ux = 0, uy = -0.001 },
               upright = Support { at = {3,6}, ux = 0 } },
  stages = { Stage { "press" } },
  outputs = { pictures = { "mesh" }, probes = { top = Probe { at = {3,6} } },
              sections = { foot = Section { {0,1}, {6,1} } } },
}
)";

// Two squares, one upon the other, with points of their own.
const char* const two_squares = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
5
1 1 "low.top"
1 2 "seat"
1 5 "foot"
2 3 "low"
2 4 "up"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 -0.25 1 0
6 1.25 1 0
7 1.25 2 0
8 -0.25 2 0
$EndNodes
$Elements
5
1 1 2 1 1 3 4
2 1 2 2 1 5 6
3 1 2 5 1 1 2
4 3 2 3 1 1 2 3 4
5 3 2 4 2 5 6 7 8
$EndElements
)";

TEST(apart, a_drum_on_a_block_is_checked_meshed_and_drawn) {
  const ScratchFolder scratch;
  write(scratch / "scene.lua", two_bodies);
  EXPECT_EQ(call("check scene.lua", scratch.path()).code, 0);
  const Ran ran = run(scratch / "scene.lua", scratch / "results");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.json["mesh"]["cells"], 150) << "a wished number is that of both bodies";
  EXPECT_TRUE(fs::exists(ran.folder / "mesh.png"));
  EXPECT_TRUE(fs::exists(ran.folder / "joint_touch.csv"));
}

TEST(apart, what_a_body_by_itself_cannot_be_meshed_with_names_it) {
  const ScratchFolder scratch;
  std::string scene = two_bodies;
  scene.replace(scene.find("150"), 3, "60");
  write(scratch / "scene.lua", scene);
  const Ran ran = run(scratch / "scene.lua", scratch / "results");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("scene.lua:10: mesh.cells: 'drum', meshed by itself: "), std::string::npos)
      << ran.err;
}

TEST(apart, bodies_of_a_mesh_file_meet_by_its_groups) {
  const ScratchFolder scratch;
  write(scratch / "two.msh", two_squares);
  const auto scene = [](const std::string& faces) {
    return R"(local rock = material.elastic { E = 1e9, nu = 0.3, unit_weight = 24e3 }
return Scene {
  title = "Two squares", plane = "strain",
  geometry = { low = MeshGroup { material = rock }, up = MeshGroup { material = rock } },
  joints = { touch = Joint { faces = )" +
           faces + R"(, friction = "none" } },
  mesh = mesh.file { path = "two.msh" }, element = "vem",
  supports = { foot = "xy", side = Support { box = { {-1,1.5}, {0,2} }, fix = "x" } },
  stages = { Stage { "weight", gravity = true } },
  outputs = { pictures = false },
})";
  };
  write(scratch / "scene.lua", scene(R"({"low.top", "seat"})"));
  const Ran ran = run(scratch / "scene.lua", scratch / "results");
  EXPECT_EQ(ran.code, 0) << ran.err;
  write(scratch / "wrong.lua", scene(R"({"low.top", "foot"})"));
  const Ran wrong = run(scratch / "wrong.lua", scratch / "results");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(
      wrong.err.find("wrong.lua:5: joints.touch: joint 'touch': 'low.top' and 'foot' belong to one body"),
      std::string::npos)
      << wrong.err;
}

TEST(apart, describe_shows_faces) {
  EXPECT_NE(call("describe Joint").out.find("faces"), std::string::npos);
}

}  // namespace
}  // namespace ashlar::test
