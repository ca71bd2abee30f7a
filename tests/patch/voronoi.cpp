#include "meshing_voronoi/voronoi.hpp"

#include <gtest/gtest.h>

#include "modules/elasticity/cells.hpp"
#include "patch/linear_field.hpp"
#include "patch/voronoi_settings.hpp"
#include "testing/meshes.hpp"

namespace ashlar::patch {
namespace {

TEST(patch, linear_fields_are_exact_on_voronoi_meshes) {
  const mesh::Domain domain = testing::square_domain();
  for (const auto& [choice, stabilisation] : elasticity::testing::stabilisations())
    for (const int seed : {1, 2, 3})
      for (const double nu : {0.3, 0.4999}) {
        SCOPED_TRACE(choice + ", seed " + std::to_string(seed) + ", nu " + std::to_string(nu));
        Solid solid(
            mesh::build_mesh(meshing_voronoi::generate(domain, voronoi_settings({150, seed})), domain),
            std::make_shared<elasticity::Elastic>(1e10, nu, model::Plane::strain), stabilisation);
        expect_exact(solid);
      }
}

}  // namespace
}  // namespace ashlar::patch
