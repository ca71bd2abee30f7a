#pragma once
// Ugly meshes of the unit square for every module's tests: region "square" with borders square.bottom,
// .right, .top, .left. All are about n cells wide.

#include <functional>
#include <string>
#include <vector>

#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::testing {

mesh::RawMesh structured_square(int n);
/// Inner points moved by up to `amount` of the cell size; some cells are not convex.
mesh::RawMesh distorted_square(int n, double amount = 0.28, unsigned seed = 1);
/// Horizontal lines are zigzags: cells with one reflex corner.
mesh::RawMesh chevron_square(int n);
/// Neighbours interlock by pegs: cells with four reflex corners.
mesh::RawMesh pegboard_square(int n);
/// A checkerboard of coarse cells and cells cut in four: coarse ones have hanging points.
mesh::RawMesh hanging_square(int n);
/// Inner points are pairs joined by an edge of `ratio` of the cell size.
mesh::RawMesh short_edge_square(int n, double ratio = 1e-8);
/// Every edge bears two more points, on the straight line.
mesh::RawMesh collinear_square(int n);
/// Regular hexagons clipped by the square.
mesh::RawMesh honeycomb_square(int n);
/// Kershaw's mesh: smooth in plan, cells squeezed and sheared to aspect ratios of about 1/squeeze.
mesh::RawMesh kershaw_square(int n, double squeeze = 0.3);

struct MeshFamily {
  std::string name;
  std::function<mesh::RawMesh(int)> make;
};
/// All of the above with their default parameters.
const std::vector<MeshFamily>& ugly_families();

/// The unit square with its borders named; joints may be given as polylines.
mesh::Domain square_domain(const std::vector<mesh::JointLine>& joints = {});
/// A raw mesh of the unit square with edges, groups and joints.
mesh::Mesh square_mesh(mesh::RawMesh raw, const std::vector<mesh::JointLine>& joints = {});

}  // namespace ashlar::testing
