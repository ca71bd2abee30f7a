#include "elasticity/utilisation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "elasticity/bulk.hpp"
#include "elasticity/materials/drucker_prager/drucker_prager.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"
#include "elasticity/vem.hpp"
#include "materials/plastic_checks.hpp"
#include "materials/settings.hpp"
#include "testing/meshes.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;
using model::Voigt;

const double sine = 0.5, cosine = std::sqrt(0.75);  // φ = 30°
const CoulombLimit rock{2e6, sine, cosine, 2e6 * cosine / sine};

TEST(utilisation, is_one_at_the_uniaxial_strengths_in_any_direction) {
  const double crushing = 2 * 2e6 * cosine / (1 - sine), tearing = 2 * 2e6 * cosine / (1 + sine);
  EXPECT_NEAR(utilisation(rock, {-crushing, 0, 0, 0}), 1, 1e-14);
  EXPECT_NEAR(utilisation(rock, {0, 0, 0, -crushing}), 1, 1e-14);
  EXPECT_NEAR(utilisation(rock, {0, tearing, 0, 0}), 1, 1e-14);
  // Turned by 45°: the same principal stresses.
  EXPECT_NEAR(utilisation(rock, {-crushing / 2, -crushing / 2, crushing / 2, 0}), 1, 1e-14);
  // Half the load: R and s halve, c does not.
  const double r = crushing / 4;
  EXPECT_NEAR(utilisation(rock, {-crushing / 2, 0, 0, 0}), r / (2e6 * cosine + r * sine), 1e-14);
  EXPECT_EQ(utilisation(rock, {}), 0);
}

TEST(utilisation, of_pure_tension_is_its_share_of_the_tensile_strength) {
  const double tip = 2e6 * cosine / sine;
  EXPECT_NEAR(utilisation(rock, {0.4 * tip, 0.4 * tip, 0, 0.4 * tip}), 0.4, 1e-14);
  CoulombLimit cut = rock;
  cut.tension = 0.5e6;
  EXPECT_NEAR(utilisation(cut, {0.2e6, -0.1e6, 0, 0}), 0.4, 1e-14);
  EXPECT_EQ(utilisation(rock, {1.2 * tip, 1.1 * tip, 0, 1.1 * tip}), most_utilisation);
  cut.cohesion = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(utilisation(cut, {0.2e6, -9e9, 0, 0}), 0.4, 1e-14);
}

TEST(utilisation, without_cohesion_is_mobilised_friction_over_friction) {
  const CoulombLimit sand{0, sine, cosine, 0};
  // sin φ_mob = (3 − 1)/(3 + 1)
  EXPECT_NEAR(utilisation(sand, {-1e3, -3e3, 0, -2e3}), 0.5 / sine, 1e-14);
  EXPECT_NEAR(utilisation(sand, {-2e3, -3e3, 0, -2.5e3}), 0.2 / sine, 1e-14);
  EXPECT_EQ(utilisation(sand, {0, 0, 0, 0}), 0);
  EXPECT_EQ(utilisation(sand, {1, 0, 0, 0}), most_utilisation);
}

TEST(utilisation, of_laws_that_yield_is_one_where_they_do) {
  const FrictionalStrength shear = frictional(1e6, 30, 10);
  const MohrCoulomb coulomb({isotropic(10e9, 0.3), {shear, 0.5e6}});
  const DruckerPrager cone(isotropic(10e9, 0.3), matched(shear, Match::outer));
  std::vector<double> trial(5);
  const std::vector<double> virgin(5);
  for (int i = 0; i < 40; ++i) {
    const Voigt strain{3e-3 * std::sin(7.0 * i), -2e-3 * std::cos(3.0 * i), 4e-3 * std::sin(11.0 * i + 1), 0};
    const Voigt at_coulomb = coulomb.respond(strain, virgin, trial).stress;
    if (std::abs(coulomb.excess(at_coulomb)) < 1) {
      EXPECT_NEAR(coulomb.utilisation(at_coulomb), 1, 1e-5);
    }
    const Voigt at_cone = cone.respond(strain, virgin, trial).stress;
    if (std::abs(cone.excess(at_cone)) < 1 && std::string(cone.region(strain, virgin)) == "cone") {
      EXPECT_NEAR(cone.utilisation(at_cone), 1, 1e-5);
    }
  }
}

