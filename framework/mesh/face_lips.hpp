#pragma once
// Lips of joints between bodies that are meshed apart: the edges of two named borders.

#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// Adds the lips of every joint that has `faces`, with all edges of both faces, also those that can never
/// touch, and orders the mesh's joints as `joints`. Edge groups "joint.side" go with them. The first lip runs
/// with its body on the left, s being its arc length; the second runs along it, with its body on the right. s
/// of its points is that of the projection onto the first lip (beyond its ends: onto the tangent there) where
/// the lips face each other, counted from the nearest point on both ways; where they do not, and where
/// projections would come back, s goes on by the lip's own length or a thousandth of it: it always grows. A
/// closed face is cut where it is farthest from the other. Arcs of the drawn shapes stay known to the edges.
/// Throws InputError: no such edges, edges that are not on a border, faces of one body.
void add_face_joints(Mesh& mesh, const std::vector<JointLine>& joints);

}  // namespace ashlar::mesh
