// The loader's own word on which libraries a run opens; see tests/contract for what the program says itself.

#include <gtest/gtest.h>

#include "program.hpp"

namespace ashlar::test {
namespace {

const std::string scene_start = R"(
local rock = material.elastic { E = 10*units.GPa, nu = 0.3, unit_weight = 24e3 }
return Scene {
  title = "A block", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { cells = 200 }, element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  outputs = { pictures = false },
)";

std::string loader_words(const std::string& rest_of_scene) {
  const ScratchFolder folder;
  write(folder / "scene.lua", scene_start + rest_of_scene);
  const Ended ended =
      call("run " + quoted(folder / "scene.lua") + " --quiet", source_folder, "LD_DEBUG=files");
  EXPECT_EQ(ended.code, 0);
  return ended.err;
}

bool has(const std::string& words, const std::string& module) {
  return words.find("/ashlar_" + module + ".so") != std::string::npos;
}

TEST(libraries, only_those_that_the_scene_calls_for_are_opened) {
  const std::string weight = loader_words("stages = { Stage { 'weight', gravity = true } } }");
  for (const char* module : {"contact", "water", "loads", "meshing_gmsh", "meshing_structured"})
    EXPECT_FALSE(has(weight, module)) << module;
  for (const char* module : {"gravity", "elasticity", "suitesparse", "meshing_voronoi"})
    EXPECT_TRUE(has(weight, module)) << module;
  EXPECT_EQ(weight.find("libgmsh"), std::string::npos);
  const std::string all = loader_words(R"(
    joints = { cut = Joint { path = { {4,5}, {6,2} }, friction = "none" } },
    stages = { Stage { "all", gravity = true, water = Water { level = 4, on = { "rock.left" } } } } })");
  for (const char* module : {"contact", "water"}) EXPECT_TRUE(has(all, module)) << module;
}

}  // namespace
}  // namespace ashlar::test