std::shared_ptr<const model::Material> elastic_with(std::optional<double> cohesion,
                                                    std::optional<double> friction,
                                                    std::optional<double> tension, core::Mistakes& mistakes) {
  core::Settings settings = settings_of("elastic", {{"E", 10e9},
                                                    {"nu", 0.2},
                                                    {"cohesion", cohesion},
                                                    {"friction", friction},
                                                    {"tensile_strength", tension},
                                                    {"unit_weight", {}},
                                                    {"density", {}}});
  for (core::Settings::Entry& entry : settings.entries) entry.said = !entry.value.is_nothing();
  return make_elastic(settings, Plane::strain, mistakes);
}

TEST(utilisation, elastic_laws_have_a_strength_if_they_name_one_and_stay_elastic) {
  core::Mistakes none;
  EXPECT_EQ(dynamic_cast<const WithStrength*>(elastic_with({}, {}, {}, none).get()), nullptr);
  const auto law = elastic_with(2e6, std::asin(sine), {}, none);
  const auto* strength = dynamic_cast<const WithStrength*>(law.get());
  ASSERT_NE(strength, nullptr);
  EXPECT_TRUE(law->linear());
  EXPECT_NEAR(strength->utilisation({-1e6, 0, 0, 0}), utilisation(rock, {-1e6, 0, 0, 0}), 1e-14);
  const auto brittle = elastic_with({}, {}, 1e6, none);
  EXPECT_NEAR(dynamic_cast<const WithStrength&>(*brittle).utilisation({0.3e6, -9e6, 0, 0}), 0.3, 1e-14);
  EXPECT_TRUE(none.empty());
}

TEST(utilisation, half_a_strength_and_too_much_tension_are_mistakes) {
  struct Case {
    std::optional<double> cohesion, friction, tension;
    const char *path, *words;
  };
  for (const Case& c :
       {Case{1e6, {}, {}, "cohesion", "both cohesion and friction"},
        Case{{}, 0.5, {}, "friction", "both cohesion and friction"}, Case{1e6, 2.0, {}, "friction", "90"},
        Case{0.0, 0.0, {}, "cohesion", "no strength at all"},
        Case{1e6, 0.5, 9e6, "tensile_strength", "exceeds cohesion/tan(friction)"}}) {
    core::Mistakes mistakes;
    elastic_with(c.cohesion, c.friction, c.tension, mistakes);
    ASSERT_EQ(mistakes.list().size(), 1u) << c.words;
    EXPECT_EQ(mistakes.list()[0].place.path, c.path);
    EXPECT_NE(core::to_string(mistakes.list()[0]).find(c.words), std::string::npos);
  }
}

// Two regions of one stiffness and different strength, and no region with none.
TEST(utilisation, at_points_is_that_of_the_worst_side) {
  model::Model model;
  model.mesh = testing::square_mesh(testing::structured_square(4));
  model.mesh.regions.push_back("weak");
  for (Index c = 0; c < model.mesh.cell_count(); ++c) model.mesh.cell_region[c] = c % 4 < 2 ? 0 : 1;
  const Elastic hooke(1e9, 0.3, Plane::strain);
  CoulombLimit weak = rock;
  weak.cohesion /= 4;
  model.materials = {std::make_shared<ElasticWithStrength>(hooke, rock),
                     std::make_shared<ElasticWithStrength>(hooke, weak)};
  model.element = std::make_shared<VemElement>(std::make_shared<BendingStabilisation>());
  model.dofs = fields::DofMap(model.mesh, {"displacement", "m"});
  const Stress stress{-1e6, 0, 0.2e6, -0.3e6};
  CellStresses cells;
  cells.start = {0};
  for (Index c = 0; c < model.mesh.cell_count(); ++c) {
    const double x = 0.125 + 0.25 * (c % 4), y = 0.125 + 0.25 * (c / 4);
    cells.sample.push_back({{x, y}, 1.0 / 16, stress});
    cells.stress.push_back(stress);
    cells.start.push_back(cells.sample.size());
  }
  model::StageResult result;
  add_utilisation(model, cells, all_fields, result);
  ASSERT_EQ(result.fields.size(), 2u);
  for (Index c = 0; c < model.mesh.cell_count(); ++c)
    EXPECT_NEAR(result.fields[0].values[c], utilisation(c % 4 < 2 ? rock : weak, stress), 1e-12);
  for (Index p = 0; p < model.mesh.point_count(); ++p)
    EXPECT_NEAR(result.fields[1].values[p], utilisation(model.mesh.points[p].x < 0.49 ? rock : weak, stress),
                1e-9);
  model.materials = {std::make_shared<Elastic>(hooke), std::make_shared<Elastic>(hooke)};
  add_utilisation(model, cells, all_fields, result);
  EXPECT_EQ(result.fields.size(), 2u);
}

}  // namespace
}  // namespace ashlar::elasticity
