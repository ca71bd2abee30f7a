#include "contact/pairing/node_to_segment/node_to_segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/log.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::contact {

namespace {

using mesh::LipEdge;

// Round-off of coordinates relative to an edge: positions nearer than this are the same.
constexpr double same_place = 1e-9;
// Normals (as distance of unit vectors) within 30°: chords of a curve, not a corner of the joint.
constexpr double smooth = 0.52;
// Lips that face each other within 60°; others belong to another leg of the joint.
constexpr double facing = -0.5;

/// One end of a slave edge with the half of the edge that it stands for.
struct Half {
  const LipEdge* edge = nullptr;
  Index point = -1, other = -1;
  double s = 0;
  int piece = 0;
};

struct Lips {
  const model::Model& model;
  const std::vector<LipEdge>& slave;
  const std::vector<LipEdge>& master;
  bool slave_first = true;

  Point at(Index point) const { return model.mesh.points[point]; }
  double length(const LipEdge& edge) const { return geometry::distance(at(edge.from), at(edge.to)); }
  /// Outward unit normal: border edges have their body on the left.
  Point normal(const LipEdge& edge) const {
    const auto [a, b] = model.mesh.edge_points[edge.edge];
    const Point d = at(b) - at(a);
    return (-1 / geometry::norm(d)) * geometry::left_of(d);
  }
};

std::vector<Half> halves(const Lips& lips) {
  std::vector<Half> list;
  int piece = 0;
  for (std::size_t i = 0; i < lips.slave.size(); ++i) {
    const LipEdge& edge = lips.slave[i];
    if (i > 0 && lips.slave[i - 1].to != edge.from) ++piece;
    list.push_back({&edge, edge.from, edge.to, edge.s_from, piece});
    list.push_back({&edge, edge.to, edge.from, edge.s_to, piece});
  }
  return list;
}

/// The master edge nearest to the half's point; of equally near ones (corners, crossings) the one nearest to
/// the middle of the half.
const LipEdge* facing_edge(const Lips& lips, const Half& half) {
  const Point point = lips.at(half.point);
  const Point middle = 0.75 * point + 0.25 * lips.at(half.other);
  const Point normal = lips.normal(*half.edge);
  const double slack = same_place * lips.length(*half.edge);
  const LipEdge* best = nullptr;
  double best_distance = std::numeric_limits<double>::infinity(), best_middle = best_distance;
  for (const LipEdge& edge : lips.master) {
    if (geometry::dot(lips.normal(edge), normal) > facing) continue;
    const Point a = lips.at(edge.from), b = lips.at(edge.to);
    const double distance = geometry::distance_to_segment(point, a, b);
    if (distance > best_distance + slack) continue;
    const double from_middle = geometry::distance_to_segment(middle, a, b);
    if (distance >= best_distance - slack && from_middle >= best_middle - slack) continue;
    best = &edge;
    best_distance = distance;
    best_middle = from_middle;
  }
  return best;
}

/// The contact point of one half. Nothing if the half lies beyond the master lip; no shares at a welded tip.
std::optional<ContactPoint> project(const Lips& lips, const Half& half) {
  const LipEdge* master = facing_edge(lips, half);
  if (!master) return {};
  const Point x_s = lips.at(half.point), x_m = lips.at(master->from);
  const Point edge = lips.at(master->to) - x_m;
  const double l = geometry::norm(edge);
  // ξ = (x_{m+1} − x_m)·(x_s − x_m)/l²
  double xi = geometry::dot(edge, x_s - x_m) / (l * l);
  if (xi < -1e-6 || xi > 1 + 1e-6) return {};
  if (std::abs(xi) < same_place) xi = 0;
  if (std::abs(xi - 1) < same_place) xi = 1;
  ContactPoint point;
  point.normal = lips.normal(*master);
  point.tangent = ((lips.slave_first ? 1 : -1) / l) * edge;
  // g = n·(x_s − (1−ξ) x_m − ξ x_{m+1})
  point.gap = geometry::dot(point.normal, x_s - x_m - xi * edge);
  if (std::abs(point.gap) < same_place * l) point.gap = 0;
  point.length = lips.length(*half.edge) / 2;
  point.modulus = std::min(lips.model.material(half.edge->cell).plane_modulus(),
                           lips.model.material(master->cell).plane_modulus());
  point.s = half.s;
  point.at = x_s;
  point.piece = half.piece;
  const bool welded = (xi == 0 && master->from == half.point) || (xi == 1 && master->to == half.point);
  if (welded) return point;
  point.shares = {{half.point, 1}};
  if (xi < 1) point.shares.push_back({master->from, xi - 1});
  if (xi > 0) point.shares.push_back({master->to, -xi});
  return point;
}

bool same_jump(const ContactPoint& a, const ContactPoint& b) {
  if (a.shares.size() != b.shares.size()) return false;
  for (std::size_t i = 0; i < a.shares.size(); ++i)
    if (a.shares[i].point != b.shares[i].point || a.shares[i].factor != b.shares[i].factor) return false;
  return geometry::distance(a.normal, b.normal) < smooth;
}

/// Both halves of a point on a straight or curved lip are one contact point; at a corner they stay two. On a
/// curve its normal is that of both halves' pressure, L n = L₁ n₁ + L₂ n₂, so that a uniform pressure stays
/// in balance.
void append(std::vector<ContactPoint>& points, ContactPoint point) {
  if (points.empty() || !same_jump(points.back(), point)) {
    points.push_back(std::move(point));
    return;
  }
  ContactPoint& one = points.back();
  const Point along = one.length * one.tangent + point.length * point.tangent;
  const Point across = one.length * one.normal + point.length * point.normal;
  one.length = geometry::norm(across);
  one.normal = (1 / geometry::norm(across)) * across;
  one.tangent = (1 / geometry::norm(along)) * along;
  one.modulus = std::min(one.modulus, point.modulus);
}

/// h, and the weights from the lengths.
void set_sizes(const Lips& lips, NodeToSegment::Weight weight, std::vector<ContactPoint>& points) {
  std::map<Index, std::pair<double, int>> edges;  // at each slave point: their lengths and number
  double total = 0;
  for (const LipEdge& edge : lips.slave) {
    const double length = lips.length(edge);
    total += length;
    for (const Index end : {edge.from, edge.to}) {
      edges[end].first += length;
      ++edges[end].second;
    }
  }
  const double mean = total / static_cast<double>(lips.slave.size());
  for (ContactPoint& point : points) {
    const auto [length, count] = edges.at(point.shares[0].point);
    point.h = length / count;
    point.weight =
        weight == NodeToSegment::Weight::tributary ? point.length : mean * point.length / (length / 2);
  }
}

void report(const std::string& joint, std::size_t beyond, const std::vector<ContactPoint>& points) {
  const auto between = std::count_if(points.begin(), points.end(),
                                     [](const ContactPoint& point) { return point.shares.size() > 2; });
  if (beyond > 0)
    core::log().warning("joint '" + joint + "': " + std::to_string(beyond) +
                        " half edges of the slave lip face no edge of the other lip and carry no contact");
  if (between > 0)
    core::log().warning("joint '" + joint + "': the lips' points do not match at " + std::to_string(between) +
                        " places; node_to_segment passes a uniform pressure only roughly there");
}

}  // namespace

std::vector<ContactPoint> NodeToSegment::pair(const model::Model& model, const mesh::JointLips& joint,
                                              int slave) const {
  const Lips lips{model, joint.lips[slave], joint.lips[1 - slave], slave == 0};
  std::vector<ContactPoint> points;
  std::size_t beyond = 0;
  for (const Half& half : halves(lips)) {
    std::optional<ContactPoint> point = project(lips, half);
    if (!point)
      ++beyond;
    else if (!point->shares.empty())
      append(points, std::move(*point));
  }
  set_sizes(lips, weight_, points);
  report(joint.name, beyond, points);
  return points;
}

}  // namespace ashlar::contact
