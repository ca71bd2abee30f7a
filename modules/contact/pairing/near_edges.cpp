#include "contact/pairing/near_edges.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.hpp"

namespace ashlar::contact {

using mesh::LipEdge;
using mesh::Point;

namespace {

// Beyond this many squares across, all edges are asked instead: the place is far from everything.
constexpr std::int64_t most_squares = 64;

}  // namespace

NearEdges::NearEdges(const std::vector<Point>& points, const std::vector<LipEdge>& edges)
    : points_(points), edges_(edges) {
  double total = 0;
  for (const LipEdge& edge : edges_) total += geometry::distance(points_[edge.from], points_[edge.to]);
  if (total > 0) side_ = 2 * total / static_cast<double>(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Point a = points_[edges_[i].from], b = points_[edges_[i].to];
    const Square low = square_of({std::min(a.x, b.x), std::min(a.y, b.y)});
    const Square high = square_of({std::max(a.x, b.x), std::max(a.y, b.y)});
    for (std::int64_t x = low.first; x <= high.first; ++x)
      for (std::int64_t y = low.second; y <= high.second; ++y) grid_[{x, y}].push_back(i);
  }
}

NearEdges::Square NearEdges::square_of(Point p) const {
  return {static_cast<std::int64_t>(std::floor(p.x / side_)),
          static_cast<std::int64_t>(std::floor(p.y / side_))};
}

void NearEdges::visit(Square low, Square high, const auto& visit) const {
  if (high.first - low.first > most_squares || high.second - low.second > most_squares) {
    for (std::size_t i = 0; i < edges_.size(); ++i) visit(i);
    return;
  }
  for (std::int64_t x = low.first; x <= high.first; ++x)
    for (std::int64_t y = low.second; y <= high.second; ++y)
      if (const auto found = grid_.find({x, y}); found != grid_.end())
        for (const std::size_t i : found->second) visit(i);
}

std::vector<std::size_t> NearEdges::within(Point place, double radius) const {
  std::vector<std::size_t> list;
  visit(square_of({place.x - radius, place.y - radius}), square_of({place.x + radius, place.y + radius}),
        [&](std::size_t i) { list.push_back(i); });
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

double NearEdges::nearest_distance(Point place) const {
  double least = INFINITY;
  // Squares up to `reach` away hold everything within that distance.
  double reach = side_;
  while (true) {
    visit(square_of({place.x - reach, place.y - reach}), square_of({place.x + reach, place.y + reach}),
          [&](std::size_t i) {
            const LipEdge& edge = edges_[i];
            least =
                std::min(least, geometry::distance_to_segment(place, points_[edge.from], points_[edge.to]));
          });
    if (least <= reach || reach > most_squares * side_) return least;
    reach *= 2;
  }
}

}  // namespace ashlar::contact
