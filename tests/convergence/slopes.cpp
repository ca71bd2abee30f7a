// Orders 1, 2, 3 against a smooth field with a body force that varies, in true norms: k+1 for displacements
// (L2) and k for strains (energy).

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "convergence/families.hpp"
#include "convergence/norms.hpp"

namespace ashlar::convergence {
namespace {

struct Measured {
  double h = 0;
  Norms error;
};

Measured measure(const std::string& family, int n, const std::shared_ptr<const model::Element>& element) {
  const double lambda = 1.5e9, mu = 1e9, nu = lambda / (2 * (lambda + mu));
  patch::Solid solid(family_mesh(family, n),
                     std::make_shared<elasticity::Elastic>(2 * mu * (1 + nu), nu, model::Plane::strain),
                     element);
  const Norms error = solved_norms(solid, waves(lambda, mu));
  return {1 / std::sqrt(static_cast<double>(solid.model.mesh.cell_count())), error};
}

/// Slopes of the two norms from about n × n cells to 2n × 2n.
Norms slopes(const std::string& family, int order, std::shared_ptr<const elasticity::Stabilisation> rest) {
  const auto element = vem(order, std::move(rest));
  const int n = order < 3 ? 20 : 14;
  const Measured coarse = measure(family, n, element), fine = measure(family, 2 * n, element);
  const double refined = std::log(coarse.h / fine.h);
  const Norms found{std::log(coarse.error.displacement / fine.error.displacement) / refined,
                    std::log(coarse.error.energy / fine.error.energy) / refined};
  std::printf("%s, order %d: slopes %.3f (L2) and %.3f (energy); errors %.1e and %.1e\n", family.c_str(),
              order, found.displacement, found.energy, fine.error.displacement, fine.error.energy);
  return found;
}

using Choice = std::tuple<const char*, int>;
class Slope : public testing::TestWithParam<Choice> {};

TEST_P(Slope, is_that_of_theory_within_a_tenth) {
  const auto [family, order] = GetParam();
  const Norms found = slopes(family, order, std::make_shared<elasticity::BendingStabilisation>());
  EXPECT_NEAR(found.displacement, order + 1, 0.1);
  EXPECT_NEAR(found.energy, order, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Slope,
                         testing::Combine(testing::Values("structured", "voronoi", "chevron", "pegboard",
                                                          "distorted"),
                                          testing::Values(1, 2, 3)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) +
                                  std::to_string(std::get<1>(info.param));
                         });

}  // namespace
}  // namespace ashlar::convergence
