// What a joint did in a finished stage: profiles, resultants and extremes from the committed state.

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/contact_term.hpp"

namespace ashlar::contact {

namespace {

using model::JointResult;

// Jumps below this part of the largest displacement at the joints are round-off.
constexpr double displacement_digits = 1e-13;

// Half an edge at a welded tip has no contact point: what it carries goes through the tip's cells.
void add_lengths(const mesh::Mesh& mesh, const JointContact& parts, JointResult& result) {
  for (const ContactPoint& point : parts.points) result.contact_length += point.length;
  const auto joint = std::find_if(mesh.joints.begin(), mesh.joints.end(),
                                  [&](const mesh::JointLips& each) { return each.name == parts.name; });
  if (joint == mesh.joints.end()) return;
  const int slave = parts.points.front().slave;
  std::set<Index> master;
  for (const mesh::LipEdge& edge : joint->lips[1 - slave]) master.insert({edge.from, edge.to});
  for (const mesh::LipEdge& edge : joint->lips[slave]) {
    result.length += geometry::distance(mesh.points[edge.from], mesh.points[edge.to]);
    if (master.contains(edge.from)) result.tips.push_back({edge.s_from, mesh.points[edge.from]});
    if (master.contains(edge.to)) result.tips.push_back({edge.s_to, mesh.points[edge.to]});
  }
}

JointResult::Row::State state_of(Status status) {
  if (status == Status::open) return JointResult::Row::State::open;
  return status == Status::stick ? JointResult::Row::State::stick : JointResult::Row::State::slip;
}

/// Contact force of a point on the first lip's body, with its moment about the origin.
void add_force(const ContactPoint& point, const PointMemory& memory, model::Resultant& sum) {
  const Point on_slave = point.area * (memory.pressure * point.normal - memory.shear * point.tangent);
  for (const ContactPoint::Share& share : point.shares) {
    if (share.slave != (point.slave == 0)) continue;
    const Point on_first = share.factor * on_slave;
    sum.x += on_first.x;
    sum.y += on_first.y;
    sum.moment += geometry::cross(share.at, on_first);
  }
}

void add_extremes(const JointResult::Row& row, JointResult& result) {
  result.max_opening = std::max(result.max_opening, row.opening);
  result.max_slip = std::max(result.max_slip, std::abs(row.slip));
  result.max_pressure = std::max(result.max_pressure, row.pressure);
  result.max_shear = std::max(result.max_shear, std::abs(row.shear));
}

}  // namespace

void ContactTerm::add_row(const PointMemory& memory, std::size_t joint, std::size_t point,
                          std::span<const double> jump, JointResult& result) const {
  const ContactPoint& p = joints_[joint].points[point];
  const Friction& friction = *joints_[joint].law.friction;
  JointResult::Row row{.s = p.s, .at = p.at, .opening = jump[0], .slip = jump[1]};
  row.closed = touching(memory.status);
  row.state = state_of(memory.status);
  row.piece = p.piece;
  row.pressure = p.weight * memory.pressure;
  row.shear = p.weight * memory.shear;
  if (row.closed) {
    const double strength = friction.strength(memory.pressure, memory.path).value;
    if (strength > 0) row.utilisation = std::abs(memory.shear) / strength;
    result.strength_force += strength * p.area;
    ++result.closed;
    result.slipping += row.state == JointResult::Row::State::slip;
  } else {
    result.cracked_length += p.length;
  }
  result.normal_force += memory.pressure * p.area;
  result.shear_force += memory.shear * p.area;
  result.action_s += memory.pressure * p.area * p.s;
  add_force(p, memory, result.resultant);
  add_extremes(row, result);
  const double overlap = penetration(joints_[joint].law, memory, row.opening);
  result.max_penetration = std::max(result.max_penetration, overlap);
  result.penetration_over_h = std::max(result.penetration_over_h, overlap / p.h);
  result.rows.push_back(row);
}

model::JointResult ContactTerm::joint_result(const fields::State& state, std::size_t joint,
                                             std::span<const double> jump) const {
  JointResult result;
  result.name = joints_[joint].name;
  result.points = static_cast<int>(joints_[joint].points.size());
  add_lengths(model_.mesh, joints_[joint], result);
  for (std::size_t p = 0; p < joints_[joint].points.size(); ++p)
    add_row(committed(state, joint, p), joint, p, jump.subspan(2 * p, 2), result);
  result.action_s = result.normal_force != 0 ? result.action_s / result.normal_force : 0;
  // Shear that is next to nothing beside the strength is round-off: nothing pushes.
  const double push = std::abs(result.shear_force);
  if (push > 1e-12 * result.strength_force && push > 0) result.safety = result.strength_force / push;
  return result;
}

void ContactTerm::add_results(const fields::State& state, model::StageResult& result) const {
  const auto u = state.committed(state.find(model_.dofs.field().name));
  std::vector<double> jump = jumps_.initial;
  double largest = 0;
  for (const Index dof : touched_) largest = std::max(largest, std::abs(u[dof]));
  for (Index i = 0; i < jumps_.size(); ++i)
    for (const model::Jumps::Part& part : jumps_.parts[i]) jump[i] += part.factor * u[touched_[part.place]];
  // Differences of displacements are known to this only.
  for (double& each : jump)
    if (std::abs(each) < displacement_digits * largest) each = 0;
  std::size_t first = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const std::size_t count = 2 * joints_[j].points.size();
    result.joints.push_back(joint_result(state, j, std::span<const double>(jump).subspan(first, count)));
    first += count;
  }
}

}  // namespace ashlar::contact
