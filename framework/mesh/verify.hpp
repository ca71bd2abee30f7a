#pragma once
// The invariants of a mesh, checked one by one. For tests and debugging.

#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// What is wrong with the mesh, in words; empty if all invariants hold: indices in range, cells simple and
/// counter-clockwise, edges and cells that know each other, every point used, groups of existing edges,
/// lips on borders, ordered, of equal arc length and position.
std::vector<std::string> verify(const Mesh& mesh);

}  // namespace ashlar::mesh
