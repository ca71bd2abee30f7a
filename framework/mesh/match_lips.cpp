#include "mesh/match_lips.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>

#include "geometry/polygon.hpp"
#include "mesh/insert.hpp"

namespace ashlar::mesh {

namespace {

constexpr double same_place = 1e-8;  // over the edge
constexpr double facing = 0.5;       // cosine of 60°

/// One lip as a line of numbers: edge i begins at start[i] and is 1 long; stretches do not touch.
class LipLine {
 public:
  LipLine(const Mesh& mesh, const std::vector<LipEdge>& edges) : mesh_(mesh), edges_(edges) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      start_.push_back(i == 0 ? 0 : start_.back() + (follows(i) ? 1 : 2));
  }

  struct Node {
    Index point = -1;
    double at = 0;
    Index before = -1, after = -1;  ///< edges, -1 at an end
  };

  std::vector<Node> nodes() const {
    std::vector<Node> list;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto edge = static_cast<Index>(i);
      if (!follows(i)) list.push_back({edges_[i].from, start_[i], -1, -1});
      list.back().after = edge;
      list.push_back({edges_[i].to, start_[i] + 1, edge, -1});
    }
    return list;
  }

  std::size_t count() const { return edges_.size(); }
  Point from(std::size_t i) const { return mesh_.points[edges_[i].from]; }
  Point to(std::size_t i) const { return mesh_.points[edges_[i].to]; }
  double start(std::size_t i) const { return start_[i]; }
  double length(Index edge) const { return edge < 0 ? 0 : geometry::distance(from(edge), to(edge)); }
  const LipEdge& edge(std::size_t i) const { return edges_[i]; }

  bool faces(std::size_t i, Point along) const {
    const Point d = to(i) - from(i);
    return dot(d, along) > facing * norm(d) * norm(along);
  }

  /// The edge before or after `i` in its stretch.
  std::optional<std::size_t> neighbour(std::size_t i, bool after) const {
    if (after) return i + 1 < count() && follows(i + 1) ? std::optional(i + 1) : std::nullopt;
    return follows(i) ? std::optional(i - 1) : std::nullopt;
  }

  /// The edge and the place on it that a number stands for; not for nodes.
  PointOnEdge place(double at, bool reversed) const {
    const auto after = std::upper_bound(start_.begin(), start_.end(), at);
    const std::size_t i = static_cast<std::size_t>(after - start_.begin()) - 1;
    const double t = at - start_[i];
    return {edges_[i].edge, reversed ? 1 - t : t};
  }

 private:
  bool follows(std::size_t i) const { return i > 0 && edges_[i - 1].to == edges_[i].from; }

  const Mesh& mesh_;
  const std::vector<LipEdge>& edges_;
  std::vector<double> start_;
};

/// A place on each lip; the point is -1 where one has to be inserted.
struct Match {
  std::array<double, 2> at = {0, 0};
  std::array<Index, 2> point = {-1, -1};
  double away = 0;
};

/// Where a node of one lip meets the other lip.
struct Foot {
  double at = 0, away = 0;
  Index point = -1;
};

std::optional<Foot> foot_on(const LipLine& lip, Point p, const std::vector<Point>& along, double own_length,
                            double reach) {
  const auto faces = [&](std::size_t i) {
    return std::ranges::any_of(along, [&](Point each) { return lip.faces(i, each); });
  };
  std::size_t best = 0;
  double t = 0, away = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lip.count(); ++i) {
    double here = 0;
    const double distance = geometry::distance_to_segment(p, lip.from(i), lip.to(i), &here);
    if (distance >= away || !faces(i)) continue;
    best = i, t = here, away = distance;
  }
  if (away > reach * std::max(own_length, lip.length(static_cast<Index>(best)))) return {};
  const Point d = lip.to(best) - lip.from(best);
  const double beyond = dot(p - lip.from(best), d) / dot(d, d);  // t without its limits
  if (t > same_place && t < 1 - same_place) return Foot{lip.start(best) + t, away, -1};
  const bool after = t > 0.5;
  const auto next = lip.neighbour(best, after);
  const bool bend = next && faces(*next);
  if (!bend && (beyond < -same_place || beyond > 1 + same_place)) return {};
  const LipEdge& edge = lip.edge(best);
  return Foot{lip.start(best) + (after ? 1 : 0), away, after ? edge.to : edge.from};
}

