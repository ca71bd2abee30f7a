// The contract: what a scene does not mention costs no module, no data, no call, and not one bit of the
// result.

#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace {

using program::fs::path;

/// A block under a given traction: no joint, no weight, no water, a structured mesh.
const char* plain_block = R"(
local rock = material.elastic { E = 1e9, nu = 0.25, unit_weight = 24e3 }
return Scene {
  title = "A pressed block", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {2,1}, material = rock } },
  mesh = mesh.structured { size = 0.1 },
  element = "vem",
  supports = { ["block.bottom"] = "xy" },
  stages = { Stage { "press", tractions = { ["block.top"] = { x = 1e4, y = -1e5 } } } },
}
)";

/// The modules as they were built, without one.
void copy_modules_without(const std::string& left_out, const path& to) {
  for (const auto& folder : program::fs::directory_iterator(ASHLAR_BINARY_DIR "/modules"))
    if (program::fs::exists(folder.path() / "module.lua") && folder.path().filename() != left_out)
      program::fs::copy(folder.path(), to / folder.path().filename());
}

std::vector<std::string> effects_in_ledger(const nlohmann::json& json) {
  std::vector<std::string> effects;
  for (const auto& row : json.at("timings")) effects.push_back(row.at("effect"));
  return effects;
}

class Contract : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(Contract, UnmentionedMeansAbsent) {
  const std::string module = GetParam();
  program::Folder folder("contract-" + module);
  program::write(folder / "scene.lua", plain_block);
  const program::Run with = program::run(folder / "scene.lua", folder / "with");
  ASSERT_EQ(with.exit_code, 0) << with.said;

  // Not opened, no time and no data in the ledger, named among what is not simulated.
  const std::vector<std::string> open = with.json.at("modules");
  EXPECT_EQ(std::count(open.begin(), open.end(), module), 0);
  const auto effects = effects_in_ledger(with.json);
  EXPECT_EQ(std::count(effects.begin(), effects.end(), module), 0);
  EXPECT_EQ(with.json.at("effects").at("simulated").at("press").contains(module), false);

  // The same bits as a program that never had the module.
  program::fs::create_directories(folder / "modules");
  copy_modules_without(module, folder / "modules");
  const program::Run without = program::run(folder / "scene.lua", folder / "without", "",
                                            "ASHLAR_MODULES='" + (folder / "modules").string() + "'");
  ASSERT_EQ(without.exit_code, 0) << without.said;
  EXPECT_EQ(with.json.at("stages"), without.json.at("stages"));
  const std::string fields = program::read(with.out / "vtu" / "01_press.vtu");
  EXPECT_GT(fields.size(), 1000u);
  EXPECT_EQ(fields, program::read(without.out / "vtu" / "01_press.vtu"));
}

INSTANTIATE_TEST_SUITE_P(Modules, Contract,
                         testing::Values("contact", "gravity", "water", "meshing_gmsh", "meshing_voronoi"),
                         [](const auto& info) { return info.param; });

TEST(ContractOfEffects, WhatIsCalledIsThere) {
  // The other side of the contract: without it the checks above could pass on a program that does nothing.
  program::Folder folder("contract-called");
  std::string scene = plain_block;
  scene.replace(scene.find("tractions ="), 0, "gravity = true, ");
  program::write(folder / "scene.lua", scene);
  const program::Run run = program::run(folder / "scene.lua", folder / "out");
  ASSERT_EQ(run.exit_code, 0) << run.said;
  const std::vector<std::string> open = run.json.at("modules");
  EXPECT_EQ(std::count(open.begin(), open.end(), "gravity"), 1);
  const auto effects = effects_in_ledger(run.json);
  EXPECT_EQ(std::count(effects.begin(), effects.end(), "gravity"), 1);
  // Weight of 2 m² under 24 kN/m³.
  EXPECT_NEAR(run.json.at("stages")[0].at("balance").at("loads").at("gravity").at("y").get<double>(), -48e3,
              1e-6);
}

TEST(ContractOfEffects, AMissingModuleIsSaid) {
  program::Folder folder("contract-missing");
  std::string scene = plain_block;
  scene.replace(scene.find("tractions ="), 0, "gravity = true, ");
  program::write(folder / "scene.lua", scene);
  program::fs::create_directories(folder / "modules");
  copy_modules_without("gravity", folder / "modules");
  const program::Run run = program::run(folder / "scene.lua", folder / "out", "",
                                        "ASHLAR_MODULES='" + (folder / "modules").string() + "'");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.said.find("gravity"), std::string::npos) << run.said;
  EXPECT_FALSE(program::fs::exists(run.out / "results.h5"));
}
