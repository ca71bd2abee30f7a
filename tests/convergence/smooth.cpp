// Order 1 against a smooth solution: displacements converge with h², stresses with h, on polygons and quads.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "geometry/polygon.hpp"
#include "support/scene_run.hpp"

namespace ashlar::test {
namespace {

using geometry::Point;

constexpr double e = 1e9, nu = 0.3, shear = e / (2 * (1 + nu));  // as in scenes/smooth.lua

Point displacement(Point p) {
  const double ex = std::exp(p.x);
  return {ex * std::sin(p.y) + p.x * p.y, ex * std::cos(p.y) - p.x * p.x / 2 - nu / (1 - nu) * p.y * p.y / 2};
}

/// (xx, yy, xy). Bending: σ_xx = 2μ y/(1−ν), nothing else.
std::array<double, 3> stress(Point p) {
  const double ex = std::exp(p.x);
  return {2 * shear * (ex * std::sin(p.y) + p.y / (1 - nu)), -2 * shear * ex * std::sin(p.y),
          2 * shear * ex * std::cos(p.y)};
}

const model::FieldResult& field(const SceneRun& run, const std::string& name) {
  for (const model::FieldResult& each : run.result.stages.at(0).fields)
    if (each.name == name) return each;
  throw std::runtime_error("no field '" + name + "'");
}

struct Errors {
  double h = 0, displacement = 0, stress = 0;  // √cell area; L2 norms
};

Errors errors(const std::string& mesh, int cells) {
  const SceneRun run =
      run_scene(std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "convergence" / "scenes" / "smooth.lua",
                {{"mesh", mesh}, {"cells", std::to_string(cells)}});
  const model::FieldResult& u = field(run, "displacement");
  const model::FieldResult& s = field(run, "stress");
  Errors sum;
  std::vector<Point> corners;
  for (mesh::Index cell = 0; cell < run.model.mesh.cell_count(); ++cell) {
    const auto points = run.model.mesh.cell_points[cell];
    run.model.mesh.corners(cell, corners);
    const double area = geometry::signed_area(corners);
    const Point centre = geometry::centroid(corners);
    const double part = area / static_cast<double>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point exact = displacement(corners[i]);
      sum.displacement += part * (std::pow(u.values[2 * points[i]] - exact.x, 2) +
                                  std::pow(u.values[2 * points[i] + 1] - exact.y, 2));
      // One point half-way to each corner samples what a cell's one stress misses.
      const auto there = stress(0.5 * (centre + corners[i]));
      for (int k = 0; k < 3; ++k) sum.stress += part * std::pow(s.values[s.width * cell + k] - there[k], 2);
    }
  }
  return {1 / std::sqrt(run.model.mesh.cell_count()), std::sqrt(sum.displacement), std::sqrt(sum.stress)};
}

/// Root mean square error of displacements and of recovered stresses at the mesh points.
Errors errors_at_points(const std::string& mesh, const std::string& order, int cells) {
  const SceneRun run =
      run_scene(std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "convergence" / "scenes" / "smooth.lua",
                {{"mesh", mesh}, {"cells", std::to_string(cells)}, {"order", order}});
  const model::FieldResult& u = field(run, "displacement");
  const model::FieldResult& s = field(run, "stress_nodes");
  Errors sum;
  for (std::size_t p = 0; p < run.model.mesh.points.size(); ++p) {
    const Point at = run.model.mesh.points[p], exact = displacement(at);
    sum.displacement += std::pow(u.values[2 * p] - exact.x, 2) + std::pow(u.values[2 * p + 1] - exact.y, 2);
    const auto there = stress(at);
    for (std::size_t k = 0; k < 3; ++k)
      sum.stress += std::pow(s.values[static_cast<std::size_t>(s.width) * p + k] - there[k], 2);
  }
  const auto points = static_cast<double>(run.model.mesh.points.size());
  return {1 / std::sqrt(run.model.mesh.cell_count()), std::sqrt(sum.displacement / points),
          std::sqrt(sum.stress / points)};
}

class HigherOrder : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(HigherOrder, converges_at_the_points_at_least_as_theory_says) {
  const auto [mesh, order] = GetParam();
  const Errors coarse = errors_at_points(mesh, std::to_string(order), 400),
               fine = errors_at_points(mesh, std::to_string(order), 3600);
  const double refined = std::log(coarse.h / fine.h);
  const double of_displacement = std::log(coarse.displacement / fine.displacement) / refined;
  const double of_stress = std::log(coarse.stress / fine.stress) / refined;
  std::printf("%s, order %d: order %.2f of displacements, %.2f of stresses at points\n", mesh, order,
              of_displacement, of_stress);
  EXPECT_GT(of_displacement, order + 0.9);
  EXPECT_GT(of_stress, order - 0.1);
}

INSTANTIATE_TEST_SUITE_P(Meshes, HigherOrder,
                         testing::Combine(testing::Values("voronoi", "structured"), testing::Values(2, 3)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) +
                                  std::to_string(std::get<1>(info.param));
                         });

