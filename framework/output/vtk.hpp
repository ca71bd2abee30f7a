#pragma once
// Results for ParaView: VTK XML unstructured grids (version 1.0, raw appended data, 64-bit headers) of one
// stage each, and a collection (.pvd) in which stages are time steps: stage k at time k.

#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/results.hpp"

namespace ashlar::output {

/// The stage's cells as VTK polygons, on the undeformed mesh. Two-component fields become vectors (x, y, 0).
/// Cell data "region" counts from 0 in the order of the field data "region_names".
std::string cells_vtu(const mesh::Mesh& mesh, const model::StageResult& stage);

/// The stage's joints as line cells between neighbouring rows of each profile; point data opening, slip,
/// pressure and closed, cell data "joint" counting joints from 0.
std::string joints_vtu(const model::StageResult& stage);

struct CollectionFile {
  std::size_t stage = 1;  ///< time
  int part = 0;           ///< 0 cells, 1 joints
  std::string file;       ///< relative to the collection
};
std::string collection_pvd(const std::vector<CollectionFile>& files);

}  // namespace ashlar::output
