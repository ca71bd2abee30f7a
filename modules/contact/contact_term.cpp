#include "contact/contact_term.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "contact/follow.hpp"

namespace ashlar::contact {

namespace {

using fields::State;

// A pull below this part of the greatest traction is round-off.
constexpr double traction_digits = 1e-10;
// Jumps that move by less than this share of the fastest stay.
constexpr double motion_digits = 1e-3;
// Numbers that a point remembers, as they stand in the state.
constexpr std::size_t memory_size = 9;

Unknowns unknowns_at(std::span<const double> all, Index component) {
  return {all[component], all[component + 1]};
}

/// What lips begin with that touch.
Status touching_status(const JointLaw& law) {
  return law.friction->frictionless() ? Status::slip_forward : Status::stick;
}

/// What open lips begin with that overlap: had `ground` held them at their jump, they would stick, or have
/// slipped.
Status predicted(const JointLaw& law, const PointMemory& committed, const Eigen::Vector2d& jump,
                 double ground) {
  if (law.friction->frictionless()) return Status::slip_forward;
  const double pressure = ground * std::max(0.0, committed.dilation - jump[0]);
  const double shear = ground * (jump[1] - committed.rest);
  if (std::abs(shear) <= law.friction->strength(pressure, committed.path).value) return Status::stick;
  return shear > 0 ? Status::slip_forward : Status::slip_backward;
}

void put_unknowns(const Unknowns& own, Index component, std::span<double> all) {
  all[component] = own[0];
  all[component + 1] = own[1];
}

}  // namespace

ContactTerm::ContactTerm(const model::Model& model, std::vector<JointContact> joints,
                         std::shared_ptr<const CycleRule> rule)
    : LocalTerm("contact"), model_(model), joints_(std::move(joints)), rule_(std::move(rule)) {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (joints_[j].follow) followers_.push_back(make_follower(model, joints_[j], j));
  for (const Follower& follower : followers_) joints_[follower.joint].points = follower.alone;
  find_touched();
  gather_jumps();
}

void ContactTerm::find_touched() {
  for (const JointContact& joint : joints_)
    for (const ContactPoint& point : joint.points)
      for (const ContactPoint::Share& share : point.shares)
        touched_.insert(touched_.end(), {share.dof, share.dof + 1});
  // What follows may come to touch any node of its lips.
  for (const Follower& follower : followers_)
    for (const auto& [dof, at] : follower.place) touched_.insert(touched_.end(), {dof, dof + 1});
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
}

void ContactTerm::gather_jumps() {
  jumps_ = {};
  for (const JointContact& joint : joints_) add_jumps(joint);
}

// gap = g₀ + n · Σ factor u, slip = s₀ + s · Σ factor u.
void ContactTerm::add_jumps(const JointContact& joint) {
  for (const ContactPoint& point : joint.points) {
    for (const Point& direction : {point.normal, point.tangent}) {
      std::vector<model::Jumps::Part>& row = jumps_.parts.emplace_back();
      for (const ContactPoint::Share& share : point.shares) {
        const auto place = static_cast<Index>(std::lower_bound(touched_.begin(), touched_.end(), share.dof) -
                                              touched_.begin());
        row.push_back({place, share.factor * direction.x});
        row.push_back({place + 1, share.factor * direction.y});
      }
    }
    jumps_.initial.insert(jumps_.initial.end(), {point.gap, point.slip});
    jumps_.area.insert(jumps_.area.end(), 2, point.area);
    jumps_.ground.insert(jumps_.ground.end(), 2, point.modulus / point.h);
  }
}

void ContactTerm::for_each(const auto& visit) const {
  Index component = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t p = 0; p < joints_[j].points.size(); ++p, component += 2) visit(j, p, component);
}

// The base holds two tractions a point, then the growth of the augmented stiffness and the penetration when
// it was last judged.
void ContactTerm::add_state(State& state) {
  memory_.clear();
  base_.clear();
  slip_.clear();
  for (const JointContact& joint : joints_) {
    memory_.push_back(state.add("contact." + joint.name + ".memory", memory_size * joint.points.size()));
    base_.push_back(state.add("contact." + joint.name + ".base", 2 * joint.points.size() + 2));
    slip_.push_back(joint.follow ? state.add("contact." + joint.name + ".slip", joint.points.size()) : -1);
  }
}

