#include "meshing_voronoi/voronoi.hpp"

#include <gtest/gtest.h>

#include "modules/elasticity/cells.hpp"
#include "patch/linear_field.hpp"
#include "testing/meshes.hpp"

namespace ashlar::patch {
namespace {

core::Settings voronoi(int cells, int seed) {
  core::Settings settings;
  settings.kind = "mesh";
  settings.name = "voronoi";
  const auto add = [&](const char* key, std::optional<double> number) {
    core::Settings::Entry entry;
    entry.key = key;
    if (number) entry.value = core::make_value(*number);
    settings.entries.push_back(std::move(entry));
  };
  add("size", {});
  add("refine", {});
  add("cells", cells);
  add("seed", seed);
  add("iterations", 3);
  add("grading", 0.3);
  add("collapse", 0);
  return settings;
}

TEST(patch, linear_fields_are_exact_on_voronoi_meshes) {
  const mesh::Domain domain = testing::square_domain();
  for (const auto& [choice, stabilisation] : elasticity::testing::stabilisations())
    for (const int seed : {1, 2, 3})
      for (const double nu : {0.3, 0.4999}) {
        SCOPED_TRACE(choice + ", seed " + std::to_string(seed) + ", nu " + std::to_string(nu));
        Solid solid(mesh::build_mesh(meshing_voronoi::generate(domain, voronoi(150, seed)), domain),
                    std::make_shared<elasticity::Elastic>(1e10, nu, model::Plane::strain), stabilisation);
        expect_exact(solid);
      }
}

}  // namespace
}  // namespace ashlar::patch
