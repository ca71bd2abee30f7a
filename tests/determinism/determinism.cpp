// One hash for any thread count and from run to run.

#include <gtest/gtest.h>

#include "program.hpp"

namespace ashlar::test {
namespace {

/// Voronoi cells, a joint in contact, weight and water: everything that could depend on the order of threads.
const char* jointed_block = R"(
local rock = material.elastic { E = 1e10, nu = 0.3, unit_weight = 24e3 }
return Scene {
  title = "Two blocks with a joint", plane = "strain",
  geometry = { rock = Polygon { {0,0,"bottom"}, {25,0,"right"}, {25,10,"ground"}, {0,10,"left"}, material = rock } },
  joints = { fault = Joint { path = { {4,10}, {10,4} }, friction = "none", enforce = contact.penalty { factor = 100 } } },
  mesh = mesh.voronoi { cells = 6000, seed = 3 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy", ["rock.left"] = "x", ["rock.right"] = "x" },
  stages = {
    Stage { "weight", gravity = true },
    Stage { "water", water = Water { level = 12, on = { "rock.ground" } } },
  },
}
)";

}  // namespace

TEST(Determinism, SameBitsForAnyThreadCount) {
  const ScratchFolder folder;
  write(folder / "scene.lua", jointed_block);
  const Ran one = run(folder / "scene.lua", folder / "one", "--threads 1");
  ASSERT_EQ(one.code, 0) << one.err;
  for (const char* threads : {"1", "2", "3", "7"}) {
    const Ran other =
        run(folder / "scene.lua", folder / (std::string("t") + threads), std::string("--threads ") + threads);
    ASSERT_EQ(other.code, 0) << other.err;
    EXPECT_EQ(one.json.at("stages"), other.json.at("stages")) << threads << " threads";
    for (const char* file :
         {"vtu/01_weight.vtu", "vtu/02_water.vtu", "vtu/02_water_joints.vtu", "joint_fault.csv"}) {
      const std::string bytes = read(one.folder / file);
      EXPECT_GT(bytes.size(), 100u) << file;
      EXPECT_EQ(bytes, read(other.folder / file)) << file << " with " << threads << " threads";
    }
  }
}

}  // namespace ashlar::test
