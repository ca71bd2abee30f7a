#pragma once
// Cutting of cells along polylines, for meshes that do not conform to joints.

#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// Changes `raw` so that mesh edges follow each joint that has segments in `domain`. Cells are cut where a
/// joint crosses them; free points nearer to it than 1 % of their shortest edge move onto it instead. Where a
/// joint ends inside a cell, the cell is cut on to its border (an ordinary edge), so that the tip is a point.
/// Throws InputError naming the joint if it leaves the mesh.
void cut_along_joints(RawMesh& raw, const Domain& domain, const std::vector<Index>& joints, double tolerance);

}  // namespace ashlar::mesh
