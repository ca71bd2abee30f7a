// The contract: what a scene does not mention costs no module, no data, no call, and not one bit of the
// result.

#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace ashlar::test {
namespace {

/// A block on a structured mesh, no joint, no water; what acts on it is up to the caller.
std::string block_under(const std::string& loads) {
  return R"(
local rock = material.elastic { E = 1e9, nu = 0.25, unit_weight = 24e3 }
return Scene {
  title = "A pressed block", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {2,1}, material = rock } },
  mesh = mesh.structured { size = 0.1 },
  element = "vem",
  supports = { ["block.bottom"] = "xy" },
  stages = { Stage { "only", )" +
         loads + " } },\n}\n";
}

const std::string traction = R"(tractions = { ["block.top"] = { x = 1e4, y = -1e5 } })";
const std::string weight = "gravity = true";

/// The modules as they were built, without one.
void copy_modules_without(const std::string& left_out, const fs::path& to) {
  for (const auto& folder : fs::directory_iterator(ASHLAR_BINARY_DIR "/modules"))
    if (fs::exists(folder.path() / "module.lua") && folder.path().filename() != left_out)
      fs::copy(folder.path(), to / folder.path().filename());
}

std::vector<std::string> effects_in_ledger(const nlohmann::json& json) {
  std::vector<std::string> effects;
  for (const auto& row : json.at("timings")) effects.push_back(row.at("effect"));
  return effects;
}

struct Unmentioned {
  std::string module;
  std::string loads;  ///< that do not need it
};

class Contract : public testing::TestWithParam<Unmentioned> {};

}  // namespace

TEST_P(Contract, UnmentionedMeansAbsent) {
  const std::string module = GetParam().module;
  const ScratchFolder folder;
  write(folder / "scene.lua", block_under(GetParam().loads));
  const Ran with = run(folder / "scene.lua", folder / "with");
  ASSERT_EQ(with.code, 0) << with.err;

  // Not opened, no time and no data in the ledger, named among what is not simulated.
  const std::vector<std::string> open = with.json.at("modules");
  EXPECT_EQ(std::count(open.begin(), open.end(), module), 0);
  const auto effects = effects_in_ledger(with.json);
  EXPECT_EQ(std::count(effects.begin(), effects.end(), module), 0);
  EXPECT_FALSE(with.json.at("effects").at("simulated").at("only").contains(module));
  EXPECT_EQ(with.json.at("effects").at("left_out").contains(module), !module.starts_with("meshing_"));

  // The same bits as a program that never had the module.
  fs::create_directories(folder / "modules");
  copy_modules_without(module, folder / "modules");
  const Ran without = run(folder / "scene.lua", folder / "without", "",
                          "ASHLAR_MODULES='" + (folder / "modules").string() + "'");
  ASSERT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(with.json.at("stages"), without.json.at("stages"));
  const std::string fields = read(with.folder / "vtu" / "01_only.vtu");
  EXPECT_GT(fields.size(), 1000u);
  EXPECT_EQ(fields, read(without.folder / "vtu" / "01_only.vtu"));
}

INSTANTIATE_TEST_SUITE_P(Modules, Contract,
                         testing::ValuesIn(std::vector<Unmentioned>{{"contact", traction},
                                                                    {"gravity", traction},
                                                                    {"water", traction},
                                                                    {"loads", weight},
                                                                    {"meshing_file", traction},
                                                                    {"meshing_gmsh", traction},
                                                                    {"meshing_voronoi", traction}}),
                         [](const auto& info) { return info.param.module; });

TEST(ContractOfEffects, WhatIsCalledIsThere) {
  // The other side of the contract: without it the checks above could pass on a program that does nothing.
  const ScratchFolder folder;
  write(folder / "scene.lua", block_under(weight + ", " + traction));
  const Ran ran = run(folder / "scene.lua", folder / "out");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::vector<std::string> open = ran.json.at("modules");
  EXPECT_EQ(std::count(open.begin(), open.end(), "gravity"), 1);
  const auto effects = effects_in_ledger(ran.json);
  EXPECT_EQ(std::count(effects.begin(), effects.end(), "gravity"), 1);
  // Weight of 2 m² under 24 kN/m³.
  EXPECT_NEAR(ran.json.at("stages")[0].at("balance").at("loads").at("gravity").at("y").get<double>(), -48e3,
              1e-6);
}

TEST(ContractOfEffects, AMissingModuleIsSaid) {
  const ScratchFolder folder;
  write(folder / "scene.lua", block_under(weight + ", " + traction));
  fs::create_directories(folder / "modules");
  copy_modules_without("gravity", folder / "modules");
  const Ran ran =
      run(folder / "scene.lua", folder / "out", "", "ASHLAR_MODULES='" + (folder / "modules").string() + "'");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("gravity"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(ran.folder / "results.h5"));
}

}  // namespace ashlar::test
