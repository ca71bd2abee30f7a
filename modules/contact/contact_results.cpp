// What a joint did in a finished stage: profiles, resultants and extremes from the committed state.

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/contact_term.hpp"

namespace ashlar::contact {

namespace {

// Half an edge at a welded tip has no contact point: what it carries goes through the tip's cells.
void add_lengths(const mesh::Mesh& mesh, const JointContact& parts, model::JointResult& result) {
  for (const ContactPoint& point : parts.points) result.contact_length += point.length;
  const auto joint = std::find_if(mesh.joints.begin(), mesh.joints.end(),
                                  [&](const mesh::JointLips& each) { return each.name == parts.name; });
  if (joint == mesh.joints.end()) return;
  std::set<Index> master;
  for (const mesh::LipEdge& edge : joint->lips[1 - parts.slave]) master.insert({edge.from, edge.to});
  for (const mesh::LipEdge& edge : joint->lips[parts.slave]) {
    result.length += geometry::distance(mesh.points[edge.from], mesh.points[edge.to]);
    if (master.contains(edge.from)) result.tips.push_back({edge.s_from, mesh.points[edge.from]});
    if (master.contains(edge.to)) result.tips.push_back({edge.s_to, mesh.points[edge.to]});
  }
}

}  // namespace

std::span<const double> ContactTerm::open(const fields::State& state, std::size_t joint) const {
  return state.committed(state.find("contact." + joints_[joint].name + ".open"));
}

void ContactTerm::add_row(std::size_t joint, std::size_t point, bool closed, std::span<const double> u,
                          model::JointResult& result) const {
  const JointContact& parts = joints_[joint];
  const ContactPoint& p = parts.points[point];
  const Motion now = motion(joint, point, u);
  model::JointResult::Row row{p.s, p.at, now.gap, now.slip, 0, closed, p.piece};
  if (closed) {
    const double pressure = parts.enforcement->pressure(now.gap, p).value;
    const double shear = parts.friction->shear(now.slip, pressure).value;
    const double area = p.weight * model_.depth(p.at);
    row.pressure = pressure * p.weight / p.length;
    result.normal_force += pressure * area;
    const Point force = area * (pressure * p.normal - shear * p.tangent);  // on the slave
    for (const ContactPoint::Share& share : p.shares) {
      if ((share.factor > 0) != (parts.slave == 0)) continue;
      const Point on_first = share.factor * force, at = model_.mesh.points[share.point];
      result.resultant.x += on_first.x;
      result.resultant.y += on_first.y;
      result.resultant.moment += geometry::cross(at, on_first);
    }
    ++result.closed;
  }
  result.max_opening = std::max(result.max_opening, row.opening);
  result.max_slip = std::max(result.max_slip, std::abs(row.slip));
  result.max_pressure = std::max(result.max_pressure, row.pressure);
  if (closed && -now.gap > result.max_penetration) result.max_penetration = -now.gap;
  if (closed) result.penetration_over_h = std::max(result.penetration_over_h, -now.gap / p.h);
  result.rows.push_back(row);
}

model::JointResult ContactTerm::joint_result(std::size_t joint, std::span<const double> open,
                                             std::span<const double> u) const {
  model::JointResult result;
  result.name = joints_[joint].name;
  result.points = static_cast<int>(open.size());
  add_lengths(model_.mesh, joints_[joint], result);
  for (std::size_t p = 0; p < open.size(); ++p) add_row(joint, p, open[p] == 0, u, result);
  return result;
}

void ContactTerm::add_results(const fields::State& state, model::StageResult& result) const {
  const auto all = state.committed(state.find(model_.dofs.field().name));
  std::vector<double> u;
  for (const Index dof : touched_) u.push_back(all[dof]);
  for (std::size_t j = 0; j < joints_.size(); ++j)
    result.joints.push_back(joint_result(j, open(state, j), u));
}

}  // namespace ashlar::contact
