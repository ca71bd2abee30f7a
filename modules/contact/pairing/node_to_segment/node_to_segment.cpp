#include "contact/pairing/node_to_segment/node_to_segment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "contact/pairing/lip.hpp"

namespace ashlar::contact {

namespace {

using mesh::LipEdge;

// Places beyond a master edge by more than this share of it lie beyond the lip.
constexpr double beyond_edge = 1e-6;

/// The contact point of one node. Nothing if it lies beyond the master lip; no shares at a welded tip.
std::optional<ContactPoint> project(const Lips& lips, const SlavePart& part) {
  const Point x_s = part.node.at;
  const Point inward = 0.75 * x_s + 0.25 * lips.place(*part.edge, 1 - std::round(part.node.t));
  const LipEdge* master = lips.nearest_master(*part.edge, x_s, inward);
  if (!master) return {};
  const Point x_m = lips.at(master->from), edge = lips.at(master->to) - x_m;
  const double l = geometry::norm(edge);
  // ξ = (x_{m+1} − x_m)·(x_s − x_m)/l² where lips touch; across a gap, along the direction of pressure.
  double xi = geometry::dot(edge, x_s - x_m) / (l * l);
  if (xi < -beyond_edge || xi > 1 + beyond_edge) return {};
  if (lips.apart()) xi = std::clamp(lips.opposite(*part.edge, *master, x_s), 0.0, 1.0);
  for (const TraceNode& node : lips.nodes(*master))
    if (std::abs(xi - node.t) < same_place) xi = node.t;
  ContactPoint point = begin_point(lips, part, *master);
  // g = n·(x_s − (1−ξ) x_m − ξ x_{m+1}), measured between the true surfaces
  point.gap =
      geometry::dot(point.normal, lips.surface(*part.edge, x_s) - lips.surface(*master, x_m + xi * edge));
  if (std::abs(point.gap) < same_place * l) point.gap = 0;
  point.overlap = std::max(0.0, -point.gap);
  std::vector<ContactPoint::Share> shares = {{part.node.dof, 1, x_s, true}};
  std::vector<double> shape;
  lips.shape(*master, xi, shape);
  const std::vector<TraceNode> nodes = lips.nodes(*master);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::abs(shape[i]) < same_place) continue;
    if (nodes[i].dof == part.node.dof) return point;  // welded
    shares.push_back({nodes[i].dof, -shape[i], nodes[i].at, false});
  }
  point.shares = std::move(shares);
  return point;
}

/// The paper's weight: the lip's mean edge length for every node, divided between its parts at corners.
void make_equal(const Lips& lips, const std::vector<SlavePart>& parts, std::vector<ContactPoint>& points) {
  std::map<Index, double> tributary;
  double total = 0;
  for (const SlavePart& part : parts) {
    tributary[part.node.dof] += part.length;
    total += part.length;
  }
  const double mean = total / static_cast<double>(lips.slave().size());
  for (ContactPoint& point : points) {
    point.weight = mean / tributary.at(point.shares[0].dof);
    point.area *= point.weight;
  }
}

void remark(std::size_t beyond, const std::vector<ContactPoint>& points, std::vector<std::string>& remarks) {
  const auto between = std::count_if(points.begin(), points.end(),
                                     [](const ContactPoint& point) { return point.shares.size() > 2; });
  if (beyond > 0)
    remarks.push_back(std::to_string(beyond) +
                      " parts of the slave lip's edges face no edge of the other lip and carry no contact");
  if (between > 0)
    remarks.push_back(
        "the lips' points do not match at " + std::to_string(between) +
        " places; node_to_segment passes a uniform pressure only roughly there: node_insertion or "
        "mortar pass it exactly");
}

}  // namespace

std::vector<ContactPoint> NodeToSegment::pass(const model::Model& model, const mesh::JointLips& joint,
                                              int slave, std::vector<std::string>* remarks) const {
  const Lips lips(model, joint, slave);
  std::vector<ContactPoint> points;
  std::size_t beyond = 0;
  const std::vector<SlavePart> parts = slave_parts(lips);
  for (const SlavePart& part : parts) {
    std::optional<ContactPoint> point = project(lips, part);
    if (!point)
      ++beyond;
    else if (!point->shares.empty())
      append(lips, points, std::move(*point));
  }
  set_sizes(lips, points);
  if (weight_ == Weight::equal) make_equal(lips, parts, points);
  if (remarks) remark(beyond, points, *remarks);
  return points;
}

// In two passes each lip's points carry half of the pressure.
std::vector<ContactPoint> NodeToSegment::pair(const model::Model& model, const mesh::JointLips& joint,
                                              int slave, std::vector<std::string>* remarks) const {
  std::vector<ContactPoint> points = pass(model, joint, slave, remarks);
  if (passes_ == 1) return points;
  for (ContactPoint& point : pass(model, joint, 1 - slave, remarks)) points.push_back(std::move(point));
  for (ContactPoint& point : points) {
    point.area /= 2;
    point.length /= 2;
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const ContactPoint& a, const ContactPoint& b) { return a.s < b.s; });
  return points;
}

}  // namespace ashlar::contact
