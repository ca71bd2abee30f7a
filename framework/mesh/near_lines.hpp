#pragma once
// Joints that run nearer to another line (a joint, a border, a leg of their own) than the mesh can tell
// apart. Lines that meet or cross are legal: near the place where they meet, two edges along each of them, no
// distance is asked for. So angles down to asin(share / 2) pass.

#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"
#include "mesh/size_field.hpp"

namespace ashlar::mesh {

/// Least distance over the mesh's edge, where one cell reaches from line to line. Such a cell is ten times as
/// long as thick, so a hundred times, (length / thickness)², too stiff in bending: both lines then move as
/// one, and what lies between is not resolved. Two rows of cells between them are the user's wish: no limit.
inline constexpr double least_over_edge = 0.1;

/// Least distance over the size asked for, of generators whose cells shrink with the distance by themselves:
/// 2500 cells in place of one.
inline constexpr double least_over_size = 0.02;

/// Of a mesh with its joints, those of bodies that are meshed apart among them. Throws InputError, one
/// mistake for each two lines: their names, the distance where it is worst, the place, and the cure.
void require_lines_apart(const Mesh& mesh, const std::vector<JointLine>& joints);

/// The same before cells are made, by the sizes asked for.
void require_lines_apart(const Domain& domain, const SizeField& sizes);

}  // namespace ashlar::mesh
