// What the makers of yielding laws refuse, and where they say so.

#include <gtest/gtest.h>

#include <cmath>

#include "elasticity/materials/drucker_prager/drucker_prager.hpp"
#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"
#include "plastic_checks.hpp"
#include "settings.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;

struct Said {
  double nu = 0.3, cohesion = 1e6, friction = 30 * degree, dilation = 10 * degree;
  std::optional<double> tension = {};
};

core::Settings settings(const Said& said) {
  core::Settings made = settings_of("mohr_coulomb", {{"E", 10e9},
                                                     {"nu", said.nu},
                                                     {"cohesion", said.cohesion},
                                                     {"friction", said.friction},
                                                     {"dilation", said.dilation},
                                                     {"tensile_strength", said.tension},
                                                     {"unit_weight", {}},
                                                     {"density", 2500.0}});
  core::Settings::Entry match;
  match.key = "match";
  match.value = core::make_value(std::string("outer"));
  made.entries.push_back(match);
  return made;
}

void expect_refused(const Said& said, Plane plane, const char* path, const char* words) {
  for (const auto& make : {make_mohr_coulomb, make_drucker_prager}) {
    if (std::string(path) == "tensile_strength" && make == make_drucker_prager) continue;
    core::Mistakes mistakes;
    EXPECT_FALSE(make(settings(said), plane, mistakes)) << words;
    ASSERT_EQ(mistakes.list().size(), 1u) << words;
    EXPECT_EQ(mistakes.list()[0].place.path, path);
    const std::string text = core::to_string(mistakes.list()[0]);
    EXPECT_NE(text.find(words), std::string::npos) << text;
  }
}

TEST(mistakes, sound_settings_make_a_law) {
  core::Mistakes mistakes;
  for (const auto& make : {make_mohr_coulomb, make_drucker_prager}) {
    const auto law = make(settings({}), Plane::strain, mistakes);
    ASSERT_TRUE(law);
    EXPECT_EQ(law->unit_weight(10), 25e3);
    EXPECT_NEAR(law->shear_modulus(), 10e9 / 2.6, 1);
    EXPECT_NEAR(law->plane_modulus(), 10e9 / 0.91, 1);
    EXPECT_FALSE(law->linear());
    EXPECT_FALSE(law->symmetric());
    EXPECT_EQ(law->internal_variables(), 5);
    EXPECT_TRUE(make(settings({.dilation = 30 * degree}), Plane::strain, mistakes)->symmetric());
  }
  // c/tan φ as the user computes it is not above c/tan φ.
  EXPECT_TRUE(make_mohr_coulomb(settings({.tension = 1e6 / std::tan(30 * degree)}), Plane::strain, mistakes));
  EXPECT_TRUE(mistakes.empty());
}

TEST(mistakes, what_has_no_sense_is_refused) {
  expect_refused({}, Plane::stress, "material", "for plane strain only");
  expect_refused({.nu = 0.5}, Plane::strain, "nu", "no volume change");
  expect_refused({.friction = 30}, Plane::strain, "friction", "write 30*units.deg");
  expect_refused({.friction = 90 * degree}, Plane::strain, "friction", "below 90°");
  expect_refused({.friction = -1 * degree, .dilation = 0}, Plane::strain, "friction", "from 0°");
  expect_refused({.dilation = 31 * degree}, Plane::strain, "dilation", "must not exceed friction");
  expect_refused({.cohesion = 0, .friction = 0, .dilation = 0}, Plane::strain, "cohesion",
                 "no strength at all");
  expect_refused({.tension = 1.8e6}, Plane::strain, "tensile_strength",
                 "cohesion/tan(friction) = 1.73205 MPa");
}

}  // namespace
}  // namespace ashlar::elasticity