std::size_t ContactTerm::bytes() const {
  std::size_t sum = touched_.capacity() * sizeof(Index);
  for (const JointContact& joint : joints_)
    for (const ContactPoint& point : joint.points)
      sum +=
          sizeof point + point.shares.size() * (sizeof(ContactPoint::Share) + 4 * sizeof(model::Jumps::Part));
  return sum;
}

// The status is stored as its number + 1; 0 is a point that no stage has seen yet.
PointMemory ContactTerm::from_array(std::span<const double> array, std::size_t joint,
                                    std::size_t point) const {
  const double* m = array.data() + memory_size * point;
  PointMemory memory;
  memory.status = m[0] > 0                                ? static_cast<Status>(std::lround(m[0]) - 1)
                  : joints_[joint].points[point].gap <= 0 ? touching_status(joints_[joint].law)
                                                          : Status::open;
  memory.pressure = m[1], memory.shear = m[2], memory.rest = m[3], memory.path = m[4];
  memory.dilation = m[5];
  std::copy(m + 6, m + memory_size, memory.law.begin());
  return memory;
}

PointMemory ContactTerm::committed(const State& state, std::size_t joint, std::size_t point) const {
  return from_array(state.committed(memory_[joint]), joint, point);
}

PointMemory ContactTerm::trial(const State& state, std::size_t joint, std::size_t point) const {
  return from_array(state.trial(memory_[joint]), joint, point);
}

bool ContactTerm::unseen(const State& state, std::size_t joint, std::size_t point) const {
  return state.committed(memory_[joint])[memory_size * point] == 0;
}

void ContactTerm::put(State& state, std::size_t joint, std::size_t point, const PointMemory& memory) const {
  double* m = state.trial(memory_[joint]).data() + memory_size * point;
  m[0] = static_cast<double>(memory.status) + 1;
  m[1] = memory.pressure, m[2] = memory.shear, m[3] = memory.rest, m[4] = memory.path;
  m[5] = memory.dilation;
  std::copy(memory.law.begin(), memory.law.end(), m + 6);
}

Hold ContactTerm::hold(const State& state, std::size_t joint, std::size_t point) const {
  const JointContact& own = joints_[joint];
  const auto base = state.trial(base_[joint]);
  return own.enforcement->hold(own.points[point], {base[2 * point], base[2 * point + 1]},
                               std::max(1.0, base[base.size() - 2]));
}

PointResponse ContactTerm::answer(const State& state, std::size_t joint, std::size_t point,
                                  std::span<const double> own) const {
  return contact::respond(joints_[joint].law, hold(state, joint, point), committed(state, joint, point),
                          trial(state, joint, point).status, {own[0], own[1]});
}

void ContactTerm::respond(const State& state, std::span<const double> unknown,
                          model::JumpResponse& response) const {
  response.resize(jumps_.size(), 2);
  for_each([&](std::size_t j, std::size_t p, Index c) {
    const PointResponse own = answer(state, j, p, unknown.subspan(c, 2));
    response.jump.segment<2>(c) = own.jump;
    response.traction.segment<2>(c) = own.traction;
    response.jump_by.middleRows<2>(c) = own.jump_by;
    response.traction_by.middleRows<2>(c) = own.traction_by;
  });
}

void ContactTerm::begin(const State& state, std::span<const double> jump, std::span<double> unknown) const {
  for_each([&](std::size_t j, std::size_t p, Index c) {
    const PointMemory memory = trial(state, j, p);
    put_unknowns(begin_with(joints_[j].law, memory.status, memory, unknowns_at(jump, c)), c, unknown);
  });
}

