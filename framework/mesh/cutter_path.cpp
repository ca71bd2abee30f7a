#include <algorithm>
#include <limits>
#include <set>

#include "geometry/polygon.hpp"
#include "mesh/cutter.hpp"

namespace ashlar::mesh {

namespace {

// Free points this near to the path, in parts of their shortest edge, move onto it.
constexpr double near_part = 1e-2;
// An extension beyond a tip ends in a corner if it would hit this near to it, in parts of the edge.
constexpr double corner_part = 0.2;

// Position on a–b where the ray from `origin` hits it, if ahead; `far` receives the distance in units of
// `ray`.
bool ray_hits(Point origin, Point ray, Point a, Point b, double& far, double& s) {
  const Point edge = b - a;
  const double determinant = geometry::cross(ray, edge);
  if (determinant == 0) return false;
  far = geometry::cross(a - origin, edge) / determinant;
  s = geometry::cross(a - origin, ray) / determinant;
  return far > 0 && s >= 0 && s <= 1;
}

}  // namespace

bool Cutter::fail(Point p) {
  failed_at_ = p;
  return false;
}

Cutter::Station Cutter::locate(Point p) {
  const auto near = cells_near(p, p, tolerance_);
  std::set<Index> candidates;
  for (const Index c : near) candidates.insert(cells_[c].begin(), cells_[c].end());
  Index nearest = -1;
  double least = std::numeric_limits<double>::max();
  for (const Index q : candidates) {
    const double d = geometry::distance(points_[q], p);
    if (d < least) least = d, nearest = q;
  }
  if (nearest >= 0 && least <= tolerance_) {
    if (!fixed_[nearest]) move(nearest, p);
    fix(nearest);
    return {nearest, points_[nearest]};
  }
  if (nearest >= 0 && !fixed_[nearest] && least < near_part * shortest_edge_at(nearest) && move(nearest, p)) {
    fix(nearest);
    return {nearest, p};
  }
  for (const Index c : near) {
    const auto& cell = cells_[c];
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Index a = cell[i], b = cell[(i + 1) % cell.size()];
      if (geometry::distance_to_segment(p, points_[a], points_[b]) <= tolerance_)
        return {split_edge(a, b, p), p};
    }
  }
  return {-1, p};
}

void Cutter::attract(Point a, Point b) {
  std::set<Index> candidates;
  for (const Index c : cells_near(a, b, tolerance_)) candidates.insert(cells_[c].begin(), cells_[c].end());
  for (const Index p : candidates) {
    if (fixed_[p]) continue;
    double t = 0;
    const double d = geometry::distance_to_segment(points_[p], a, b, &t);
    if (d > near_part * shortest_edge_at(p) || t <= 0 || t >= 1) continue;
    if (move(p, a + t * (b - a))) fix(p);
  }
}

void Cutter::cross_edges(Point a, Point b) {
  std::set<std::array<Index, 2>> edges;
  for (const Index c : cells_near(a, b, tolerance_)) {
    const auto& cell = cells_[c];
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Index p = cell[i], q = cell[(i + 1) % cell.size()];
      edges.insert({std::min(p, q), std::max(p, q)});
    }
  }
  const Point along = b - a;
  for (const auto& [p, q] : edges) {
    const double p_side = geometry::cross(along, points_[p] - a),
                 q_side = geometry::cross(along, points_[q] - a);
    if (!(p_side * q_side < 0)) continue;
    if (geometry::distance_to_segment(points_[p], a, b) <= tolerance_) continue;
    if (geometry::distance_to_segment(points_[q], a, b) <= tolerance_) continue;
    const Point hit = points_[p] + (p_side / (p_side - q_side)) * (points_[q] - points_[p]);
    const double t = geometry::dot(hit - a, along) / geometry::dot(along, along);
    if (t <= 0 || t >= 1) continue;
    if (geometry::distance(hit, a) <= tolerance_ || geometry::distance(hit, b) <= tolerance_) continue;
    split_edge(p, q, hit);
  }
}

// Mesh points strictly between two stations of the path, in order.
std::vector<Index> Cutter::points_between(const Station& a, const Station& b) const {
  std::set<Index> candidates;
  for (const Index c : cells_near(a.at, b.at, tolerance_))
    candidates.insert(cells_[c].begin(), cells_[c].end());
  std::vector<std::pair<double, Index>> found;
  for (const Index p : candidates) {
    if (p == a.point || p == b.point) continue;
    double t = 0;
    if (geometry::distance_to_segment(points_[p], a.at, b.at, &t) <= tolerance_ && t > 0 && t < 1)
      found.emplace_back(t, p);
  }
  std::sort(found.begin(), found.end());
  std::vector<Index> result;
  for (const auto& entry : found) result.push_back(entry.second);
  return result;
}

Index Cutter::common_cell(Index a, Index b, Point inside) const {
  for (const Index c : point_cells_[a]) {
    const auto& cell = cells_[c];
    if (std::find(cell.begin(), cell.end(), b) != cell.end() && geometry::contains(corners(c), inside))
      return c;
  }
  return -1;
}

Index Cutter::cell_around(Point p) const {
  for (const Index c : cells_near(p, p, 0)) {
    if (geometry::contains(corners(c), p)) return c;
  }
  return -1;
}

