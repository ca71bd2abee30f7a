#pragma once
// Exact signs of geometric expressions of double coordinates.

#include "geometry/point.hpp"

namespace ashlar::geometry {

/// Sign of the area of triangle a b c: 1 counter-clockwise, −1 clockwise, 0 exactly collinear.
int orientation(Point a, Point b, Point c);

/// p lies exactly on the closed segment a–b.
bool on_segment(Point p, Point a, Point b);

/// The closed segments a–b and c–d have a common point.
bool segments_touch(Point a, Point b, Point c, Point d);

}  // namespace ashlar::geometry
