#pragma once
// Scenarios in Lua, read with every module's real module.lua; no library is opened.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/log.hpp"
#include "model/scene.hpp"
#include "script/script.hpp"

namespace ashlar::test {

/// What a script became: the scene and its mistakes, with the registry that knows all modules' schemas.
struct Scenario {
  core::Registry registry;
  model::Scene scene;
  core::Mistakes mistakes;
  script::ScriptResult script;
  /// All mistakes as one text.
  std::string text() const {
    std::string all;
    for (const core::Mistake& mistake : mistakes.list()) all += core::to_string(mistake) + "\n";
    return all;
  }
};

/// A slab of rock [0, 6] × [0, 3] with a joint from its left side; the arguments are Lua entries of its
/// parts.
inline std::string slab_script(const std::string& joint, const std::string& stage,
                               const std::string& outputs = "") {
  return R"(
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "test", plane = "strain",
  geometry = {
    rock = Polygon { {0,0,"bottom"}, {6,0,"right"}, {6,3,"top"}, {0,3,"left"}, material = rock },
  },
  joints = { fault = Joint { path = { {0,1}, {3,1} }, )" +
         joint + R"( } },
  mesh = mesh.voronoi { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "first", )" +
         stage + R"( } },
  outputs = { )" +
         outputs + R"( },
}
)";
}

inline std::unique_ptr<Scenario> read_scenario(const std::string& text) {
  namespace fs = std::filesystem;
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(::testing::TempDir()) / "ashlar" / test->test_suite_name() / test->name();
  fs::create_directories(folder);
  std::ofstream(folder / "scene.lua") << text;
  auto result = std::make_unique<Scenario>();
  model::register_scene_kinds(result->registry);
  script::read_module_manifests({fs::path(ASHLAR_SOURCE_DIR) / "modules"}, result->registry);
  result->script = script::read_scene(folder / "scene.lua", result->registry, {}, result->mistakes);
  if (result->mistakes.empty())
    result->scene = model::read_scene(result->script.scene, result->registry, result->mistakes);
  return result;
}

}  // namespace ashlar::test
