// Joint laws inside a body, against closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "program.hpp"

namespace ashlar::test {
namespace {

double first_ux(const std::string& scene) {
  const ScratchFolder folder;
  write(folder / "scene.lua", scene);
  const Ended ended = call("run scene.lua --quiet --no-files --json out.json", folder / "");
  EXPECT_EQ(ended.code, 0) << ended.err;
  if (ended.code != 0) return NAN;
  const std::string json = read(folder / "out.json"), key = "\"ux\": ";
  return std::stod(json.substr(json.find(key, json.find("\"probes\"")) + key.size()));
}

// A square of 1 m in plane stress under 1 MPa, cut at 45° by a joint of stiffness k_n, k_t:
// u = σL/E + σ (1/k_n + 1/k_t)/(2√2), that is 0.05985 mm (a known verification of interface elements).
TEST(joint_laws, an_oblique_elastic_interface_shortens_a_square_as_by_hand) {
  const double exact = 1e6 / 30e9 + 1e6 * (1 / 20e9 + 1 / 40e9) / (2 * std::sqrt(2.0));
  EXPECT_NEAR(exact, 0.05985e-3, 1e-8);
  for (const char* enforce : {"lagrange", "penalty", "augmented_lagrange"}) {
    const double ux = first_ux(
        "local u = units\n"
        "return Scene { title = \"Oblique interface\", plane = \"stress\",\n"
        "  geometry = { rock = Rectangle { from = {0,0}, to = {1,1},\n"
        "    material = material.elastic { E = 30*u.GPa, nu = 0.2 } } },\n"
        "  joints = { cut = Joint { path = { {0,0}, {1,1} }, enforce = \"" +
        std::string(enforce) +
        "\",\n    normal_law = contact.linear { stiffness = 20*u.GPa/u.m },\n"
        "    friction = contact.coulomb { friction_angle = 0, cohesion = 10*u.MPa, stiffness = 40*u.GPa/u.m "
        "} "
        "} },\n"
        "  mesh = mesh.voronoi { size = 0.2, seed = 3 },\n"
        "  supports = { [\"rock.left\"] = \"x\", corner = Support { at = {0,1}, fix = \"y\" } },\n"
        "  stages = { Stage { \"press\", pressures = { [\"rock.right\"] = 1*u.MPa } } },\n"
        "  outputs = { probes = { corner = { \"displacement\", at = {1,0} } } } }\n");
    EXPECT_NEAR(-ux, exact, 1e-10 * exact) << enforce;
  }
}

}  // namespace
}  // namespace ashlar::test
