#include "mesh/cutter.hpp"

#include <algorithm>

#include "geometry/polygon.hpp"
#include "mesh/edge_table.hpp"

namespace ashlar::mesh {

namespace {

std::array<Index, 2> key(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Cutter::Cutter(RawMesh& raw, double tolerance)
    : raw_(raw),
      tolerance_(tolerance),
      points_(raw.points),
      point_cells_(raw.points.size()),
      fixed_(raw.points.size()) {
  for (Index c = 0; c < raw.cell_points.size(); ++c) {
    const auto row = raw.cell_points[c];
    cells_.emplace_back(row.begin(), row.end());
    boxes_.push_back(box_of(cells_.back()));
    for (const Index p : row) point_cells_[p].push_back(c);
  }
  for (const auto& [name, edges] : raw.edge_groups) {
    for (const auto& edge : edges) edge_names_[key(edge[0], edge[1])].push_back(name);
  }
  fix_geometry();
}

// Points that carry geometry stay: free borders, borders between regions, named edges and points.
void Cutter::fix_geometry() {
  const EdgeTable edges(raw_.cell_points, points_);
  for (Index e = 0; e < edges.size(); ++e) {
    const auto [first, second] = edges.cells[e];
    if (second >= 0 && raw_.cell_region[first] == raw_.cell_region[second]) continue;
    for (const Index p : edges.points[e]) fix(p);
  }
  for (const auto& [edge, names] : edge_names_) {
    for (const Index p : edge) fix(p);
  }
  for (const auto& [name, group] : raw_.point_groups) {
    for (const Index p : group) fix(p);
  }
}

Cutter::Box Cutter::box_of(const std::vector<Index>& cell) const {
  Box box{points_[cell[0]], points_[cell[0]]};
  for (const Index p : cell) {
    box.low = {std::min(box.low.x, points_[p].x), std::min(box.low.y, points_[p].y)};
    box.high = {std::max(box.high.x, points_[p].x), std::max(box.high.y, points_[p].y)};
  }
  return box;
}

std::vector<Index> Cutter::cells_near(Point a, Point b, double margin) const {
  const Point low{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin};
  const Point high{std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin};
  const Point normal = geometry::left_of(b - a);
  std::vector<Index> near;
  for (Index c = 0; c < static_cast<Index>(cells_.size()); ++c) {
    const Box& box = boxes_[c];
    if (box.low.x > high.x || box.high.x < low.x || box.low.y > high.y || box.high.y < low.y) continue;
    // The box lies on one side of the line if its centre is farther than its half-widths reach.
    const Point half = 0.5 * (box.high - box.low) + Point{margin, margin};
    const double reach = half.x * std::abs(normal.x) + half.y * std::abs(normal.y);
    if (std::abs(geometry::dot(0.5 * (box.low + box.high) - a, normal)) <= reach) near.push_back(c);
  }
  return near;
}

std::vector<Point> Cutter::corners(Index cell) const {
  std::vector<Point> result;
  for (const Index p : cells_[cell]) result.push_back(points_[p]);
  return result;
}

double Cutter::shortest_edge_at(Index point) const {
  double shortest = std::numeric_limits<double>::max();
  for (const Index c : point_cells_[point]) {
    const auto& cell = cells_[c];
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Index a = cell[i], b = cell[(i + 1) % cell.size()];
      if (a == point || b == point) shortest = std::min(shortest, geometry::distance(points_[a], points_[b]));
    }
  }
  return shortest;
}

// Moves a point unless a cell around it would cease to be simple.
bool Cutter::move(Index point, Point to) {
  const Point before = std::exchange(points_[point], to);
  for (const Index c : point_cells_[point]) {
    const auto ring = corners(c);
    if (geometry::signed_area(ring) > 0 && geometry::is_simple(ring)) continue;
    points_[point] = before;
    return false;
  }
  for (const Index c : point_cells_[point]) boxes_[c] = box_of(cells_[c]);
  return true;
}

Index Cutter::split_edge(Index a, Index b, Point at) {
  const auto made = static_cast<Index>(points_.size());
  points_.push_back(at);
  point_cells_.emplace_back();
  fixed_.push_back(true);
  const std::vector<Index> around = point_cells_[a];
  for (const Index c : around) {
    auto& cell = cells_[c];
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Index p = cell[i], q = cell[(i + 1) % cell.size()];
      if (!((p == a && q == b) || (p == b && q == a))) continue;
      cell.insert(cell.begin() + static_cast<std::ptrdiff_t>(i) + 1, made);
      point_cells_[made].push_back(c);
      break;
    }
  }
  if (const auto names = edge_names_.extract(key(a, b)); !names.empty()) {
    edge_names_[key(a, made)] = names.mapped();
    edge_names_[key(made, b)] = names.mapped();
  }
  return made;
}

bool Cutter::has_edge(Index a, Index b) const {
  for (const Index c : point_cells_[a]) {
    const auto& cell = cells_[c];
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Index p = cell[i], q = cell[(i + 1) % cell.size()];
      if ((p == a && q == b) || (p == b && q == a)) return true;
    }
  }
  return false;
}

// Cuts a cell from corner a through inner points to corner b; the part left of the cut becomes the new cell.
bool Cutter::split_cell(Index cell, Index a, const std::vector<Index>& between, Index b) {
  auto ring = cells_[cell];
  const auto first = std::find(ring.begin(), ring.end(), a);
  if (first == ring.end() || a == b) return false;
  std::rotate(ring.begin(), first, ring.end());
  const auto last = std::find(ring.begin(), ring.end(), b);
  if (last == ring.end()) return false;
  std::vector<Index> right(ring.begin(), last + 1), left(last, ring.end());
  right.insert(right.end(), between.rbegin(), between.rend());
  left.push_back(a);
  left.insert(left.end(), between.begin(), between.end());
  for (const auto* part : {&right, &left}) {
    std::vector<Point> corners;
    for (const Index p : *part) corners.push_back(points_[p]);
    if (!(geometry::signed_area(corners) > 0) || !geometry::is_simple(corners)) return false;
  }
  const auto made = static_cast<Index>(cells_.size());
  for (const Index p : ring) std::erase(point_cells_[p], cell);
  for (const Index p : right) point_cells_[p].push_back(cell);
  for (const Index p : left) point_cells_[p].push_back(made);
  cells_[cell] = std::move(right);
  boxes_[cell] = box_of(cells_[cell]);
  boxes_.push_back(box_of(left));
  cells_.push_back(std::move(left));
  raw_.cell_region.push_back(raw_.cell_region[cell]);
  return true;
}

void Cutter::finish() {
  Adjacency cells;
  for (const auto& cell : cells_) cells.append(cell);
  raw_.cell_points = std::move(cells);
  for (auto& [name, edges] : raw_.edge_groups) edges.clear();
  for (const auto& [edge, names] : edge_names_) {
    for (const auto& name : names) raw_.edge_groups[name].push_back(edge);
  }
}

}  // namespace ashlar::mesh