bool Cutter::visible(Index cell, Point from, Index corner) const {
  const auto& ring = cells_[cell];
  const Point ray = points_[corner] - from;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index a = ring[i], b = ring[(i + 1) % ring.size()];
    double far = 0, s = 0;
    if (a == corner || b == corner) continue;
    if (ray_hits(from, ray, points_[a], points_[b], far, s) && far <= 1 + 1e-6) return false;
  }
  return true;
}

// The border point of the cell straight ahead of a tip: a corner if one is near, else a new point on an edge.
Index Cutter::extend(Index cell, Point from, Point towards, Index avoid) {
  const auto ring = cells_[cell];
  double least = std::numeric_limits<double>::max(), position = 0;
  std::size_t hit = ring.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    double far = 0, s = 0;
    if (!ray_hits(from, towards, points_[ring[i]], points_[ring[(i + 1) % ring.size()]], far, s) ||
        far >= least)
      continue;
    least = far, position = s, hit = i;
  }
  if (hit == ring.size()) return -1;
  const Index a = ring[hit], b = ring[(hit + 1) % ring.size()];
  const Index corner = position < 0.5 ? a : b;
  const double off = std::min(position, 1 - position);
  if (corner != avoid && (off == 0 || (off < corner_part && visible(cell, from, corner)))) return corner;
  return split_edge(a, b, points_[a] + position * (points_[b] - points_[a]));
}

// Cuts the one cell that holds the inner stations between two mesh points; a missing end is extended to.
bool Cutter::cut_run(const Station* before, std::vector<Station> inside, const Station* after) {
  if (before && after && inside.empty() && has_edge(before->point, after->point)) return true;
  const Point probe = inside.empty() ? 0.5 * (before->at + after->at)
                      : before       ? 0.5 * (before->at + inside.front().at)
                      : after        ? 0.5 * (inside.back().at + after->at)
                                     : inside.front().at;
  Index cell = -1;
  if (before)
    cell = common_cell(before->point, after ? after->point : before->point, probe);
  else
    cell = after ? common_cell(after->point, after->point, probe) : cell_around(probe);
  if (cell < 0) return fail(probe);
  const std::size_t last = inside.size() - 1;
  Index start = before ? before->point : -1, end = after ? after->point : -1;
  if (!before) {
    const Point next = inside.size() > 1 ? inside[1].at : after ? after->at : inside[0].at + Point{-1, 0};
    start = extend(cell, inside[0].at, inside[0].at - next, end);
  }
  if (!after && start >= 0) {
    const Point previous = inside.size() > 1 ? inside[last - 1].at
                           : before          ? before->at
                                             : inside[0].at + Point{-1, 0};
    end = extend(cell, inside[last].at, inside[last].at - previous, start);
  }
  if (start < 0 || end < 0) return fail(probe);
  std::vector<Index> between;
  for (Station& station : inside) {
    station.point = static_cast<Index>(points_.size());
    points_.push_back(station.at);
    point_cells_.emplace_back();
    fixed_.push_back(true);
    between.push_back(station.point);
  }
  return split_cell(cell, start, between, end) || fail(probe);
}

bool Cutter::follow(const std::vector<Point>& path) {
  // A path that comes back to a point may do so inside one cell: each part passes the point once.
  for (auto first = path.begin(); first != path.end(); ++first) {
    if (std::find(first + 1, path.end(), *first) == path.end()) continue;
    return follow({path.begin(), first + 2}) && follow({first + 1, path.end()});
  }
  std::vector<Station> ends;
  for (const Point p : path) ends.push_back(locate(p));
  for (std::size_t i = 0; i + 1 < path.size(); ++i) attract(ends[i].at, ends[i + 1].at);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) cross_edges(ends[i].at, ends[i + 1].at);
  std::vector<Station> stations{ends.front()};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (const Index p : points_between(ends[i], ends[i + 1])) stations.push_back({p, points_[p]});
    stations.push_back(ends[i + 1]);
  }
  return cut_stations(stations);
}

// Parts between mesh points come first: what extends the tips must end at them and may cross the other tip's
// part.
bool Cutter::cut_stations(const std::vector<Station>& stations) {
  std::vector<Point> head, tail;
  const Station *first = nullptr, *before = nullptr;
  for (const Station& station : stations) {
    if (station.point < 0) {
      (before ? tail : head).push_back(station.at);
      continue;
    }
    std::vector<Station> inside;
    for (const Point p : std::exchange(tail, {})) inside.push_back({-1, p});
    if (before && !cut_run(before, std::move(inside), &station)) return false;
    if (!before) first = &station;
    before = &station;
    fix(station.point);
  }
  if (!first) {
    if (head.size() == 2) return cut_run(nullptr, {stations[0], stations[1]}, nullptr);
    return follow({head[0], head[1]}) && follow({head.begin() + 1, head.end()});
  }
  if (head.size() == 1 && !cut_run(nullptr, {stations.front()}, first)) return false;
  if (head.size() > 1 && !(follow({head.back(), first->at}) && follow(head))) return false;
  if (tail.empty()) return true;
  if (tail.size() == 1 && head.empty()) return cut_run(before, {stations.back()}, nullptr);
  return follow({before->at, tail.front()}) && (tail.size() == 1 || follow(tail));
}

}  // namespace ashlar::mesh
