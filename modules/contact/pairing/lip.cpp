#include "contact/pairing/lip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/polygon.hpp"

namespace ashlar::contact {

using mesh::LipEdge;

namespace {

constexpr double opposite = -0.5;

}  // namespace

Lips::Lips(const model::Model& model, const mesh::JointLips& joint, int slave)
    : model_(model), slave_(joint.lips[slave]), master_(joint.lips[1 - slave]), slave_number_(slave) {}

Point Lips::normal(const LipEdge& edge) const {
  const auto [a, b] = model_.mesh.edge_points[edge.edge];
  const Point d = at(b) - at(a);
  return (-1 / geometry::norm(d)) * geometry::left_of(d);
}

Point Lips::slip_direction(const LipEdge& edge) const {
  const Point d = at(edge.to) - at(edge.from);
  return ((slave_number_ == 0 ? 1 : -1) / geometry::norm(d)) * d;
}

bool Lips::facing(const LipEdge& slave, const LipEdge& master) const {
  return geometry::dot(normal(master), normal(slave)) <= opposite;
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

const LipEdge* Lips::nearest_master(const LipEdge& slave, Point place, Point towards) const {
  const double slack = same_place * length(slave);
  const LipEdge* best = nullptr;
  double best_distance = std::numeric_limits<double>::infinity(), best_towards = best_distance;
  for (const LipEdge& edge : master_) {
    const Point a = at(edge.from), b = at(edge.to);
    const double distance = geometry::distance_to_segment(place, a, b);
    if (distance > best_distance + slack || !facing(slave, edge)) continue;
    const double from_towards = geometry::distance_to_segment(towards, a, b);
    if (distance >= best_distance - slack && from_towards >= best_towards - slack) continue;
    best = &edge;
    best_distance = distance;
    best_towards = from_towards;
  }
  return best;
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
