#pragma once
// Rows and columns of quadrilaterals in four-sided regions.

#include "mesh/generator.hpp"

namespace ashlar::meshing_structured {

/// Throws InputError for regions without four corners, or so curved that rows and columns cross.
mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings);

}  // namespace ashlar::meshing_structured
