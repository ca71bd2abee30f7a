#pragma once
// Families of meshes of the unit square, about n cells wide, for slopes.

#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ashlar::convergence {

/// As a generator makes it.
mesh::RawMesh family_raw(const std::string& family, int n);
/// structured, distorted, chevron, pegboard, voronoi, triangles.
mesh::Mesh family_mesh(const std::string& family, int n);

}  // namespace ashlar::convergence
