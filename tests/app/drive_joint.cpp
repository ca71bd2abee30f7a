// `ashlar drive` for the laws of joints: numbers by hand, files, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "app/drive_support.hpp"

namespace ashlar::test {
namespace {

struct Row {
  std::map<std::string, double> numbers;
  std::string status;
  double operator[](const std::string& name) const { return numbers.at(name); }
};

std::vector<Row> rows_of(const fs::path& csv) {
  std::istringstream lines(read(csv));
  std::string line;
  std::getline(lines, line);
  const auto names = cells(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const auto values = cells(line);
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == "status")
        row.status = values.at(i);
      else
        row.numbers[names[i]] = std::stod(values.at(i));
  }
  return rows;
}

/// Drives a joint of these laws along this path, one row a step.
std::vector<Row> driven(const std::string& joint, const std::string& path, int steps = 10, int code = 0) {
  const ScratchFolder folder;
  write(folder / "law.lua", "local u = units\nreturn Drive { joint = { " + joint +
                                " }, steps = " + std::to_string(steps) + ",\n path = { " + path + " } }");
  const Ended ended = call("drive law.lua --quiet", folder / "");
  EXPECT_EQ(ended.code, code) << ended.err;
  return fs::exists(folder / "law_drive") ? rows_of(folder / "law_drive/drive.csv") : std::vector<Row>();
}

const std::string coulomb = "friction = contact.coulomb { friction_angle = 30*u.deg, cohesion = 0.1*u.MPa }";

TEST(drive_joint, direct_shear_follows_the_law) {
  const fs::path script = source_folder / "modules/contact/friction/coulomb/direct_shear.lua";
  const ScratchFolder folder;
  const Ended ended = call("drive " + quoted(script) + " --out " + quoted(folder / "out"));
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("shear [MPa]"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("0.5774"), std::string::npos) << ended.out;
  for (const char* name : {"drive.csv", "drive.png", "drive.svg"})
    EXPECT_GT(fs::file_size(folder / "out" / name), 500u) << name;
  const double peak = std::tan(35 * M_PI / 180), residual = std::tan(M_PI / 6), k = 2e9;
  const auto rows = rows_of(folder / "out/drive.csv");
  ASSERT_EQ(rows.size(), 161u);
  for (const Row& row : rows) {
    if (row["leg"] == 1) {
      EXPECT_NEAR(row["opening [m]"], -row["pressure [Pa]"] / 20e9, 1e-14);
    }
    if (row["leg"] == 2) {
      // Elastic up to the peak; then τ = f(γ) with s = γ + τ/k, and f falls by `slope` to the residual value.
      const double slip = row["slip [m]"], slope = (0.2e6 + (peak - residual) * 1e6) / 4e-3;
      const double softened = (0.2e6 + peak * 1e6 - slope * slip) / (1 - slope / k);
      const double shear = std::min(k * slip, std::max(softened, residual * 1e6));
      EXPECT_NEAR(row["shear [Pa]"], shear, 0.1) << slip;
      const double path = slip - shear / k;
      const double dilation = std::tan(5 * M_PI / 180) * 10e-3 * (1 - std::exp(-path / 10e-3));
      EXPECT_NEAR(row["dilation [m]"], dilation, 1e-12) << slip;
      EXPECT_NEAR(row["opening [m]"], dilation - 1e6 / 20e9, 1e-12) << slip;
      EXPECT_EQ(row["pressure [Pa]"], 1e6);
    }
    if (row["leg"] == 3 && row["slip [m]"] < 9e-3) {
      EXPECT_NEAR(row["shear [Pa]"], -residual * 1e6, 0.1);
    }
  }
  EXPECT_EQ(rows.back().status, "open");
  EXPECT_EQ(rows.back()["pressure [Pa]"], 0);
  EXPECT_EQ(rows.back()["opening [m]"], 2e-3);
}

TEST(drive_joint, rigid_lips_stay_closed_and_part_without_a_pull) {
  const auto rows =
      driven(coulomb, "{ pressure = 1*u.MPa }, { shear = 0.5*u.MPa }, { opening = 1*u.mm, slip = 2*u.mm }");
  EXPECT_EQ(rows[20]["opening [m]"], 0);
  EXPECT_EQ(rows[20]["shear [Pa]"], 5e5);
  EXPECT_NEAR(rows[20]["slip [m]"], 0, 1e-15);
  EXPECT_EQ(rows[20].status, "stick");
  for (int i = 21; i <= 30; ++i) {
    EXPECT_EQ(rows[i].status, "open");
    EXPECT_EQ(rows[i]["pressure [Pa]"], 0);
  }
}

TEST(drive_joint, the_shear_that_barton_and_bandis_give) {
  const auto rows =
      driven("friction = contact.barton_bandis { JRC = 10, JCS = 100*u.MPa, residual_angle = 30*u.deg }",
             "{ pressure = 1*u.MPa }, { slip = 1*u.mm }, { pressure = 10*u.MPa }, { slip = -1*u.mm }");
  EXPECT_NEAR(rows[20]["shear [Pa]"], 1.192e6, 5e2);
  EXPECT_NEAR(rows[30]["shear [Pa]"], 1.192e6, 5e2);  // pressed harder it sticks as it is
  EXPECT_NEAR(rows[40]["shear [Pa]"], -10e6 * std::tan(40 * M_PI / 180), 1);
}

TEST(drive_joint, a_cohesive_joint_tears_unloads_and_presses_again) {
  const auto rows = driven(
      "normal_law = contact.cohesive { stiffness = 100*u.GPa/u.m, tensile_strength = 1*u.MPa,\n"
      "  fracture_energy = 100*u.N/u.m }, friction = \"none\"",
      "{ opening = 105e-6*u.m }, { opening = 52.5e-6*u.m }, { opening = 250e-6*u.m }, { pressure = 2*u.MPa "
      "}");
  ASSERT_EQ(rows.size(), 41u);
  EXPECT_NEAR(rows[10]["pressure [Pa]"], -5e5, 1e-3);
  EXPECT_NEAR(rows[20]["pressure [Pa]"], -2.5e5, 1e-3);
  EXPECT_EQ(rows[30].status, "open");
  EXPECT_NEAR(rows[40]["opening [m]"], -2e-5, 1e-15);
  EXPECT_NEAR(rows[40]["greatest_opening"], 250e-6, 1e-15);
}

TEST(drive_joint, a_bond_breaks_once) {
  const auto rows = driven(
      "normal_law = contact.tension_cut_off { tensile_strength = 0.1*u.MPa }, " + coulomb,
      "{ pressure = -0.09*u.MPa }, { opening = 1*u.mm }, { pressure = 1*u.MPa }, { pressure = -0.01*u.MPa }",
      10, 3);
  ASSERT_GE(rows.size(), 40u);
  EXPECT_EQ(rows[10]["pressure [Pa]"], -9e4);
  EXPECT_EQ(rows[10]["broken"], 0);
  EXPECT_EQ(rows[20]["broken"], 1);
  EXPECT_EQ(rows[30]["pressure [Pa]"], 1e6);
  EXPECT_GE(rows.back()["pressure [Pa]"], 0);
}

TEST(drive_joint, a_function_leads_opening_and_slip) {
  const ScratchFolder folder;
  write(folder / "law.lua",
        "local u = units\nreturn Drive { steps = 4, joint = { normal_law = contact.linear { stiffness = "
        "1e10 }, " +
            coulomb + " },\n path = function(t) return -1e-4*t, 1e-3*t*t end }");
  ASSERT_EQ(call("drive law.lua --quiet", folder / "").code, 0);
  const auto rows = rows_of(folder / "law_drive/drive.csv");
  ASSERT_EQ(rows.size(), 5u);
  for (const Row& row : rows) {
    EXPECT_NEAR(row["pressure [Pa]"], 1e10 * 1e-4 * row["step"] / 4, 1e-6);
    if (row["step"] > 0) {
      EXPECT_NEAR(row["shear [Pa]"], 1e5 + row["pressure [Pa]"] * std::tan(M_PI / 6), 1e-3);
    }
  }
}

TEST(drive_joint, laws_of_the_script_give_what_the_modules_give) {
  const std::string path = "{ pressure = 1*u.MPa }, { slip = 2*u.mm }, { pressure = 0.3*u.MPa }";
  const auto ours = driven("normal_law = contact.linear { stiffness = 1e10 }, " + coulomb, path);
  const auto script = driven(
      "normal_law = contact.lua_normal { pressure = function(o, p) return -p.k*o end, parameters = { k = "
      "1e10*u.Pa/u.m } },\n friction = contact.lua_friction { strength = function(pressure, path, p)\n"
      "  return p.c + p.mu*pressure end, parameters = { c = 1e5, mu = math.tan(math.pi/6) } }",
      path);
  ASSERT_EQ(ours.size(), script.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (const char* name : {"opening [m]", "slip [m]", "pressure [Pa]", "shear [Pa]"})
      EXPECT_NEAR(ours[i][name], script[i][name], 1e-9 * (1e-3 + std::abs(ours[i][name]))) << i << name;
}

// The cohesive law again, with the greatest opening as its memory: torn, unloaded, closed, torn further.
TEST(drive_joint, a_normal_law_of_the_script_remembers) {
  const std::string path =
      "{ opening = 5e-5 }, { opening = 2e-4 }, { opening = 5e-5 }, { opening = -1e-5 }, { opening = 4e-4 }";
  const std::string smooth = ", friction = \"none\"";
  const auto ours = driven(
      "normal_law = contact.cohesive { stiffness = 1e10, tensile_strength = 1e6, fracture_energy = 200 }" +
          smooth,
      path);
  const auto script = driven(
      "normal_law = contact.lua_normal { variables = 1, parameters = { k = 1e10, T = 1e6, G = 200 },\n"
      " pressure = function(o, state, p)\n"
      "  local function pull(x)\n"
      "    local peak, gone = p.T/p.k, 2*p.G/p.T\n"
      "    return x <= peak and p.k*x or x < gone and p.T*(gone - x)/(gone - peak) or 0\n"
      "  end\n"
      "  local worst = math.max(state[1], o)\n"
      "  if o <= 0 then return -p.k*o, { worst } end\n"
      "  return -o*pull(worst)/worst, { worst }\n"
      " end }" +
          smooth,
      path);
  ASSERT_EQ(ours.size(), script.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    EXPECT_NEAR(ours[i]["pressure [Pa]"], script[i]["pressure [Pa]"], 1e-3) << i;
  EXPECT_LT(ours[15]["pressure [Pa]"], -1e5);
}

TEST(drive_joint, what_the_laws_cannot_carry_is_not_converged_and_keeps_what_was_reached) {
  const auto rows = driven(coulomb, "{ pressure = 1*u.MPa }, { shear = 1*u.MPa }", 10, 3);
  ASSERT_GT(rows.size(), 11u);
  EXPECT_LT(rows.back()["shear [Pa]"], 1e5 + 1e6 * std::tan(M_PI / 6) + 1);
  driven(coulomb, "{ pressure = -1*u.kPa }", 10, 3);
  driven(
      "normal_law = contact.barton_bandis_closure { stiffness = 1e10, greatest_closure = 1e-4 }, " + coulomb,
      "{ opening = -2e-4 }", 10, 3);
}

TEST(drive_joint, mistakes_are_told_with_their_places) {
  expect_refused(
      "local u = units\nreturn Drive { joint = { " + coulomb +
          " }, plane = \"strain\", path = {\n {}, { yy = 1e-3 },\n { slip = 1, shear = 2 }, { slip = 1*u.Pa "
          "} } }",
      {"law.lua:2: plane: a point of a joint knows no plane", "law.lua:3: path[1]: leads nowhere",
       "law.lua:3: path[2].yy: leads a material, not a joint",
       "law.lua:4: path[3].slip: slip and shear are both", "law.lua:4: path[4].slip: must be in m"});
  expect_refused("return Drive { joint = { normal_law = contact.linear {} }, path = { { slip = 1 } } }",
                 {"joint.normal_law.stiffness: is missing", "joint.friction: is missing"});
  expect_refused(
      "return Drive { joint = { friction = \"none\" },\n path = function(t) return t end }",
      {"law.lua:2: path: the path's function must return the opening and the slip of the joint; it "
       "returns 1 value"});
  expect_refused("return Drive { path = { { slip = 1 } } }", {"needs exactly one of material and joint"});
  expect_refused(
      "return Drive { material = material.elastic { E = 1e9, nu = 0.2 },\n path = { { slip = 1 } } }",
      {"plane: is missing", "law.lua:2: path[1].slip: leads a joint, not a material"});
}

}  // namespace
}  // namespace ashlar::test
