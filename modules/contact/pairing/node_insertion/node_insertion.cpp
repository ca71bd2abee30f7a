#include "contact/pairing/node_insertion/node_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "contact/pairing/lip.hpp"

namespace ashlar::contact {

namespace {

using mesh::LipEdge;

/// The edge of the master that stands opposite each slave edge: both ends are pairs.
class Opposite {
 public:
  Opposite(const Lips& lips, const mesh::JointLips& joint) {
    const int slave = lips.slave_number();
    for (const auto& pair : joint.pairs) partners_[pair[slave]].insert(pair[1 - slave]);
    for (const LipEdge& edge : lips.master()) {
      edges_[{edge.from, edge.to}] = &edge;
      // A welded tip is one point of both lips.
      for (const Index point : {edge.from, edge.to}) partners_[point].insert(point);
    }
  }
  const LipEdge* of(const LipEdge& slave) const {
    const auto from = partners_.find(slave.from), to = partners_.find(slave.to);
    if (from == partners_.end() || to == partners_.end()) return nullptr;
    for (const Index a : from->second)
      for (const Index b : to->second)
        if (const auto found = edges_.find({a, b}); found != edges_.end()) return found->second;
    return nullptr;
  }

 private:
  std::map<Index, std::set<Index>> partners_;
  std::map<std::pair<Index, Index>, const LipEdge*> edges_;
};

/// Node against node: the jump u_s − u_m, the gap n·(x_s − x_m). No shares at a welded tip.
ContactPoint pair_nodes(const Lips& lips, const SlavePart& part, const LipEdge& master) {
  const TraceNode there = lips.nodes(master)[part.number];
  ContactPoint point = begin_point(lips, part, master);
  point.gap =
      geometry::dot(point.normal, lips.surface(*part.edge, part.node.at) - lips.surface(master, there.at));
  if (std::abs(point.gap) < same_place * lips.length(master)) point.gap = 0;
  point.overlap = std::max(0.0, -point.gap);
  if (there.dof != part.node.dof)
    point.shares = {{part.node.dof, 1, part.node.at, true}, {there.dof, -1, there.at, false}};
  return point;
}

}  // namespace

std::vector<ContactPoint> NodeInsertion::pair(const model::Model& model, const mesh::JointLips& joint,
                                              int slave, std::vector<std::string>* remarks) const {
  const Lips lips(model, joint, slave);
  const Opposite opposite(lips, joint);
  std::vector<ContactPoint> points;
  std::size_t beyond = 0;
  for (const SlavePart& part : slave_parts(lips)) {
    const LipEdge* master = opposite.of(*part.edge);
    if (!master) {
      ++beyond;
      continue;
    }
    ContactPoint point = pair_nodes(lips, part, *master);
    if (!point.shares.empty()) append(lips, points, std::move(point));
  }
  // Inserted points stand at any distance: stiffnesses by each point's own edges would make a uniform
  // pressure penetrate unevenly.
  double total = 0;
  for (const LipEdge& edge : lips.slave()) total += lips.length(edge);
  for (ContactPoint& point : points) point.h = total / static_cast<double>(lips.slave().size());
  if (beyond > 0 && remarks)
    remarks->push_back(std::to_string(beyond) +
                       " parts of the slave lip's edges face no edge of the other lip and carry no contact");
  return points;
}

}  // namespace ashlar::contact
