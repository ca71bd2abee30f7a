#include <algorithm>
#include <cmath>

#include "cells.hpp"
#include "geometry/polygon.hpp"
#include "mesh/adjacency.hpp"

namespace ashlar::meshing_voronoi {

namespace {

struct ShortEdge {
  double length = 0;
  Index a = -1, b = -1;
  bool operator<(const ShortEdge& other) const {
    return std::pair(length, std::pair(a, b)) < std::pair(other.length, std::pair(other.a, other.b));
  }
};

class Collapser {
 public:
  Collapser(Cells& cells, double tolerance);
  Index run();

 private:
  double area_of(Index cell);
  std::vector<ShortEdge> short_edges();
  Index root(Index point) const;
  const std::vector<Index>& ring_of(Index cell);
  std::vector<Index> cells_around(Index a, Index b) const;
  bool keeps_cells_sound(const std::vector<Index>& around, Index a, Index b, Point at);
  bool sound(const std::vector<Index>& ring, Index a, Index b, Point at);
  void rewrite();

  Cells& cells_;
  double tolerance_;
  mesh::Adjacency cells_of_point_;
  std::vector<Index> parent_;   ///< the point that a point was joined to
  std::vector<Index> partner_;  ///< circular list of the points that are now one
  std::vector<Index> ring_;
  std::vector<Point> places_;
};

mesh::Adjacency point_cells(const Cells& cells) {
  std::vector<Index> offsets(cells.points.size() + 1, 0);
  for (const Index corner : cells.corners) ++offsets[corner + 1];
  for (std::size_t p = 0; p < cells.points.size(); ++p) offsets[p + 1] += offsets[p];
  std::vector<Index> values(cells.corners.size()), next = offsets;
  for (Index c = 0; c < cells.size(); ++c) {
    for (Index k = cells.offsets[c]; k < cells.offsets[c + 1]; ++k) values[next[cells.corners[k]]++] = c;
  }
  return {std::move(offsets), std::move(values)};
}

Collapser::Collapser(Cells& cells, double tolerance)
    : cells_(cells), tolerance_(tolerance), cells_of_point_(point_cells(cells)) {
  parent_.resize(cells.points.size());
  for (std::size_t p = 0; p < parent_.size(); ++p) parent_[p] = static_cast<Index>(p);
  partner_ = parent_;
}

double Collapser::area_of(Index cell) {
  places_.clear();
  for (Index k = cells_.offsets[cell]; k < cells_.offsets[cell + 1]; ++k) {
    places_.push_back(cells_.points[cells_.corners[k]]);
  }
  return places_.empty() ? 0 : geometry::signed_area(places_);
}

// An edge is short if it is so for one of the cells beside it; the pair of its ends is kept once.
std::vector<ShortEdge> Collapser::short_edges() {
  std::vector<ShortEdge> edges;
  for (Index c = 0; c < cells_.size(); ++c) {
    const double limit = tolerance_ * std::sqrt(std::max(0.0, area_of(c)));
    for (Index k = cells_.offsets[c]; k < cells_.offsets[c + 1]; ++k) {
      const Index next = k + 1 < cells_.offsets[c + 1] ? k + 1 : cells_.offsets[c];
      const Index a = cells_.corners[k], b = cells_.corners[next];
      const double length = geometry::distance(cells_.points[a], cells_.points[b]);
      if (length < limit) edges.push_back({length, std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [](const ShortEdge& x, const ShortEdge& y) { return x.a == y.a && x.b == y.b; }),
              edges.end());
  return edges;
}

Index Collapser::root(Index point) const {
  while (parent_[point] != point) point = parent_[point];
  return point;
}

const std::vector<Index>& Collapser::ring_of(Index cell) {
  ring_.clear();
  for (Index k = cells_.offsets[cell]; k < cells_.offsets[cell + 1]; ++k) {
    const Index point = root(cells_.corners[k]);
    if (ring_.empty() || ring_.back() != point) ring_.push_back(point);
  }
  while (ring_.size() > 1 && ring_.front() == ring_.back()) ring_.pop_back();
  return ring_;
}

std::vector<Index> Collapser::cells_around(Index a, Index b) const {
  std::vector<Index> around;
  for (const Index start : {a, b}) {
    Index point = start;
    do {
      for (const Index c : cells_of_point_[point]) around.push_back(c);
      point = partner_[point];
    } while (point != start);
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

// With a and b at one place the ring must keep three corners, its sense, and touch itself nowhere.
bool Collapser::sound(const std::vector<Index>& ring, Index a, Index b, Point at) {
  places_.clear();
  int joined = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const bool one = ring[k] == a || ring[k] == b;
    const Index before = ring[(k + ring.size() - 1) % ring.size()];
    if (one && (before == a || before == b)) continue;
    joined += one;
    places_.push_back(one ? at : cells_.points[ring[k]]);
  }
  if (places_.size() < 3 || joined > 1) return false;
  const std::size_t n = places_.size();
  bool convex = true;
  for (std::size_t k = 0; k < n && convex; ++k) {
    const Point u = places_[(k + 1) % n] - places_[k], v = places_[(k + 2) % n] - places_[(k + 1) % n];
    convex = geometry::cross(u, v) > 0;
  }
  return convex || (geometry::signed_area(places_) > 0 && geometry::is_simple(places_));
}

bool Collapser::keeps_cells_sound(const std::vector<Index>& around, Index a, Index b, Point at) {
  for (const Index cell : around) {
    if (!sound(ring_of(cell), a, b, at)) return false;
  }
  return true;
}

void Collapser::rewrite() {
  std::vector<Index> offsets = {0}, corners;
  for (Index c = 0; c < cells_.size(); ++c) {
    const auto& ring = ring_of(c);
    corners.insert(corners.end(), ring.begin(), ring.end());
    offsets.push_back(static_cast<Index>(corners.size()));
  }
  cells_.offsets = std::move(offsets);
  cells_.corners = std::move(corners);
}

Index Collapser::run() {
  Index count = 0;
  for (const ShortEdge& edge : short_edges()) {
    Index a = root(edge.a), b = root(edge.b);
    if (a == b) continue;
    if (a > b) std::swap(a, b);
    const bool a_fixed = a < static_cast<Index>(cells_.fixed_points);
    if (b < static_cast<Index>(cells_.fixed_points)) continue;
    const Point at = a_fixed ? cells_.points[a] : 0.5 * (cells_.points[a] + cells_.points[b]);
    const std::vector<Index> around = cells_around(a, b);
    if (!keeps_cells_sound(around, a, b, at)) continue;
    parent_[b] = a;
    std::swap(partner_[a], partner_[b]);
    cells_.points[a] = at;
    ++count;
  }
  rewrite();
  return count;
}

}  // namespace

Index collapse_short_edges(Cells& cells, double tolerance) {
  return tolerance > 0 ? Collapser(cells, tolerance).run() : 0;
}

}  // namespace ashlar::meshing_voronoi
