#include "geometry/face_point.hpp"

#include <algorithm>

namespace ashlar::geometry {

namespace {

std::vector<std::pair<Point, Point>> border_of(const Arrangement& arrangement,
                                               const Arrangement::Face& face) {
  std::vector<std::pair<Point, Point>> border;
  auto add = [&](const std::vector<Index>& ring) {
    for (const Index entry : ring) {
      const auto& s = arrangement.segments[static_cast<std::size_t>(entry < 0 ? -1 - entry : entry)];
      border.emplace_back(arrangement.points[static_cast<std::size_t>(s.from)],
                          arrangement.points[static_cast<std::size_t>(s.to)]);
    }
  };
  add(face.outer);
  for (const auto& ring : face.inner) add(ring);
  return border;
}

}  // namespace

Point point_inside(const Arrangement& arrangement, const Arrangement::Face& face) {
  const auto border = border_of(arrangement, face);
  std::vector<double> levels;
  for (const auto& [a, b] : border) levels.insert(levels.end(), {a.y, b.y});
  std::sort(levels.begin(), levels.end());
  std::vector<std::pair<double, double>> gaps;  // height, middle
  for (std::size_t i = 1; i < levels.size(); ++i) {
    gaps.emplace_back(levels[i] - levels[i - 1], 0.5 * (levels[i] + levels[i - 1]));
  }
  const std::size_t tried = std::min<std::size_t>(gaps.size(), 8);
  std::partial_sort(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(tried), gaps.end(),
                    std::greater<>());
  Point best = border.front().first;
  double best_room = -1;
  for (std::size_t g = 0; g < tried; ++g) {
    const auto [height, y] = gaps[g];
    std::vector<double> crossings;
    for (const auto& [a, b] : border) {
      if ((a.y < y) != (b.y < y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double room = std::min(height, crossings[i + 1] - crossings[i]);
      if (room <= best_room) continue;
      best_room = room;
      best = {0.5 * (crossings[i] + crossings[i + 1]), y};
    }
  }
  return best;
}

}  // namespace ashlar::geometry
