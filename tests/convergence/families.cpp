#include "convergence/families.hpp"

#include <array>
#include <stdexcept>

#include "meshing_voronoi/voronoi.hpp"
#include "patch/voronoi_settings.hpp"
#include "testing/meshes.hpp"

namespace ashlar::convergence {

namespace {

/// Each quadrilateral cut in two.
mesh::RawMesh cut_in_two(const mesh::RawMesh& quads) {
  mesh::RawMesh raw;
  raw.points = quads.points;
  for (mesh::Index c = 0; c < quads.cell_points.size(); ++c) {
    const auto p = quads.cell_points[c];
    for (const auto& triangle : {std::array{p[0], p[1], p[2]}, std::array{p[0], p[2], p[3]}}) {
      raw.cell_points.append(triangle);
      raw.cell_region.push_back(0);
    }
  }
  return raw;
}

}  // namespace

mesh::RawMesh family_raw(const std::string& family, int n) {
  if (family == "voronoi")
    return meshing_voronoi::generate(testing::square_domain(), patch::voronoi_settings({n * n, 1, 12, 0.08}));
  if (family == "triangles") return cut_in_two(testing::distorted_square(n, 0.15));
  for (const testing::MeshFamily& each : testing::ugly_families())
    if (each.name == family) return each.make(n);
  throw std::runtime_error("no family '" + family + "'");
}

mesh::Mesh family_mesh(const std::string& family, int n) {
  return testing::square_mesh(family_raw(family, n));
}

}  // namespace ashlar::convergence
