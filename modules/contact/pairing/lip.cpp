#include "contact/pairing/lip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::contact {

using mesh::LipEdge;

namespace {

constexpr double face_to_face = -0.5;
// Normals (as distance of unit vectors) within 30°: chords of a curve, not a corner of the joint.
constexpr double smooth = 0.52;

}  // namespace

Lips::Lips(const model::Model& model, const mesh::JointLips& joint, int slave)
    : model_(model),
      slave_(joint.lips[slave]),
      master_(joint.lips[1 - slave]),
      slave_number_(slave),
      apart_(joint.apart),
      near_(model.mesh.points, master_) {}

Point Lips::normal(const LipEdge& edge) const {
  const auto [a, b] = model_.mesh.edge_points[edge.edge];
  const Point d = at(b) - at(a);
  return (-1 / geometry::norm(d)) * geometry::left_of(d);
}

// n ∝ E'_m n_m − E'_s n_s
Point Lips::contact_normal(const LipEdge& slave, const LipEdge& master) const {
  const Point n = modulus(master) * normal(master) - modulus(slave) * normal(slave);
  return (1 / geometry::norm(n)) * n;
}

double Lips::opposite(const LipEdge& slave, const LipEdge& master, Point place) const {
  const Point n = contact_normal(slave, master), x = at(master.from), d = at(master.to) - x;
  return geometry::cross(place - x, n) / geometry::cross(d, n);
}

Point Lips::slip_direction(const LipEdge& edge) const {
  const Point d = at(edge.to) - at(edge.from);
  return ((slave_number_ == 0 ? 1 : -1) / geometry::norm(d)) * d;
}

bool Lips::facing(const LipEdge& slave, const LipEdge& master) const {
  return geometry::dot(normal(master), normal(slave)) <= face_to_face;
}

// An edge's own nodes are numbered in the sense of its cell, which may run against the path.
std::vector<TraceNode> Lips::nodes(const LipEdge& edge) const {
  const model::Element& element = *model_.element;
  const bool along = model_.mesh.edge_points[edge.edge][0] == edge.from;
  std::vector<TraceNode> list = {{model_.dofs.of_point(edge.from), 0, at(edge.from)}};
  const int own = element.nodes().per_edge;
  for (int i = 0; i < own; ++i) {
    const int node = along ? i : own - 1 - i;
    const double t = along ? element.edge_node(node) : 1 - element.edge_node(node);
    list.push_back({model_.dofs.of_edge(edge.edge, node), t, place(edge, t)});
  }
  list.push_back({model_.dofs.of_point(edge.to), 1, at(edge.to)});
  return list;
}

void Lips::shape(const LipEdge& edge, double t, std::vector<double>& values) const {
  const model::Element& element = *model_.element;
  const bool along = model_.mesh.edge_points[edge.edge][0] == edge.from;
  const auto count = static_cast<std::size_t>(element.nodes().per_edge) + 2;
  // The element's order: start, end, own nodes.
  std::vector<double> by_cell(count);
  element.edge_shape(along ? t : 1 - t, by_cell);
  values.assign(count, 0);
  values.front() = by_cell[along ? 0 : 1];
  values.back() = by_cell[along ? 1 : 0];
  for (std::size_t i = 0; i + 2 < count; ++i) values[i + 1] = by_cell[along ? i + 2 : count - 1 - i];
}

std::vector<const LipEdge*> Lips::opposite_edges(const LipEdge& slave) const {
  // Directions of pressure stand within 60° off the shortest way: at most twice as far.
  const Point middle = place(slave, 0.5);
  const double radius = 2 * near_.nearest_distance(middle) + 3 * length(slave);
  std::vector<const LipEdge*> list;
  if (!std::isfinite(radius)) return list;
  for (const std::size_t i : near_.within(middle, radius))
    if (facing(slave, master_[i])) list.push_back(&master_[i]);
  return list;
}

const LipEdge* Lips::nearest_master(const LipEdge& slave, Point place, Point towards) const {
  const double slack = same_place * length(slave);
  const LipEdge* best = nullptr;
  double best_distance = std::numeric_limits<double>::infinity(), best_towards = best_distance;
  const auto take = [&](const LipEdge& edge) {
    const Point a = at(edge.from), b = at(edge.to);
    const double distance = geometry::distance_to_segment(place, a, b);
    if (distance > best_distance + slack || !facing(slave, edge)) return;
    const double from_towards = geometry::distance_to_segment(towards, a, b);
    if (distance >= best_distance - slack && from_towards >= best_towards - slack) return;
    best = &edge;
    best_distance = distance;
    best_towards = from_towards;
  };
  const double nearest = near_.nearest_distance(place);
  if (!std::isfinite(nearest)) return nullptr;
  // The nearest edge may belong to another leg of the joint: then farther ones are asked.
  for (double radius = nearest + 2 * length(slave); best_distance > radius; radius *= 4) {
    const std::vector<std::size_t> list = near_.within(place, radius);
    for (const std::size_t i : list) take(master_[i]);
    if (list.size() == master_.size()) break;
  }
  return best;
}