std::vector<Match> candidates(const std::array<LipLine, 2>& lips, const Mesh& mesh, double reach) {
  std::vector<Match> list;
  for (std::size_t side = 0; side < 2; ++side) {
    const LipLine &own = lips[side], &other = lips[1 - side];
    for (const auto& node : own.nodes()) {
      std::vector<Point> along;
      for (const Index edge : {node.before, node.after})
        if (edge >= 0) along.push_back(own.to(edge) - own.from(edge));
      const double length = std::max(own.length(node.before), own.length(node.after));
      const auto foot = foot_on(other, mesh.points[node.point], along, length, reach);
      if (!foot) continue;
      Match match;
      match.at[side] = node.at, match.point[side] = node.point;
      match.at[1 - side] = foot->at, match.point[1 - side] = foot->point;
      match.away = foot->away;
      list.push_back(match);
    }
  }
  std::ranges::stable_sort(list, {}, &Match::at);
  return list;
}

/// Two projections that cross, each of them from its own lip, become a pair of their points.
std::optional<Match> joined(const Match& a, const Match& b, const Mesh& mesh) {
  for (int side = 0; side < 2; ++side) {
    const int other = 1 - side;
    if (a.point[side] < 0 || a.point[other] >= 0 || b.point[other] < 0 || b.point[side] >= 0) continue;
    Match match;
    match.at[side] = a.at[side], match.point[side] = a.point[side];
    match.at[other] = b.at[other], match.point[other] = b.point[other];
    match.away = geometry::distance(mesh.points[match.point[0]], mesh.points[match.point[1]]);
    return match;
  }
  return {};
}

bool is_after(const Match& later, const Match& earlier) {
  return later.at[0] > earlier.at[0] + same_place && later.at[1] > earlier.at[1] + same_place;
}

/// Points that are there go before points that would be made, then the nearer before the farther.
bool is_better(const Match& a, const Match& b) {
  const auto rank = [](const Match& match) {
    return std::pair(std::ranges::count(match.point, -1), match.away);
  };
  return rank(a) < rank(b);
}

bool cross_over(const Match& a, const Match& b) {
  return (a.at[0] - b.at[0]) * (a.at[1] - b.at[1]) < 0;
}

/// Matches that grow along both lips.
std::vector<Match> in_order(const std::vector<Match>& all, const Mesh& mesh) {
  std::vector<Match> kept;
  for (Match match : all) {
    bool keep = true;
    while (keep && !kept.empty() && !is_after(match, kept.back())) {
      const Match last = kept.back();
      const auto both = cross_over(match, last) ? joined(last, match, mesh) : std::nullopt;
      keep = both || is_better(match, last);
      if (!keep) break;
      if (both) match = *both;
      kept.pop_back();
    }
    if (keep) kept.push_back(match);
  }
  return kept;
}

void pair_equal_points(JointLips& joint) {
  const auto add = [&](Index first, Index second) {
    const std::array<Index, 2> pair{first, second};
    if (first != second && (joint.pairs.empty() || joint.pairs.back() != pair)) joint.pairs.push_back(pair);
  };
  for (std::size_t i = 0; i < joint.lips[0].size(); ++i) {
    add(joint.lips[0][i].from, joint.lips[1][i].from);
    add(joint.lips[0][i].to, joint.lips[1][i].to);
  }
}

}  // namespace

Index match_lips(Mesh& mesh, std::size_t joint, double reach) {
  JointLips& lips = mesh.joints[joint];
  lips.pairs.clear();
  if (!lips.apart) {
    pair_equal_points(lips);
    return 0;
  }
  const std::array<LipLine, 2> lines{LipLine(mesh, lips.lips[0]), LipLine(mesh, lips.lips[1])};
  std::vector<Match> matches = in_order(candidates(lines, mesh, reach), mesh);
  std::vector<PointOnEdge> places;
  for (const Match& match : matches)
    for (std::size_t side = 0; side < 2; ++side)
      if (match.point[side] < 0) places.push_back(lines[side].place(match.at[side], side == 1));
  const std::vector<Index> made = insert_points(mesh, places);
  auto next = made.begin();
  for (Match& match : matches) {
    for (Index& point : match.point)
      if (point < 0) point = *next++;
    lips.pairs.push_back(match.point);
  }
  return static_cast<Index>(made.size());
}

}  // namespace ashlar::mesh
