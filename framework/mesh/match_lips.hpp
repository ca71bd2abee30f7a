#pragma once
// Node insertion: points of each lip become hanging points of the other, so that both have the same nodes.

#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// Makes the points of a joint's lips correspond and records them in its `pairs`; returns how many points
/// were inserted. Every point of one lip is projected perpendicularly onto the other, edges that face it
/// within 60° alone, and inserted there unless a point is nearer than 1e-8 of the edge: then these two are a
/// pair. (Elements are tested on edges as short as that, and a pair that is off by δ errs by no more than
/// δ/h.) Where a bend of the other lip has no perpendicular to the point, its corner is the partner. Points
/// farther off than `reach` times the longer of their own edges and the edge opposite stay alone, and so do
/// those beyond the other lip's ends. Correspondences never cross: where the lips lie apart and are not
/// parallel, two projections that would cross make their two points a pair. Lips that split a mesh have the
/// same points already.
Index match_lips(Mesh& mesh, std::size_t joint, double reach);

}  // namespace ashlar::mesh
