#include "geometry/shape.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/predicates.hpp"

namespace ashlar::geometry {

namespace {

// Always counter-clockwise, so that two regions that share an arc get the same points from either side.
std::vector<Point> points_counter_clockwise(Point start, Point end, Point center, double chord, double turn) {
  const Point a = start - center, b = end - center;
  const double r0 = norm(a), r1 = norm(b);
  double sweep = std::atan2(cross(a, b), dot(a, b));
  if (sweep <= 0) sweep += 2 * std::numbers::pi;
  const double radius = std::max(r0, r1);
  const double by_chord = chord < 2 * radius ? 2 * std::asin(chord / (2 * radius)) : std::numbers::pi;
  const double parts = std::ceil(sweep / std::min(turn, by_chord) - 1e-9);
  const int count = std::max(start == end ? 3 : 1, static_cast<int>(std::min(parts, 1e6)));
  const double angle = std::atan2(a.y, a.x);
  std::vector<Point> points{start};
  for (int i = 1; i < count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double r = (1 - t) * r0 + t * r1;
    points.push_back(center + Point{r * std::cos(angle + t * sweep), r * std::sin(angle + t * sweep)});
  }
  points.push_back(end);
  return points;
}

}  // namespace

std::vector<Point> points_on_arc(Point start, Point end, const Arc& arc, double chord, double turn) {
  if (arc.counter_clockwise) return points_counter_clockwise(start, end, arc.center, chord, turn);
  auto points = points_counter_clockwise(end, start, arc.center, chord, turn);
  std::reverse(points.begin(), points.end());
  return points;
}

std::optional<Arc> arc_through(Point start, Point middle, Point end) {
  const int turn = orientation(start, middle, end);
  if (turn == 0) return std::nullopt;
  // Circumcentre about `start`, so that far-away arcs keep their digits.
  const Point a = middle - start, b = end - start;
  const double twice = 2 * cross(a, b);
  const Point center{(b.y * dot(a, a) - a.y * dot(b, b)) / twice,
                     (a.x * dot(b, b) - b.x * dot(a, a)) / twice};
  return Arc{start + center, turn > 0};
}

}  // namespace ashlar::geometry