ContactTerm::Misfits ContactTerm::misfits(const State& state, const model::StatusChange& change,
                                          std::span<const double> unknown) const {
  model::JumpResponse all;
  respond(state, unknown, all);
  const double most = all.traction.size() ? all.traction.lpNorm<Eigen::Infinity>() : 0;
  const Tolerance tolerance{traction_digits * most, change.jump};
  Misfits found;
  for_each([&](std::size_t j, std::size_t p, Index c) {
    const Unknowns own = unknowns_at(unknown, c);
    const Status now = trial(state, j, p).status;
    PointResponse response;
    response.jump = all.jump.segment<2>(c);
    response.traction = all.traction.segment<2>(c);
    const PointMemory before = committed(state, j, p);
    const double wrong = violation(joints_[j].law, before, now, own, response, jumps_.ground[c]);
    found.complementarity = std::max(found.complementarity, wrong / joints_[j].points[p].h);
    Status next = next_status(joints_[j].law, before, now, own, response, tolerance);
    if (next == now) return;
    if (!touching(now)) next = predicted(joints_[j].law, before, response.jump, jumps_.ground[c]);
    found.list.push_back({j, p, c, next, wrong, response});
  });
  return found;
}

// Shear that lips could not bear tilts the bodies: what it pulls open slips first, and parts if it still
// pulls then.
void ContactTerm::slip_before_parting(const State& state, std::vector<Misfit>& list) const {
  const auto sticks = [&](const Misfit& misfit) {
    return trial(state, misfit.joint, misfit.point).status == Status::stick;
  };
  if (std::ranges::none_of(list, [&](const Misfit& m) { return sticks(m) && touching(m.next); })) return;
  for (Misfit& misfit : list)
    if (sticks(misfit) && !touching(misfit.next))
      misfit.next = misfit.response.traction[1] > 0 ? Status::slip_forward : Status::slip_backward;
}

void ContactTerm::change_status(State& state, const Misfit& misfit, std::span<double> unknown) const {
  PointMemory memory = trial(state, misfit.joint, misfit.point);
  memory.status = misfit.next;
  memory.pressure = -misfit.response.traction[0];
  memory.shear = misfit.response.traction[1];
  put(state, misfit.joint, misfit.point, memory);
  put_unknowns(begin_with(joints_[misfit.joint].law, misfit.next, memory, misfit.response.jump),
               misfit.component, unknown);
}

model::StatusUpdate ContactTerm::update_status(State& state, const model::StatusChange& change,
                                               std::span<double> unknown) const {
  auto [list, complementarity] = misfits(state, change, unknown);
  if (list.empty()) return {0, complementarity};
  if (change.one) {
    std::vector<double> energies;  // by which statuses are wrong
    for (const auto& [j, p, c, next, wrong, response] : list)
      energies.push_back(jumps_.area[c] * jumps_.ground[c] * wrong * wrong);
    change_status(state, list[rule_->choose(energies)], unknown);
    return {1, complementarity};
  }
  slip_before_parting(state, list);
  for (const Misfit& misfit : list) change_status(state, misfit, unknown);
  return {static_cast<int>(list.size()), complementarity};
}

// Open lips that close after gap/−ġ of the motion, slip that is taken back after Δ/−σṡ.
bool ContactTerm::stop_first(State& state, std::span<const double> motion, std::span<double> unknown) const {
  double most = 0;
  for (const double each : motion) most = std::max(most, std::abs(each));
  Misfit first;
  double least = INFINITY;
  for_each([&](std::size_t j, std::size_t p, Index c) {
    const JointLaw& law = joints_[j].law;
    const Status now = trial(state, j, p).status;
    const bool slips = touching(now) && now != Status::stick && !law.friction->frictionless();
    if (touching(now) && !slips) return;
    const double onward = slips ? (now == Status::slip_forward ? 1 : -1) * motion[c + 1] : motion[c];
    if (onward >= -motion_digits * most) return;
    const PointResponse response = answer(state, j, p, unknown.subspan(c, 2));
    const double share = std::max(0.0, slips ? unknown[c + 1] : response.jump[0]) / -onward;
    if (share >= least) return;
    least = share;
    first = {j, p, c, slips ? Status::stick : touching_status(law), 0, response};
  });
  if (!std::isfinite(least)) return false;
  change_status(state, first, unknown);
  return true;
}

