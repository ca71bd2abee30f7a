// What a scene does not mention is not there: no library opened for it, and the same bits with the module
// deleted.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
  outputs = { probes = { top = { at = {3,5} } }, pictures = false },
)";
const std::string weight_only = scene_start + R"(stages = { Stage { "weight", gravity = true } } })";
const std::string with_all = scene_start + R"(
  joints = { cut = Joint { path = { {4,5}, {6,2} }, friction = "none" } },
  stages = { Stage { "all", gravity = true, water = Water { level = 4, on = { "rock.left" } } } } })";

/// Libraries of modules that the loader opened for `ashlar run`.
std::string opened(const std::string& scene) {
  const ScratchFolder folder;
  std::ofstream(folder / "scene.lua") << scene;
  const Ended ended =
      call("run " + quoted(folder / "scene.lua") + " --quiet", source_folder, "LD_DEBUG=files");
  EXPECT_EQ(ended.code, 0);
  return ended.err;
}

bool has(const std::string& loader, const std::string& module) {
  return loader.find("/ashlar_" + module + ".so") != std::string::npos;
}

TEST(contract, no_library_is_opened_that_the_scene_does_not_call_for) {
  const std::string weight = opened(weight_only);
  for (const char* module : {"contact", "water", "loads", "meshing_gmsh", "meshing_structured"})
    EXPECT_FALSE(has(weight, module)) << module;
  for (const char* module : {"gravity", "elasticity", "suitesparse", "meshing_voronoi"})
    EXPECT_TRUE(has(weight, module)) << module;
  EXPECT_EQ(weight.find("libgmsh"), std::string::npos);
  const std::string all = opened(with_all);
  for (const char* module : {"contact", "water"}) EXPECT_TRUE(has(all, module)) << module;
}

/// The stages' results with the modules in `modules` (empty: all).
std::string results(const ScratchFolder& folder, const std::string& environment) {
  const Ended ended = call("run " + quoted(folder / "scene.lua") + " --quiet --out " +
                               quoted(folder / "results") + " --json " + quoted(folder / "r.json"),
                           source_folder, environment);
  EXPECT_EQ(ended.code, 0) << ended.err;
  return nlohmann::json::parse(text_of(folder / "r.json")).at("stages").dump();
}

TEST(contract, deleting_a_module_that_is_not_called_for_changes_no_bit) {
  const ScratchFolder folder;
  std::ofstream(folder / "scene.lua") << weight_only;
  fs::create_directory(folder / "modules");
  for (const auto& module : fs::directory_iterator(fs::path(ASHLAR_PROGRAM).parent_path() / "modules")) {
    const std::string name = module.path().filename().string();
    if (name != "contact" && name != "water" && name != "loads" && name != "meshing_gmsh")
      fs::create_directory_symlink(module.path(), folder / ("modules/" + name));
  }
  const std::string few = "ASHLAR_MODULES=" + quoted(folder / "modules");
  EXPECT_EQ(results(folder, few), results(folder, ""));
  std::ofstream(folder / "scene.lua") << with_all;
  const Ended ended = call("check " + quoted(folder / "scene.lua"), source_folder, few);
  EXPECT_EQ(ended.code, 2) << "the modules are really gone";
}

TEST(contract, results_do_not_depend_on_the_number_of_threads) {
  const ScratchFolder folder;
  std::ofstream(folder / "scene.lua") << with_all;
  const auto with = [&](int threads) {
    const std::string text = "run " + quoted(folder / "scene.lua") + " --quiet --threads " +
                             std::to_string(threads) + " --out " + quoted(folder / "results") + " --json " +
                             quoted(folder / "r.json");
    EXPECT_EQ(call(text).code, 0);
    return nlohmann::json::parse(text_of(folder / "r.json")).at("stages").dump();
  };
  const std::string one = with(1);
  EXPECT_EQ(one, with(2));
  EXPECT_EQ(one, with(7));
}

}  // namespace
}  // namespace ashlar::test