class SmoothField : public testing::TestWithParam<const char*> {};

TEST_P(SmoothField, converges_with_the_order_of_theory) {
  const Errors coarse = errors(GetParam(), 200), fine = errors(GetParam(), 3200);
  const double refined = std::log(coarse.h / fine.h);
  const double of_displacement = std::log(coarse.displacement / fine.displacement) / refined;
  const double of_stress = std::log(coarse.stress / fine.stress) / refined;
  std::printf("%s: order %.2f of displacements, %.2f of stresses\n", GetParam(), of_displacement, of_stress);
  // Two halvings of unstructured meshes: a tenth for their scatter. Higher is no fault.
  EXPECT_GT(of_displacement, 1.9);
  EXPECT_GT(of_stress, 0.9);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SmoothField, testing::Values("voronoi", "quads"),
                         [](const auto& info) { return std::string(info.param); });

// What the program itself says of its errors: k + 1 in displacements, k in stresses and energy.
TEST(smooth, errors_against_an_exact_solution_fall_as_theory_says) {
  const auto scene =
      std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "convergence" / "scenes" / "smooth.lua";
  for (const int order : {1, 2, 3}) {
    std::map<std::string, std::array<double, 2>> errors;
    for (const std::size_t fine : {0u, 1u}) {
      const SceneRun run = run_scene(
          scene,
          {{"mesh", "structured"}, {"cells", fine ? "1024" : "256"}, {"order", std::to_string(order)}});
      for (const model::NormResult& norm : run.result.stages.at(0).norms)
        errors[norm.quantity][fine] = norm.relative();
    }
    ASSERT_EQ(errors.size(), 3u);
    for (const auto& [quantity, pair] : errors) {
      const double slope = std::log2(pair[0] / pair[1]);
      std::printf("order %d, %s: %.2e -> %.2e, slope %.2f\n", order, quantity.c_str(), pair[0], pair[1],
                  slope);
      const double theory = quantity == "displacement" ? order + 1 : order;
      EXPECT_GT(slope, theory - 0.15);
      EXPECT_LT(slope, theory + 0.3);
    }
  }
}

// Timoshenko's cantilever: P L³/(3 E I) + (4 + 5ν) P D² L/(24 E I) at the end's middle; cubic, so that order
// 3 holds it exactly.
TEST(smooth, timoshenkos_cantilever) {
  const auto scene =
      std::filesystem::path(ASHLAR_SOURCE_DIR) / "tests" / "convergence" / "scenes" / "timoshenko.lua";
  const double inertia = 12.0 * 12 * 12 / 12, p = 1e6, l = 48, modulus = 30e9;
  const double tip =
      -(p * l * l * l / (3 * modulus * inertia) + (4 + 5 * 0.3) * p * 144 * l / (24 * modulus * inertia));
  const double bounds[] = {0.02, 1e-4, 1e-8};  // of order 3: round-off times a condition of 4e7
  for (const char* mesh : {"quads", "voronoi"})
    for (const int order : {1, 2, 3}) {
      const SceneRun run =
          run_scene(scene, {{"mesh", mesh}, {"divide", "8"}, {"order", std::to_string(order)}});
      const double error = run.value("shear", "tip", "uy") / tip - 1;
      const model::NormResult& norm = run.stage("shear").norms.front();
      std::printf("%s, order %d: end %+.1e, displacement %.1e\n", mesh, order, error, norm.relative());
      EXPECT_LT(std::abs(error), bounds[order - 1]);
      EXPECT_LT(norm.relative(), bounds[order - 1]);
    }
}

}  // namespace
}  // namespace ashlar::test
