#include "contact/contact_term.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ashlar::contact {

namespace {

// Gaps are differences of displacements: below this part of the largest displacement they are round-off.
constexpr double displacement_digits = 1e-12;

std::string state_name(const JointContact& joint) {
  return "contact." + joint.name + ".open";
}

double gap_tolerance(std::span<const double> u) {
  double largest = 0;
  for (const double value : u) largest = std::max(largest, std::abs(value));
  return displacement_digits * largest;
}

}  // namespace

ContactTerm::ContactTerm(const model::Model& model, std::vector<JointContact> joints)
    : LocalTerm("contact"), model_(model), joints_(std::move(joints)) {
  for (const JointContact& joint : joints_)
    for (const ContactPoint& point : joint.points)
      for (const ContactPoint::Share& share : point.shares)
        for (int c = 0; c < 2; ++c) touched_.push_back(model.dofs.of_point(share.point) + c);
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const JointContact& joint : joints_) {
    auto& by_point = local_.emplace_back();
    for (const ContactPoint& point : joint.points) {
      auto& places = by_point.emplace_back();
      for (const ContactPoint::Share& share : point.shares) {
        const Index dof = model.dofs.of_point(share.point);
        places.push_back(
            static_cast<Index>(std::lower_bound(touched_.begin(), touched_.end(), dof) - touched_.begin()));
      }
    }
  }
}

void ContactTerm::add_state(fields::State& state) const {
  for (const JointContact& joint : joints_) state.add(state_name(joint), joint.points.size());
}

std::size_t ContactTerm::bytes() const {
  std::size_t sum = touched_.capacity() * sizeof(Index);
  for (const JointContact& joint : joints_)
    for (const ContactPoint& point : joint.points)
      sum += sizeof point + sizeof(std::vector<Index>) +
             point.shares.size() * (sizeof(ContactPoint::Share) + sizeof(Index));
  return sum;
}

ContactTerm::Motion ContactTerm::motion(std::size_t joint, std::size_t point,
                                        std::span<const double> u) const {
  const ContactPoint& p = joints_[joint].points[point];
  const std::vector<Index>& place = local_[joint][point];
  Point jump;
  for (std::size_t i = 0; i < p.shares.size(); ++i)
    jump = jump + p.shares[i].factor * Point{u[place[i]], u[place[i] + 1]};
  return {p.gap + geometry::dot(p.normal, jump), geometry::dot(p.tangent, jump)};
}

// c = Aᵀ T w t with T = −p n + τ s; n: normal, s: tangent, w: weight, t: thickness, A: the jump.
// ∂T/∂J = −p′ n nᵀ + τ,ₛ s sᵀ + τ,ₚ p′ s nᵀ.
void ContactTerm::add_point(std::size_t joint, std::size_t point, std::span<const double> u,
                            Eigen::Ref<Eigen::VectorXd> force, Eigen::Ref<Eigen::MatrixXd> tangent) const {
  const JointContact& parts = joints_[joint];
  const ContactPoint& p = parts.points[point];
  const std::vector<Index>& place = local_[joint][point];
  const Motion now = motion(joint, point, u);
  const Pressure pressure = parts.enforcement->pressure(now.gap, p);
  const Shear shear = parts.friction->shear(now.slip, pressure.value);
  const Eigen::Vector2d n(p.normal.x, p.normal.y), s(p.tangent.x, p.tangent.y);
  const double area = p.weight * model_.depth(p.at);
  const Eigen::Vector2d traction = area * (shear.value * s - pressure.value * n);
  const Eigen::Matrix2d slope = area * (shear.by_slip * s * s.transpose() +
                                        pressure.by_gap * (shear.by_pressure * s - n) * n.transpose());
  for (std::size_t i = 0; i < p.shares.size(); ++i) {
    force.segment<2>(place[i]) += p.shares[i].factor * traction;
    for (std::size_t j = 0; j < p.shares.size(); ++j)
      tangent.block<2, 2>(place[i], place[j]) += p.shares[i].factor * p.shares[j].factor * slope;
  }
}

void ContactTerm::add_local(const fields::State& state, std::span<const double> u,
                            Eigen::Ref<Eigen::VectorXd> force, Eigen::Ref<Eigen::MatrixXd> tangent) const {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto open = state.trial(state.find(state_name(joints_[j])));
    for (std::size_t p = 0; p < open.size(); ++p)
      if (open[p] == 0) add_point(j, p, u, force, tangent);
  }
}

int ContactTerm::update_status(fields::State& state, std::span<const double> u) const {
  const double tolerance = gap_tolerance(u);
  int changed = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto open = state.trial(state.find(state_name(joints_[j])));
    for (std::size_t p = 0; p < open.size(); ++p) {
      const double now = joints_[j].law->closed(motion(j, p, u).gap, tolerance) ? 0 : 1;
      changed += now != open[p];
      open[p] = now;
    }
  }
  return changed;
}

std::vector<std::int8_t> ContactTerm::status(const fields::State& state) const {
  std::vector<std::int8_t> closed;
  for (const JointContact& joint : joints_)
    for (const double open : state.trial(state.find(state_name(joint)))) closed.push_back(open == 0);
  return closed;
}

std::string ContactTerm::point_name(std::size_t point) const {
  for (const JointContact& joint : joints_) {
    if (point < joint.points.size()) {
      const Point at = joint.points[point].at;
      return joint.name + " at (" + core::format_quantity(at.x, {}) + ", " + core::format_quantity(at.y, {}) +
             ")";
    }
    point -= joint.points.size();
  }
  assert(!"no such contact point");
  return {};
}

std::vector<std::pair<std::string, double>> ContactTerm::facts(const fields::State& state,
                                                               std::span<const double> u) const {
  double closed = 0, open = 0, penetration = 0, pressure = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto is_open = state.trial(state.find(state_name(joints_[j])));
    for (std::size_t p = 0; p < is_open.size(); ++p) {
      ++(is_open[p] == 0 ? closed : open);
      if (is_open[p] != 0) continue;
      const ContactPoint& point = joints_[j].points[p];
      const double gap = motion(j, p, u).gap;
      penetration = std::max(penetration, -gap / point.h);
      pressure = std::max(pressure, joints_[j].enforcement->pressure(gap, point).value);
    }
  }
  return {{"closed", closed}, {"open", open}, {"penetration/h", penetration}, {"pressure", pressure}};
}

}  // namespace ashlar::contact
