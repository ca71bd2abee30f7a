#pragma once
// Centroidal Voronoi meshes that conform to borders and joints.

#include <cstdint>

#include "mesh/generator.hpp"

namespace ashlar::meshing_voronoi {

/// The registered generator "voronoi"; see module.lua for its settings.
mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings);

}  // namespace ashlar::meshing_voronoi
