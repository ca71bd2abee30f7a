#include "contact/follow.hpp"

#include <algorithm>
#include <utility>

#include "contact/pairing/lip.hpp"

namespace ashlar::contact {

namespace {

// A gap, in mesh sizes, that stands for "faces nothing": such a point stays open.
constexpr double far_away = 1e3;

Point displacement(std::span<const double> u, Index dof) {
  return {u[dof], u[dof + 1]};
}

}  // namespace

Follower make_follower(const model::Model& model, const JointContact& joint, std::size_t number) {
  Follower follower;
  follower.joint = number;
  follower.lips = *std::ranges::find(model.mesh.joints, joint.name, &mesh::JointLips::name);
  follower.slave = joint.points.front().slave;
  // Arcs stay where they were drawn; chords move.
  for (auto& lip : follower.lips.lips)
    for (mesh::LipEdge& edge : lip) edge.arc.reset();
  for (const int side : {0, 1}) {
    const Lips lips(model, follower.lips, side);
    for (const mesh::LipEdge& edge : lips.slave())
      for (const TraceNode& node : lips.nodes(edge)) follower.place[node.dof] = node.at;
  }
  const Lips lips(model, follower.lips, follower.slave);
  for (const SlavePart& part : slave_parts(lips)) {
    const auto [found, fresh] = follower.number_of.try_emplace(part.node.dof, follower.alone.size());
    if (fresh) follower.alone.push_back(begin_point(lips, part, *part.edge));
    ContactPoint& point = follower.alone[found->second];
    if (!fresh) {
      point.length += part.length;
      point.area += part.area;
    }
    point.h = lips.length(*part.edge);
    point.modulus = joint.points.front().modulus;
    point.gap = far_away * point.h;
    const Point n = lips.normal(*part.edge);
    point.normal = {-n.x, -n.y};
  }
  return follower;
}

std::vector<ContactPoint> points_now(const Follower& follower, const Pairing& pairing,
                                     const model::Model& moved, const Motion& motion) {
  std::vector<ContactPoint> points = follower.alone;
  std::vector<char> paired(points.size(), 0);
  for (ContactPoint& now : pairing.pair(moved, follower.lips, follower.slave)) {
    const std::size_t number = follower.number_of.at(now.shares[0].dof);
    if (paired[number]) continue;  // a corner's second leg
    paired[number] = 1;
    Point apart, before;
    for (const ContactPoint::Share& share : now.shares) {
      apart = apart + share.factor * follower.place.at(share.dof);
      before = before + share.factor * displacement(motion.before, share.dof);
    }
    now.gap = geometry::dot(now.normal, apart);
    now.slip = motion.slip[number] - geometry::dot(now.tangent, before);
    points[number] = std::move(now);
  }
  return points;
}

bool ContactTerm::follow(fields::State& state) {
  if (followers_.empty()) return false;
  if (!moved_) moved_ = std::make_unique<model::Model>(model_);
  const auto id = state.find(model_.dofs.field().name);
  const std::span<const double> u = std::as_const(state).trial(id), before = state.committed(id);
  for (const Follower& follower : followers_) {
    for (const auto& lip : follower.lips.lips)
      for (const mesh::LipEdge& edge : lip)
        for (const Index point : {edge.from, edge.to})
          moved_->mesh.points[point] =
              model_.mesh.points[point] + displacement(u, model_.dofs.of_point(point));
    JointContact& joint = joints_[follower.joint];
    const auto slip = state.committed(slip_[follower.joint]);
    std::vector<ContactPoint> now = points_now(follower, *joint.follow, *moved_, {before, slip});
    for (std::size_t p = 0; p < now.size(); ++p) {
      const bool alone = now[p].shares.empty();
      if (!alone && !joint.points[p].shares.empty()) continue;
      if (unseen(state, follower.joint, p)) continue;
      PointMemory memory = committed(state, follower.joint, p);
      // Lips that lose each other carry nothing; where they meet, slip begins anew.
      if (alone) memory.status = Status::open;
      memory.pressure = memory.shear = 0;
      memory.rest = slip[p];
      put(state, follower.joint, p, memory);
    }
    joint.points = std::move(now);
  }
  gather_jumps();
  return true;
}

}  // namespace ashlar::contact
