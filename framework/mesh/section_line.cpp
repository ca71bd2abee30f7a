#include "mesh/section_line.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "geometry/polygon.hpp"
#include "mesh/chain.hpp"

namespace ashlar::mesh {

namespace {

using geometry::cross;
using geometry::dot;
using Side = LinePiece::Cell;

/// One segment of the path, from `low` to `high` where the path goes on or ends.
struct Segment {
  int number = 0;
  Point start, along;
  double length = 0, s = 0;  ///< s: of its start
  double low = 0, high = 0;
};

std::vector<Segment> segments_of(const SectionLine& line) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Segment> list;
  double s = 0;
  for (std::size_t i = 0; i + 1 < line.path.size(); ++i) {
    Segment each{static_cast<int>(i), line.path[i], line.direction(static_cast<int>(i)), 0, s, 0, 0};
    each.length = each.high = distance(line.path[i], line.path[i + 1]);
    if (i == 0) each.low = -infinity;
    if (i + 2 == line.path.size()) each.high = infinity;
    s += each.length;
    list.push_back(each);
  }
  return list;
}

/// One cell against one segment: `d` left of its line, `a` along it.
class CellCut {
 public:
  CellCut(const Mesh& mesh, const Segment& segment, double tolerance)
      : mesh_(mesh), segment_(segment), tolerance_(tolerance) {}

  void add_pieces(Index cell, std::vector<LinePiece>& pieces) {
    if (!reaches(cell)) return;
    find_stations(cell);
    for (std::size_t i = 0; i + 1 < stations_.size(); ++i) {
      const double from = stations_[i].s - segment_.s, to = stations_[i + 1].s - segment_.s;
      // What lies wholly beyond an end is no part of the line.
      if (std::min(to, segment_.length) - std::max(from, 0.0) <= tolerance_) continue;
      LinePiece piece{Side::crossed, cell, -1, segment_.number, stations_[i], stations_[i + 1]};
      if (follows_edge(0.5 * (from + to), piece) ||
          geometry::contains(corners_, segment_.start + 0.5 * (from + to) * segment_.along))
        pieces.push_back(piece);
    }
  }

 private:
  bool reaches(Index cell) {
    mesh_.corners(cell, corners_);
    d_.clear();
    a_.clear();
    for (const Point p : corners_) {
      d_.push_back(cross(segment_.along, p - segment_.start));
      a_.push_back(dot(segment_.along, p - segment_.start));
    }
    const auto [low, high] = std::minmax_element(d_.begin(), d_.end());
    const auto [near, far] = std::minmax_element(a_.begin(), a_.end());
    return *low <= tolerance_ && *high >= -tolerance_ && *near <= segment_.length && *far >= 0;
  }

  bool on(std::size_t corner) const { return std::abs(d_[corner]) <= tolerance_; }

  void add(double a, Index point, Index edge) {
    const Point at = point >= 0 ? mesh_.points[point] : segment_.start + a * segment_.along;
    stations_.push_back({segment_.s + a, at, point, edge});
  }

  void find_stations(Index cell) {
    cell_ = cell;
    stations_.clear();
    const auto points = mesh_.cell_points[cell], edges = mesh_.cell_edges[cell];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t next = (i + 1) % points.size();
      if (on(i)) add(a_[i], points[i], -1);
      if (on(i) || on(next) || (d_[i] > 0) == (d_[next] > 0)) continue;
      const double t = d_[i] / (d_[i] - d_[next]);
      add((1 - t) * a_[i] + t * a_[next], -1, edges[i]);
    }
    std::erase_if(stations_, [&](const LineStation& each) {
      const double a = each.s - segment_.s;
      return a < segment_.low - tolerance_ || a > segment_.high + tolerance_;
    });
    for (const double end : {segment_.low, segment_.high})
      if (std::isfinite(end) && std::ranges::none_of(stations_, [&](const LineStation& each) {
            return std::abs(each.s - segment_.s - end) <= tolerance_;
          }))
        add(end, -1, -1);
    std::ranges::stable_sort(stations_, {}, &LineStation::s);
    merge_stations();
  }

