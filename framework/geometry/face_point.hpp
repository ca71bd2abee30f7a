#pragma once
// A point strictly inside a face of an arrangement.

#include "geometry/arrangement.hpp"

namespace ashlar::geometry {

/// The middle of the widest stretch of a few horizontal lines through the face. Works on the rounded points.
Point point_inside(const Arrangement& arrangement, const Arrangement::Face& face);

}  // namespace ashlar::geometry
