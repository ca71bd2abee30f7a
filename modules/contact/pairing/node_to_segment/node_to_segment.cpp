#include "contact/pairing/node_to_segment/node_to_segment.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/pairing/lip.hpp"
#include "core/log.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::contact {

namespace {

using mesh::LipEdge;

// Normals (as distance of unit vectors) within 30°: chords of a curve, not a corner of the joint.
constexpr double smooth = 0.52;
// Places beyond a master edge by more than this share of it lie beyond the lip.
constexpr double beyond_edge = 1e-6;

/// A node of a slave edge with what it stands for of that edge.
struct Part {
  const LipEdge* edge = nullptr;
  TraceNode node;
  double length = 0;  ///< ∫ φ ds
  double area = 0;    ///< ∫ φ depth ds
  int piece = 0;
};

/// Nodes of one edge: ∫ φ ds is half an edge each for order 1, Simpson's 1/6, 4/6, 1/6 for order 2.
void add_parts(const Lips& lips, const LipEdge& edge, int piece, std::vector<Part>& parts) {
  const std::vector<TraceNode> nodes = lips.nodes(edge);
  const std::size_t first = parts.size();
  for (const TraceNode& node : nodes) parts.push_back({&edge, node, 0, 0, piece});
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

std::vector<Part> slave_parts(const Lips& lips) {
  std::vector<Part> parts;
  int piece = 0;
  for (std::size_t i = 0; i < lips.slave().size(); ++i) {
    if (i > 0 && lips.slave()[i - 1].to != lips.slave()[i].from) ++piece;
    add_parts(lips, lips.slave()[i], piece, parts);
  }
  return parts;
}

/// The contact point of one node. Nothing if it lies beyond the master lip; no shares at a welded tip.
std::optional<ContactPoint> project(const Lips& lips, const Part& part) {
  const Point x_s = part.node.at;
  const Point inward = 0.75 * x_s + 0.25 * lips.place(*part.edge, 1 - std::round(part.node.t));
  const LipEdge* master = lips.nearest_master(*part.edge, x_s, inward);
  if (!master) return {};
  const Point x_m = lips.at(master->from), edge = lips.at(master->to) - x_m;
  const double l = geometry::norm(edge);
  // ξ = (x_{m+1} − x_m)·(x_s − x_m)/l²
  double xi = geometry::dot(edge, x_s - x_m) / (l * l);
  if (xi < -beyond_edge || xi > 1 + beyond_edge) return {};
  for (const TraceNode& node : lips.nodes(*master))
    if (std::abs(xi - node.t) < same_place) xi = node.t;
  ContactPoint point;
  point.slave = lips.slave_number();
  point.normal = lips.normal(*master);
  point.tangent = lips.slip_direction(*master);
  // g = n·(x_s − (1−ξ) x_m − ξ x_{m+1})
  point.gap = geometry::dot(point.normal, x_s - x_m - xi * edge);
  if (std::abs(point.gap) < same_place * l) point.gap = 0;
  point.length = part.length;
  point.area = part.area;
  point.modulus = std::min(lips.modulus(*part.edge), lips.modulus(*master));
  point.s = part.edge->s_from + part.node.t * (part.edge->s_to - part.edge->s_from);
  point.at = x_s;
  point.piece = part.piece;
  std::vector<ContactPoint::Share> shares = {{part.node.dof, 1, x_s}};
  std::vector<double> shape;
  lips.shape(*master, xi, shape);
  const std::vector<TraceNode> nodes = lips.nodes(*master);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::abs(shape[i]) < same_place) continue;
    if (nodes[i].dof == part.node.dof) return point;  // welded
    shares.push_back({nodes[i].dof, -shape[i], nodes[i].at});
  }
  point.shares = std::move(shares);
  return point;
}

bool same_jump(const ContactPoint& a, const ContactPoint& b) {
  if (a.shares.size() != b.shares.size()) return false;
  for (std::size_t i = 0; i < a.shares.size(); ++i)
    if (a.shares[i].dof != b.shares[i].dof || std::abs(a.shares[i].factor - b.shares[i].factor) > same_place)
      return false;
  return geometry::distance(a.normal, b.normal) < smooth;
}

/// Both parts of a node on a straight or curved lip are one contact point; at a corner they stay two. On a
/// curve its normal is that of both parts' pressure, L n = L₁ n₁ + L₂ n₂, so that a uniform pressure stays
/// in balance.
void append(std::vector<ContactPoint>& points, ContactPoint point) {
  if (points.empty() || !same_jump(points.back(), point)) {
    points.push_back(std::move(point));
    return;
  }
  ContactPoint& one = points.back();
  const Point along = one.length * one.tangent + point.length * point.tangent;
  const Point across = one.length * one.normal + point.length * point.normal;
  one.area = (one.area + point.area) * geometry::norm(across) / (one.length + point.length);
  one.length = geometry::norm(across);
  one.normal = (1 / geometry::norm(across)) * across;
  one.tangent = (1 / geometry::norm(along)) * along;
  one.modulus = std::min(one.modulus, point.modulus);
}

/// The paper's weight: the lip's mean edge length for every node, divided between its parts at corners.
void make_equal(const Lips& lips, const std::vector<Part>& parts, std::vector<ContactPoint>& points) {
  std::map<Index, double> tributary;
  double total = 0;
  for (const Part& part : parts) {
    tributary[part.node.dof] += part.length;
    total += part.length;
  }
  const double mean = total / static_cast<double>(lips.slave().size());
  for (ContactPoint& point : points) {
    point.weight = mean / tributary.at(point.shares[0].dof);
    point.area *= point.weight;
  }
}

void report(const std::string& joint, std::size_t beyond, const std::vector<ContactPoint>& points) {
  const auto between = std::count_if(points.begin(), points.end(),
                                     [](const ContactPoint& point) { return point.shares.size() > 2; });
  if (beyond > 0)
    core::log().warning("joint '" + joint + "': " + std::to_string(beyond) +
                        " parts of the slave lip's edges face no edge of the other lip and carry no contact");
  if (between > 0)
    core::log().warning("joint '" + joint + "': the lips' points do not match at " + std::to_string(between) +
                        " places; node_to_segment passes a uniform pressure only roughly there: "
                        "node_insertion or mortar pass it exactly");
}

}  // namespace

std::vector<ContactPoint> NodeToSegment::pass(const model::Model& model, const mesh::JointLips& joint,
                                              int slave) const {
  const Lips lips(model, joint, slave);
  std::vector<ContactPoint> points;
  std::size_t beyond = 0;
  const std::vector<Part> parts = slave_parts(lips);
  for (const Part& part : parts) {
    std::optional<ContactPoint> point = project(lips, part);
    if (!point)
      ++beyond;
    else if (!point->shares.empty())
      append(points, std::move(*point));
  }
  set_sizes(lips, points);
  if (weight_ == Weight::equal) make_equal(lips, parts, points);
  report(joint.name, beyond, points);
  return points;
}

// In two passes each lip's points carry half of the pressure.
std::vector<ContactPoint> NodeToSegment::pair(const model::Model& model, const mesh::JointLips& joint,
                                              int slave) const {
  std::vector<ContactPoint> points = pass(model, joint, slave);
  if (passes_ == 1) return points;
  for (ContactPoint& point : pass(model, joint, 1 - slave)) points.push_back(std::move(point));
  for (ContactPoint& point : points) {
    point.area /= 2;
    point.length /= 2;
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const ContactPoint& a, const ContactPoint& b) { return a.s < b.s; });
  return points;
}

}  // namespace ashlar::contact
