// The friction laws against numbers by hand.

#include <gtest/gtest.h>

#include "modules/contact/laws/laws.hpp"

namespace ashlar::test {
namespace {

void expect_slopes(const Friction& law, double pressure, double path) {
  const double dp = 1e-5 * pressure, ds = 1e-8;
  const Strength f = law.strength(pressure, path);
  const auto by_pressure =
      (law.strength(pressure + dp, path).value - law.strength(pressure - dp, path).value) / (2 * dp);
  EXPECT_NEAR(f.by_pressure, by_pressure, 1e-7) << pressure << " " << path;
  const auto by_path =
      (law.strength(pressure, path + ds).value - law.strength(pressure, path - ds).value) / (2 * ds);
  EXPECT_NEAR(f.by_path, by_path, 1e-6 * std::max(1e6, std::abs(by_path))) << pressure << " " << path;
  const auto grown = [&](double p, double to) { return law.dilation(p, 1e-3, to).value; };
  const Dilation d = law.dilation(pressure, 1e-3, path);
  EXPECT_NEAR(d.by_pressure * pressure, (grown(pressure + dp, path) - grown(pressure - dp, path)) / 2e-5,
              1e-10);
  EXPECT_NEAR(d.by_path, (grown(pressure, path + ds) - grown(pressure, path - ds)) / (2 * ds), 1e-7);
}

TEST(friction, coulomb_falls_with_slip_and_is_never_negative) {
  const auto law = softening_coulomb(INFINITY);
  EXPECT_DOUBLE_EQ(law->strength(2e6, 0).value, 3e5 + 0.8 * 2e6);
  EXPECT_DOUBLE_EQ(law->strength(2e6, 2e-3).value, 2e5 + 0.65 * 2e6);
  EXPECT_DOUBLE_EQ(law->strength(2e6, 4e-3).value, 1e5 + 0.5 * 2e6);
  EXPECT_DOUBLE_EQ(law->strength(2e6, 1).value, 1e5 + 0.5 * 2e6);
  EXPECT_DOUBLE_EQ(law->strength(-3e5, 0).value, 6e4);
  EXPECT_EQ(law->strength(-4e5, 0).value, 0);
  EXPECT_EQ(law->strength(-4e5, 0).by_pressure, 0);
  for (const double path : {1e-3, 3e-3, 7e-3})
    for (const double pressure : {1e3, 1e6, 3e7}) expect_slopes(*law, pressure, path);
}

TEST(friction, softening_at_once_keeps_the_peak_until_the_first_slip) {
  Coulomb::Data data = coulomb_data(0.8, 3e5);
  data.residual_friction = 0.5;
  data.residual_cohesion = 0;
  const Coulomb law(data);
  EXPECT_DOUBLE_EQ(law.strength(1e6, 0).value, 1.1e6);
  EXPECT_DOUBLE_EQ(law.strength(1e6, 1e-9).value, 5e5);
  EXPECT_EQ(law.strength(1e6, 1e-9).by_path, 0);
}

TEST(friction, coulomb_dilates_until_it_has_decayed) {
  const auto law = softening_coulomb(INFINITY);
  const double tangent = std::tan(8 * degree), slip = 6e-3;
  EXPECT_NEAR(law->dilation(1e6, 0, 3e-3).value, tangent * slip * (1 - std::exp(-0.5)), 1e-17);
  EXPECT_NEAR(law->dilation(1e6, 3e-3, 1).value, tangent * slip * std::exp(-0.5), 1e-17);
  Coulomb::Data data = coulomb_data(0.8);
  data.dilation = 0.1;
  EXPECT_DOUBLE_EQ(Coulomb(data).dilation(1e6, 2e-3, 5e-3).value, 3e-4);
}

TEST(friction, barton_bandis_gives_the_known_figure) {
  const BartonBandis law(barton_data());
  EXPECT_NEAR(law.strength(1e6, 0).value, 1.192e6, 5e2);  // tan 50°
  EXPECT_NEAR(law.strength(1e6, 0).value, 1e6 * std::tan(50 * degree), 1e-6);
  EXPECT_NEAR(law.strength(10e6, 0).value, 10e6 * std::tan(40 * degree), 1e-5);
  // From 70° at 10 kPa down, and φ_r from JCS up.
  EXPECT_NEAR(law.strength(1e3, 0).value, 1e3 * std::tan(70 * degree), 1e-9);
  EXPECT_NEAR(law.strength(300e6, 0).value, 300e6 * std::tan(30 * degree), 1e-4);
  EXPECT_EQ(law.strength(-1e3, 0).value, 0);
  EXPECT_EQ(law.strength(0, 0).value, 0);
  EXPECT_NEAR(law.strength(0, 0).by_pressure, std::tan(70 * degree), 1e-12);
  EXPECT_EQ(law.dilation(1e6, 0, 1).value, 0);
}

TEST(friction, barton_bandis_grows_with_pressure_and_dilates_by_half_its_roughness) {
  for (const double jrc : {0.0, 5.0, 20.0}) {
    BartonBandis::Data data = barton_data(true);
    data.jrc = jrc;
    const BartonBandis law(data);
    double before = 0;
    for (double pressure = 1; pressure < 1e10; pressure *= 1.3) {
      EXPECT_GT(law.strength(pressure, 0).value, before);
      EXPECT_GT(law.strength(pressure, 0).by_pressure, 0);
      before = law.strength(pressure, 0).value;
    }
    for (const double pressure : {1e3, 7e5, 3e6, 2e8}) expect_slopes(law, pressure, 2e-3);
  }
  EXPECT_NEAR(BartonBandis(barton_data(true)).dilation(1e6, 1e-3, 3e-3).value, std::tan(10 * degree) * 2e-3,
              1e-16);
}

TEST(friction, a_function_of_the_script_is_asked_for_no_pull) {
  const LuaFriction law({number_function([](std::span<const double> a) {
                           EXPECT_GE(a[0], 0);
                           EXPECT_GE(a[1], 0);
                           return 3e3 * std::pow(a[0], 0.7) * (1 + std::exp(-a[1] / 1e-3));
                         }),
                         number_function([](std::span<const double> a) { return 0.1 * a[1] + 0 * a[0]; })});
  EXPECT_DOUBLE_EQ(law.strength(1e6, 0).value, 6e3 * std::pow(1e6, 0.7));
  EXPECT_EQ(law.strength(-5, 0).value, 0);
  EXPECT_EQ(law.strength(-5, 0).by_pressure, 0);
  EXPECT_EQ(law.strength(1e6, -1e-4).by_path, 0);
  EXPECT_NEAR(law.dilation(1e6, 1e-3, 3e-3).value, 2e-4, 1e-18);
  expect_slopes(law, 2e6, 2e-3);
}

// A joint of constant stiffness under 1 MPa: 0.1 mm elastic slip to the peak of 0.6 MPa, then sliding; back
// by the same stiffness to sliding the other way.
TEST(friction, a_cycle_of_shear_by_hand) {
  Coulomb::Data data = coulomb_data(0.6);
  data.stiffness = 6e9;
  const JointLaw law = joint(std::make_shared<Linear>(20e9, 0), std::make_shared<Coulomb>(data));
  PointMemory memory;
  memory = remember(law, {}, memory, Status::stick, {1e6, 6e5});
  EXPECT_NEAR(respond(law, {}, memory, Status::stick, {1e6, 6e5}).jump[1], 1e-4, 1e-18);
  memory = remember(law, {}, memory, Status::slip_forward, {1e6, 9e-4});  // slip 1 mm
  EXPECT_NEAR(respond(law, {}, memory, Status::stick, {1e6, 6e5}).jump[1], 1e-3, 1e-17);
  // −0.6 MPa is reached after 0.2 mm back
  EXPECT_NEAR(respond(law, {}, memory, Status::stick, {1e6, -6e5}).jump[1], 8e-4, 1e-17);
  memory = remember(law, {}, memory, Status::slip_backward, {1e6, 8e-4});
  EXPECT_NEAR(respond(law, {}, memory, Status::stick, {1e6, -6e5}).jump[1], 0, 1e-17);
  EXPECT_NEAR(memory.path, 1.7e-3, 1e-17);
}

}  // namespace
}  // namespace ashlar::test
