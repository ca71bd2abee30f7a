#include "geometry/snap.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/polygon.hpp"

namespace ashlar::geometry {

namespace {

// Points in bins of width `snap`: all within `snap` of p lie in the 3 × 3 bins around it.
class Merger {
 public:
  explicit Merger(double snap) : snap_(snap) {}

  // The first point that was given within `snap` of p; p itself if there is none.
  Point add(Point p) {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const auto bin = bins_.find({std::floor(p.x / snap_) + i, std::floor(p.y / snap_) + j});
        if (bin == bins_.end()) continue;
        for (const Point q : bin->second) {
          if (distance(p, q) < snap_) return q;
        }
      }
    }
    bins_[{std::floor(p.x / snap_), std::floor(p.y / snap_)}].push_back(p);
    points_.push_back(p);
    return p;
  }
  std::vector<Point>& points() { return points_; }

 private:
  double snap_;
  std::map<std::pair<double, double>, std::vector<Point>> bins_;
  std::vector<Point> points_;
};

// Cuts a piece at the points (ordered by x) that it passes nearer than `snap`.
void append_split(const Piece& piece, std::span<const Point> points, double snap,
                  std::vector<Piece>& result) {
  const auto [low, high] = std::minmax(piece.from.x, piece.to.x);
  const auto [bottom, top] = std::minmax(piece.from.y, piece.to.y);
  std::vector<std::pair<double, Point>> stops;
  auto p =
      std::lower_bound(points.begin(), points.end(), low - snap, [](Point q, double x) { return q.x < x; });
  for (; p != points.end() && p->x <= high + snap; ++p) {
    if (p->y < bottom - snap || p->y > top + snap || *p == piece.from || *p == piece.to) continue;
    double t = 0;
    if (distance_to_segment(*p, piece.from, piece.to, &t) < snap) stops.emplace_back(t, *p);
  }
  std::sort(stops.begin(), stops.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  stops.emplace_back(1.0, piece.to);
  Point from = piece.from;
  for (const auto& stop : stops)
    result.push_back({std::exchange(from, stop.second), stop.second, piece.sources});
}

}  // namespace

void snap_pieces(std::vector<Piece>& pieces, double snap) {
  Merger merger(snap);
  for (Piece& piece : pieces) {
    piece.from = merger.add(piece.from);
    piece.to = merger.add(piece.to);
  }
  std::erase_if(pieces, [](const Piece& piece) { return piece.from == piece.to; });
  auto& points = merger.points();
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::vector<Piece> split;
  for (const Piece& piece : pieces) append_split(piece, points, snap, split);
  pieces = std::move(split);
}

bool has_close_points(std::span<const Point> points, double snap) {
  Merger merger(snap);
  for (const Point p : points) {
    const std::size_t before = merger.points().size();
    merger.add(p);
    if (merger.points().size() == before) return true;
  }
  return false;
}

}  // namespace ashlar::geometry
