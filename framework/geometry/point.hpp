#pragma once
// Points and vectors of the plane.

#include <cmath>
#include <cstdint>

namespace ashlar::geometry {

/// Index of points, edges, cells and unknowns; -1 means none.
using Index = std::int32_t;

struct Point {
  double x = 0;
  double y = 0;
  bool operator==(const Point&) const = default;
};

inline Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double s, Point a) {
  return {s * a.x, s * a.y};
}
inline double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
/// z component of a × b.
inline double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
inline double norm(Point a) {
  return std::hypot(a.x, a.y);
}
inline double distance(Point a, Point b) {
  return norm(b - a);
}
/// a turned by +90°: the left normal of a direction.
inline Point left_of(Point a) {
  return {-a.y, a.x};
}

}  // namespace ashlar::geometry
