#pragma once
// The interface of mesh generators. A module registers one as kind "mesh":
//   registry.add_make("mesh", "voronoi", std::function<GenerateMesh>(…));

#include "core/schema.hpp"
#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// Makes cells that fill the domain's faces, conform to all its segments, and do not depend on thread count.
/// Throws InputError for settings that cannot be met.
using GenerateMesh = RawMesh(const Domain& domain, const core::Settings& settings);

}  // namespace ashlar::mesh
