#include "elasticity/cell_shape.hpp"

#include <cassert>

namespace ashlar::elasticity {

CellShape::CellShape(std::span<const Point> corners)
    : offset(corners.size()), mean(corners.size()), slope(corners.size()) {
  const std::size_t n = corners.size();
  assert(n >= 3);
  // Coordinates from the first corner keep their digits far from the origin.
  const Point origin = corners[0];
  double twice_area = 0, perimeter = 0, xx = 0, xy = 0, yy = 0;
  Point first_moment;
  for (std::size_t i = 0; i < n; ++i) mean[i] = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const Point a = corners[i] - origin, b = corners[j] - origin;
    const double z = cross(a, b), length = std::sqrt(dot(b - a, b - a));
    twice_area += z;
    first_moment = first_moment + z * (a + b);
    xx += z * (a.x * a.x + a.x * b.x + b.x * b.x);
    xy += z * (a.x * a.y + b.x * b.y + 0.5 * (a.x * b.y + b.x * a.y));
    yy += z * (a.y * a.y + a.y * b.y + b.y * b.y);
    perimeter += length;
    mean[i] += length;
    mean[j] += length;
  }
  area = 0.5 * twice_area;
  assert(area > 0);
  const Point c = (1 / (3 * twice_area)) * first_moment;
  second_moment = {xx / 12 - area * c.x * c.x, xy / 12 - area * c.x * c.y, yy / 12 - area * c.y * c.y};

  Point border_mean;
  for (std::size_t i = 0; i < n; ++i) {
    mean[i] /= 2 * perimeter;
    border_mean = border_mean + mean[i] * (corners[i] - origin);
  }
  centroid = c - border_mean;
  for (std::size_t i = 0; i < n; ++i) {
    const Point chord = corners[i + 1 < n ? i + 1 : 0] - corners[i > 0 ? i - 1 : n - 1];
    slope[i] = {chord.y / twice_area, -chord.x / twice_area};
    offset[i] = corners[i] - origin - border_mean;
  }
}

}  // namespace ashlar::elasticity
