#pragma once
// Meshes made by other programs.

#include "mesh/generator.hpp"

namespace ashlar::meshing_file {

/// Reads the file that `path` names. Throws InputError naming the file, and the line or byte where it can.
mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings);

/// Reads a mesh from a file's text; `name` ends in .msh, .vtk or .vtu and appears in messages.
mesh::RawMesh read(const std::string& name, const std::string& text);

}  // namespace ashlar::meshing_file