namespace {

/// Nodes of one edge: ∫ φ ds is half an edge each for order 1, Simpson's 1/6, 4/6, 1/6 for order 2.
void add_parts(const Lips& lips, const LipEdge& edge, int piece, std::vector<SlavePart>& parts) {
  const std::vector<TraceNode> nodes = lips.nodes(edge);
  const std::size_t first = parts.size();
  for (std::size_t i = 0; i < nodes.size(); ++i) parts.push_back({&edge, nodes[i], i, 0, 0, piece});
  const geometry::Rule& rule = geometry::gauss_legendre(lips.model().element->order() + 1);
  const double length = lips.length(edge);
  std::vector<double> shape;
  for (std::size_t q = 0; q < rule.at.size(); ++q) {
    lips.shape(edge, rule.at[q], shape);
    const double depth = lips.model().depth(lips.place(edge, rule.at[q]));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      parts[first + i].length += rule.weight[q] * length * shape[i];
      parts[first + i].area += rule.weight[q] * length * shape[i] * depth;
    }
  }
}

/// Both halves of a node stand on one stretch: its partner is the same, or where bodies were meshed apart,
/// near it.
bool same_point(const ContactPoint& a, const ContactPoint& b, bool apart) {
  if (geometry::distance(a.normal, b.normal) >= smooth || a.shares[0].dof != b.shares[0].dof) return false;
  if (apart) return true;
  if (a.shares.size() != b.shares.size()) return false;
  for (std::size_t i = 0; i < a.shares.size(); ++i)
    if (a.shares[i].dof != b.shares[i].dof || std::abs(a.shares[i].factor - b.shares[i].factor) > same_place)
      return false;
  return true;
}

}  // namespace

std::vector<SlavePart> slave_parts(const Lips& lips) {
  std::vector<SlavePart> parts;
  int piece = 0;
  for (std::size_t i = 0; i < lips.slave().size(); ++i) {
    if (i > 0 && lips.slave()[i - 1].to != lips.slave()[i].from) ++piece;
    add_parts(lips, lips.slave()[i], piece, parts);
  }
  return parts;
}

ContactPoint begin_point(const Lips& lips, const SlavePart& part, const LipEdge& master) {
  ContactPoint point;
  point.slave = lips.slave_number();
  point.normal = lips.contact_normal(*part.edge, master);
  const Point across = geometry::left_of(point.normal);
  point.tangent = (geometry::dot(across, lips.slip_direction(master)) < 0 ? -1 : 1) * across;
  point.length = part.length;
  point.area = part.area;
  point.modulus = std::min(lips.modulus(*part.edge), lips.modulus(master));
  point.s = part.edge->s_from + part.node.t * (part.edge->s_to - part.edge->s_from);
  point.at = part.node.at;
  point.piece = part.piece;
  return point;
}

void merge_shares(ContactPoint& one, const ContactPoint& other) {
  const double all = one.area + other.area;
  for (ContactPoint::Share& share : one.shares) share.factor *= one.area / all;
  for (const ContactPoint::Share& share : other.shares) {
    const auto found = std::ranges::find(one.shares, share.dof, &ContactPoint::Share::dof);
    const double factor = share.factor * other.area / all;
    if (found == one.shares.end())
      one.shares.push_back({share.dof, factor, share.at, share.slave});
    else
      found->factor += factor;
  }
  one.gap = (one.area * one.gap + other.area * other.gap) / all;
  one.overlap = std::max(one.overlap, other.overlap);
}

// On a curve the normal is that of both parts' pressure, L n = L₁ n₁ + L₂ n₂, so that a uniform pressure
// stays in balance.
void append(const Lips& lips, std::vector<ContactPoint>& points, ContactPoint point) {
  if (points.empty() || !same_point(points.back(), point, lips.apart())) {
    points.push_back(std::move(point));
    return;
  }
  ContactPoint& one = points.back();
  if (lips.apart()) merge_shares(one, point);
  const Point along = one.length * one.tangent + point.length * point.tangent;
  const Point across = one.length * one.normal + point.length * point.normal;
  one.area = (one.area + point.area) * geometry::norm(across) / (one.length + point.length);
  one.length = geometry::norm(across);
  one.normal = (1 / geometry::norm(across)) * across;
  one.tangent = (1 / geometry::norm(along)) * along;
  one.modulus = std::min(one.modulus, point.modulus);
}

void set_sizes(const Lips& lips, std::vector<ContactPoint>& points) {
  std::map<Index, std::pair<double, int>> edges;  // at each slave node: their lengths and number
  for (const LipEdge& edge : lips.slave())
    for (const TraceNode& node : lips.nodes(edge)) {
      edges[node.dof].first += lips.length(edge);
      ++edges[node.dof].second;
    }
  for (ContactPoint& point : points) {
    const auto [length, count] = edges.at(point.shares[0].dof);
    point.h = length / count;
  }
}

}  // namespace ashlar::contact