bool ContactTerm::augment(State& state, std::size_t joint, std::span<const double> unknown,
                          Index first) const {
  const JointContact& own = joints_[joint];
  double penetration = 0;
  for (std::size_t p = 0; p < own.points.size(); ++p) {
    const Index c = first + 2 * static_cast<Index>(p);
    const Status status = trial(state, joint, p).status;
    if (!touching(status)) continue;
    const Eigen::Vector2d gives =
        yielding(own.law, hold(state, joint, p), committed(state, joint, p), status, unknowns_at(unknown, c));
    penetration = std::max(penetration, gives.lpNorm<Eigen::Infinity>() / own.points[p].h);
  }
  const auto base = state.trial(base_[joint]);
  double &growth = base[base.size() - 2], &before = base[base.size() - 1];
  const double was = before > 0 ? before : INFINITY;
  const Enforcement::Augment next = own.enforcement->augment(penetration, was, std::max(1.0, growth));
  growth = next.growth;
  before = next.again ? penetration : 0;
  for (std::size_t p = 0; p < own.points.size(); ++p) {
    const PointMemory now = trial(state, joint, p);
    base[2 * p] = now.pressure, base[2 * p + 1] = now.shear;
  }
  return next.again;
}

bool ContactTerm::settle(State& state, std::span<const double> unknown) const {
  for_each([&](std::size_t j, std::size_t p, Index c) {
    put(state, j, p,
        remember(joints_[j].law, hold(state, j, p), committed(state, j, p), trial(state, j, p).status,
                 unknowns_at(unknown, c)));
    if (slip_[j] >= 0) state.trial(slip_[j])[p] = answer(state, j, p, unknown.subspan(c, 2)).jump[1];
  });
  bool again = false;
  Index first = 0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    again |= augment(state, j, unknown, first);
    first += 2 * static_cast<Index>(joints_[j].points.size());
  }
  return again;
}

void ContactTerm::tractions(const State& state, std::span<double> traction) const {
  for_each([&](std::size_t j, std::size_t p, Index c) {
    const PointMemory memory = trial(state, j, p);
    traction[c] = -memory.pressure;
    traction[c + 1] = memory.shear;
  });
}

std::vector<std::int8_t> ContactTerm::status(const State& state) const {
  std::vector<std::int8_t> all;
  for_each([&](std::size_t j, std::size_t p, Index) {
    all.push_back(static_cast<std::int8_t>(trial(state, j, p).status));
  });
  return all;
}

void ContactTerm::restore(State& state, std::span<const std::int8_t> status) const {
  std::size_t i = 0;
  for_each([&](std::size_t j, std::size_t p, Index) {
    PointMemory memory = trial(state, j, p);
    memory.status = static_cast<Status>(status[i++]);
    put(state, j, p, memory);
  });
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

std::vector<std::pair<std::string, double>> ContactTerm::facts(const State& state,
                                                               std::span<const double> unknown) const {
  std::array<double, 4> count{};
  double overlap = 0, pressure = 0;
  for_each([&](std::size_t j, std::size_t p, Index c) {
    const Status now = trial(state, j, p).status;
    ++count[static_cast<std::size_t>(now)];
    if (!touching(now)) return;
    const PointResponse response = answer(state, j, p, unknown.subspan(c, 2));
    const double gives =
        yielding(joints_[j].law, hold(state, j, p), committed(state, j, p), now, unknowns_at(unknown, c))[0];
    overlap = std::max(overlap, -gives / joints_[j].points[p].h);
    pressure = std::max(pressure, -response.traction[0]);
  });
  std::vector<std::pair<std::string, double>> facts = {{"open", count[0]}};
  const bool rough = std::ranges::any_of(
      joints_, [](const JointContact& joint) { return !joint.law.friction->frictionless(); });
  if (rough) facts.insert(facts.end(), {{"stick", count[1]}, {"slip", count[2] + count[3]}});
  if (!rough) facts.emplace_back("closed", count[1] + count[2] + count[3]);
  facts.insert(facts.end(), {{"penetration/h", overlap}, {"pressure", pressure}});
  return facts;
}

}  // namespace ashlar::contact