  /// Of stations within the tolerance one stays, a mesh point if there is one.
  void merge_stations() {
    std::size_t kept = 0;
    for (std::size_t i = 1; i < stations_.size(); ++i) {
      if (stations_[i].s - stations_[kept].s > tolerance_)
        stations_[++kept] = stations_[i];
      else if (stations_[kept].point < 0 && stations_[i].point >= 0)
        stations_[kept] = stations_[i];
    }
    if (!stations_.empty()) stations_.resize(kept + 1);
  }

  /// The edge that runs along the line at `a`, if any.
  bool follows_edge(double a, LinePiece& piece) const {
    for (std::size_t i = 0; i < d_.size(); ++i) {
      const std::size_t next = (i + 1) % d_.size();
      if (!on(i) || !on(next) || (a_[i] > a) == (a_[next] > a)) continue;
      piece.edge = mesh_.cell_edges[cell_][i];
      piece.side = a_[next] > a_[i] ? Side::left : Side::right;
      return true;
    }
    return false;
  }

  const Mesh& mesh_;
  const Segment& segment_;
  double tolerance_;
  Index cell_ = -1;
  std::vector<Point> corners_;
  std::vector<double> d_, a_;
  std::vector<LineStation> stations_;
};

/// Which side the touched cells lie on: first those with pieces, then those that only share a corner.
class Sides {
 public:
  Sides(const Mesh& mesh, SectionLine& line) : mesh_(mesh), line_(line) {}

  void find() {
    for (const LinePiece& piece : line_.pieces) {
      const auto [known, is_new] = side_.try_emplace(piece.cell, piece.side);
      if (!is_new && known->second != piece.side) known->second = Side::crossed;
      if (piece.edge >= 0) followed_.push_back(piece.edge);
    }
    mark_points();
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell)
      for (const Index p : mesh_.cell_points[cell])
        if (line_.on_line[p]) around_[p].push_back(cell);
    for (const auto& [point, cells] : around_) spread(point, cells);
    for (const auto& [cell, side] : side_) line_.cells.push_back({cell, side});
  }

 private:
  void mark_points() {
    line_.on_line.assign(mesh_.points.size(), 0);
    for (const LinePiece& piece : line_.pieces)
      for (const LineStation* end : {&piece.from, &piece.to})
        if (end->point >= 0) line_.on_line[end->point] = 1;
    for (const Index edge : followed_)
      for (const Index p : mesh_.edge_points[edge]) line_.on_line[p] = 1;
  }

  bool closed_fan(Index point, const std::vector<Index>& cells) const {
    for (const Index cell : cells)
      for (const Index edge : mesh_.cell_edges[cell])
        if (std::ranges::count(mesh_.edge_points[edge], point) > 0 && mesh_.edge_cells[edge][1] < 0)
          return false;
    return true;
  }

  // Around a point of the border a cell lies where its neighbour lies, unless the line is between them.
  // Around an inner point, where the line may end, the prolonged line decides.
  void spread(Index point, const std::vector<Index>& cells) {
    const bool closed = closed_fan(point, cells);
    for (bool changed = !closed; changed;) {
      changed = false;
      for (const Index cell : cells) {
        if (side_.contains(cell)) continue;
        const auto found = beside(point, cell);
        if (found == Side::crossed) continue;
        side_[cell] = found;
        changed = true;
      }
    }
    for (const Index cell : cells)
      if (!side_.contains(cell)) side_[cell] = line_.side(middle_of(cell)) > 0 ? Side::left : Side::right;
  }

  /// What a neighbour at `point` says of the cell; crossed: nothing.
  Side beside(Index point, Index cell) const {
    for (const Index edge : mesh_.cell_edges[cell]) {
      const auto [a, b] = mesh_.edge_points[edge];
      const auto [first, second] = mesh_.edge_cells[edge];
      if ((a != point && b != point) || second < 0 || std::ranges::count(followed_, edge) > 0) continue;
      const auto known = side_.find(first == cell ? second : first);
      if (known == side_.end()) continue;
      if (known->second != Side::crossed) return known->second;
      const double d = line_.side(mesh_.points[a == point ? b : a]);
      if (d != 0) return d > 0 ? Side::left : Side::right;
    }
    return Side::crossed;
  }

  Point middle_of(Index cell) const {
    Point sum;
    for (const Index p : mesh_.cell_points[cell]) sum = sum + mesh_.points[p];
    return (1.0 / mesh_.cell_points.count(cell)) * sum;
  }

  const Mesh& mesh_;
  SectionLine& line_;
  std::vector<Index> followed_;
  std::map<Index, Side> side_;
  std::map<Index, std::vector<Index>> around_;
};

