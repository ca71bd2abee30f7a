// `ashlar drive`: numbers against the closed form, files, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "app/drive_support.hpp"

namespace ashlar::test {
namespace {

const fs::path uniaxial = source_folder / "modules/elasticity/materials/mohr_coulomb/uniaxial.lua";

std::vector<std::map<std::string, double>> rows_of(const fs::path& csv) {
  std::istringstream lines(read(csv));
  std::string line;
  std::getline(lines, line);
  const auto names = cells(line);
  std::vector<std::map<std::string, double>> rows;
  while (std::getline(lines, line)) {
    const auto values = cells(line);
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = std::stod(values.at(i));
  }
  return rows;
}

TEST(drive, uniaxial_strength_is_that_of_the_closed_form) {
  const ScratchFolder folder;
  const Ended ended = call("drive " + quoted(uniaxial) + " --out " + quoted(folder / "out"));
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("syy [MPa]"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("-3.464"), std::string::npos) << ended.out;
  for (const char* name : {"drive.csv", "drive.png", "drive.svg"})
    EXPECT_GT(fs::file_size(folder / "out" / name), 500u) << name;
  const double strength = 2e6 * std::cos(M_PI / 6) / (1 - 0.5);
  const auto rows = rows_of(folder / "out/drive.csv");
  ASSERT_EQ(rows.size(), 81u);
  for (const auto& row : rows) {
    if (row.at("leg") == 1) {
      EXPECT_NEAR(row.at("syy [Pa]"), std::max(10e9 * row.at("yy"), -strength), 1e-6 * strength);
    }
    EXPECT_NEAR(row.at("sxx [Pa]"), 0, 1);
    EXPECT_NEAR(row.at("szz [Pa]"), 0, 1);
  }
  EXPECT_NEAR(rows.back().at("syy [Pa]"), 0.5e6, 1);
  EXPECT_NEAR(rows.back().at("s1 [Pa]"), 0.5e6, 1);
}

const std::string law = "material.drucker_prager { E=1e10, nu=0.2, cohesion=1e6, friction=0.5, dilation=0 }";

TEST(drive, a_function_leads_strains_and_set_changes_parameters) {
  const ScratchFolder folder;
  write(folder / "law.lua",
        "local most = param { \"most\", default = 1e-3 }\nreturn Drive { material = " + law +
            ", plane = \"strain\", steps = 10, path = function(t) return 0, 0, most*t end }");
  ASSERT_EQ(call("drive law.lua --quiet --set most=2e-3", folder / "").code, 0);
  const auto rows = rows_of(folder / "law_drive/drive.csv");
  ASSERT_EQ(rows.size(), 11u);
  EXPECT_DOUBLE_EQ(rows.back().at("xy"), 2e-3);
}

TEST(drive, a_stress_beyond_the_strength_is_not_converged_and_keeps_what_was_reached) {
  const ScratchFolder folder;
  write(folder / "law.lua", "return Drive { material = " + law +
                                ", plane = \"strain\", path = { { syy = -1e9, sxx = 0, szz = 0 } } }");
  const Ended ended = call("drive law.lua --quiet", folder / "");
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_NE(ended.err.find("finds no strain for the stress asked for"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(folder / "law_drive/drive.csv"));
}

TEST(drive, mistakes_are_told_all_at_once_with_their_places) {
  expect_refused(
      "local u = units\nreturn Drive {\n  material = material.mohr_coulomb { E = 1*u.GPa, nu = 0.5,\n"
      "    cohesion = -1, friction = 30, dilation = 0 },\n  plane = \"stress\", stps = 3,\n"
      "  path = { { yy = -1e-3, syy = 0 },\n    {},\n    { zz = 1, sxx = 2*u.m } },\n}",
      {"law.lua:4: material.cohesion: must be at least 0 Pa", "law.lua:5: stps: unknown key",
       "law.lua:6: path[1].yy: yy and syy are both said", "law.lua:7: path[2]: leads nowhere",
       "law.lua:8: path[3].zz: plane stress leaves nothing", "law.lua:8: path[3].sxx"});
  expect_refused(
      "return Drive {\n  material = material.mohr_coulomb { E = 1e9, nu = 0.2, cohesion = 1e5,\n"
      "    friction = 30, dilation = 0 },\n  plane = \"strain\", path = {} }",
      {"law.lua:3: material.friction: must be from 0° to below 90°", "write 30*units.deg",
       "law.lua:4: path: the path has no legs"});
  expect_refused(
      "return Drive { material = " + law + ", plane = \"strain\",\n path = function(t) return t, 0 end }",
      {"law.lua:2: path: the path's function must return the strains xx, yy, xy"});
  expect_refused("return Drive { material = " + law +
                     ", plane = \"strain\",\n path = function(t) return t, 0, 0/0 end }",
                 {"law.lua:2: path: the function, called with (0.02), returns"});
  expect_refused(
      "return Drive { material = material.drucker_prager { E=1e10, nu=0.2, cohesion=1e6, friction=0.5,\n"
      "  dilation=0, match = \"outr\", density = -1 }, plane = \"strain\", path = { { yy = 1 } } }",
      {"law.lua:2: material.match", "did you mean 'outer'?", "law.lua:2: material.density: must be"});
  expect_refused("return { }", {"must return Drive { … }, but returns a table"});
}

TEST(drive, verbs_tell_each_others_scripts_apart) {
  const Ended ran = call("run " + quoted(uniaxial));
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("it leads a law"), std::string::npos) << ran.err;
  const Ended driven = call("drive examples/cantilever/scene.lua");
  EXPECT_EQ(driven.code, 2);
  EXPECT_NE(driven.err.find("it is a scene"), std::string::npos) << driven.err;
  EXPECT_NE(call("--help").out.find("ashlar drive FILE"), std::string::npos);
  EXPECT_NE(call("describe Drive").out.find("path:"), std::string::npos);
  EXPECT_NE(call("describe leg").out.find("szz"), std::string::npos);
}

}  // namespace
}  // namespace ashlar::test
