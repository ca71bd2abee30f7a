#pragma once
// Meshes by the Gmsh library. One at a time: the library keeps its state in globals.

#include "mesh/generator.hpp"
#include "mesh/size_field.hpp"

namespace ashlar::meshing_gmsh {

/// The registered generator "gmsh"; see module.lua for its settings.
mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings);

/// Gives the domain's points, segments and faces to Gmsh's current model; points, curves and surfaces get the
/// domain's numbers plus one as tags. Segments inside a face are embedded.
void give_geometry(const mesh::Domain& domain);

}  // namespace ashlar::meshing_gmsh