/// The line goes on into the body beyond this end.
bool inside_at(const Mesh& mesh, const LineStation& end) {
  if (end.edge >= 0) return mesh.edge_cells[end.edge][1] >= 0;
  for (Index edge = 0; edge < mesh.edge_count() && end.point >= 0; ++edge)
    if (mesh.edge_cells[edge][1] < 0 && std::ranges::count(mesh.edge_points[edge], end.point) > 0)
      return false;
  return true;
}

}  // namespace

Point SectionLine::last() const {
  return std::ranges::max_element(pieces, {}, [](const LinePiece& p) { return p.to.s; })->to.at;
}

Point SectionLine::direction(int segment) const {
  const Point d = path[static_cast<std::size_t>(segment) + 1] - path[static_cast<std::size_t>(segment)];
  return (1 / norm(d)) * d;
}

double SectionLine::side(Point p) const {
  double nearest = std::numeric_limits<double>::infinity();
  Point normal, from;
  const int count = static_cast<int>(path.size()) - 1;
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Point along = direction(i);
    const double length = geometry::distance(path[at], path[at + 1]), a = dot(along, p - path[at]);
    const bool before = i > 0 && a < 0, after = i + 1 < count && a > length;
    const Point foot = before ? path[at] : after ? path[at + 1] : path[at] + a * along;
    const double away = geometry::distance(p, foot);
    if (away >= nearest) continue;
    nearest = away;
    from = foot;
    // At a kink the mean of both normals tells the sides apart.
    normal = geometry::left_of(along);
    if (before) normal = normal + geometry::left_of(direction(i - 1));
    if (after) normal = normal + geometry::left_of(direction(i + 1));
  }
  if (nearest <= tolerance) return 0;
  return dot(normal, p - from) > 0 ? nearest : -nearest;
}

bool SectionLine::body_on_right() const {
  return std::ranges::all_of(pieces, [](const LinePiece& p) { return p.side == Side::right; });
}

SectionLine trace(const Mesh& mesh, std::vector<Point> path, double tolerance) {
  SectionLine line;
  line.path = std::move(path);
  line.tolerance = tolerance;
  for (const Segment& segment : segments_of(line)) {
    CellCut cut(mesh, segment, tolerance);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) cut.add_pieces(cell, line.pieces);
  }
  std::ranges::stable_sort(line.pieces, [](const LinePiece& a, const LinePiece& b) {
    return a.from.s != b.from.s ? a.from.s < b.from.s : a.side < b.side;
  });
  if (line.pieces.empty()) return line;
  Sides(mesh, line).find();
  const auto end = std::ranges::max_element(line.pieces, {}, [](const LinePiece& p) { return p.to.s; });
  line.ends_inside = inside_at(mesh, line.pieces.front().from) || inside_at(mesh, end->to);
  return line;
}

std::vector<Point> path_along(const Mesh& mesh, const std::string& group, double tolerance) {
  const auto found = mesh.edge_groups.find(group);
  if (found == mesh.edge_groups.end() || found->second.empty()) return {};
  const std::string region = group.substr(0, group.find('.'));
  std::vector<Link> links;
  for (const Index edge : found->second) {
    const auto [a, b] = mesh.edge_points[edge];
    const Index second = mesh.edge_cells[edge][1];
    const bool turned = second >= 0 && mesh.regions[mesh.cell_region[second]] == region;
    links.push_back(turned ? Link{edge, b, a} : Link{edge, a, b});
  }
  links = chained(std::move(links), mesh.points);
  std::vector<Point> path{mesh.points[links.front().start]};
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (i > 0 && links[i].start != links[i - 1].end) return {};
    const Point next = mesh.points[links[i].end];
    // Points on a straight line are no corners.
    if (path.size() > 1) {
      const Point a = path[path.size() - 2], ab = next - a;
      if (std::abs(cross(ab, path.back() - a)) <= tolerance * norm(ab)) path.pop_back();
    }
    path.push_back(next);
  }
  if (path.front() == path.back()) return {};
  return path;
}

}  // namespace ashlar::mesh
