#include "geometry/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace ashlar::geometry {

int orientation(Point a, Point b, Point c) {
  // Shewchuk's static filter (1997): beyond this bound the rounded determinant has the right sign.
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
  const double area = left - right;
  if (area > bound && bound > 1e-280) return 1;
  if (area < -bound && bound > 1e-280) return -1;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto sign =
      CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y));
  return static_cast<int>(sign);
}

bool on_segment(Point p, Point a, Point b) {
  if (p.x < std::min(a.x, b.x) || p.x > std::max(a.x, b.x)) return false;
  if (p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y)) return false;
  return orientation(a, b, p) == 0;
}

bool segments_touch(Point a, Point b, Point c, Point d) {
  const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
  const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return on_segment(c, a, b) || on_segment(d, a, b) || on_segment(a, c, d) || on_segment(b, c, d);
}

}  // namespace ashlar::geometry
