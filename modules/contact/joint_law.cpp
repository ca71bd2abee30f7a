#include "contact/joint_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ashlar::contact {

namespace {

bool of_traction(const JointLaw& law) {
  return law.normal->form() == NormalLaw::Form::traction;
}

/// σ: the sense in which the slip grows.
double sense(Status status) {
  return status == Status::slip_backward ? -1 : 1;
}

/// Opening and pressure of the normal law, and their derivatives by the first unknown.
struct Normal {
  double o = 0, p = 0;
  double o_by = 0, p_by = 0;
  Variables remembered{};
};

//   rigid      o = −c (p − base)        compliant  o = o(p)        traction  p = p(o)
Normal couple(const JointLaw& law, const Hold& hold, const PointMemory& committed, double first) {
  Normal n;
  n.remembered = committed.law;
  switch (law.normal->form()) {
    case NormalLaw::Form::rigid:
      return {-hold.normal * (first - hold.base_pressure), first, -hold.normal, 1, n.remembered};
    case NormalLaw::Form::compliant: {
      const Opening opening = law.normal->opening(first);
      return {opening.value, first, opening.by_pressure, 1, n.remembered};
    }
    case NormalLaw::Form::traction: {
      const Pressure pressure = law.normal->pressure(first, committed.law, n.remembered);
      n.o = first, n.o_by = 1;
      n.p = pressure.value, n.p_by = pressure.by_opening;
      return n;
    }
  }
  assert(!"no such form");
  return n;
}

/// Elastic slip: c (τ − base).
struct Elastic {
  double c = 0, base = 0;
};
Elastic elastic_slip(const JointLaw& law, const Hold& hold) {
  const double k = law.friction->stiffness();
  return std::isinf(k) ? Elastic{hold.tangential, hold.base_shear} : Elastic{1 / k, 0};
}

// gap = y₁ (+ dilation for laws of traction, whose unknown leaves it out), slip = y₂
PointResponse respond_open(const JointLaw& law, const PointMemory& committed, const Unknowns& y) {
  PointResponse r;
  r.jump = y;
  r.jump_by = Eigen::Matrix2d::Identity();
  if (!of_traction(law)) return r;
  const Normal n = couple(law, {}, committed, y[0]);
  r.jump[0] += committed.dilation;
  r.traction[0] = -n.p;
  r.traction_by(0, 0) = -n.p_by;
  return r;
}

// gap = o + dilation,  slip = rest + c (τ − base),  τ = y₂
PointResponse respond_stick(const Normal& n, const Elastic& e, const PointMemory& committed, double shear) {
  PointResponse r;
  r.jump = {n.o + committed.dilation, committed.rest + e.c * (shear - e.base)};
  r.traction = {-n.p, shear};
  r.jump_by << n.o_by, 0, 0, e.c;
  r.traction_by << -n.p_by, 0, 0, 1;
  return r;
}

// gap = o + dilation,  slip = rest + Δ,  τ = 0
PointResponse respond_free(const Normal& n, const PointMemory& committed, double growth) {
  PointResponse r;
  r.jump = {n.o + committed.dilation, committed.rest + growth};
  r.traction = {-n.p, 0};
  r.jump_by << n.o_by, 0, 0, 1;
  r.traction_by << -n.p_by, 0, 0, 0;
  return r;
}

// τ = σ f(p, path + Δ),  slip = rest + σΔ + c (τ − base),  gap = o + dilation + d(p, path, path + Δ)
PointResponse respond_slip(const Friction& friction, const Normal& n, const Elastic& e,
                           const PointMemory& committed, double sigma, double growth) {
  const double path = committed.path + growth;
  const Strength f = friction.strength(n.p, path);
  const Dilation d = friction.dilation(n.p, committed.path, path);
  PointResponse r;
  r.jump = {n.o + committed.dilation + d.value,
            committed.rest + sigma * growth + e.c * (sigma * f.value - e.base)};
  r.traction = {-n.p, sigma * f.value};
  r.jump_by << n.o_by + d.by_pressure * n.p_by, d.by_path,  //
      e.c * sigma * f.by_pressure * n.p_by, sigma * (1 + e.c * f.by_path);
  r.traction_by << -n.p_by, 0, sigma * f.by_pressure * n.p_by, sigma * f.by_path;
  return r;
}

/// Whether lips that were open touch, or those that touched part.
bool touches(const JointLaw& law, const PointMemory& committed, Status status, const Unknowns& unknowns,
             double pressure, const Tolerance& tolerance) {
  const bool open = status == Status::open;
  if (of_traction(law)) {
    const double limit = (open ? -1 : 1) * tolerance.displacement;
    return unknowns[0] <= limit || std::abs(pressure) > tolerance.traction;
  }
  if (open) return unknowns[0] < committed.dilation - tolerance.displacement;
  return pressure >= -law.normal->tensile_strength(committed.law) - tolerance.traction;
}

}  // namespace

PointResponse respond(const JointLaw& law, const Hold& hold, const PointMemory& committed, Status status,
                      const Unknowns& unknowns) {
  if (!touching(status)) return respond_open(law, committed, unknowns);
  const Normal n = couple(law, hold, committed, unknowns[0]);
  if (law.friction->frictionless()) return respond_free(n, committed, unknowns[1]);
  const Elastic e = elastic_slip(law, hold);
  if (status == Status::stick) return respond_stick(n, e, committed, unknowns[1]);
  return respond_slip(*law.friction, n, e, committed, sense(status), unknowns[1]);
}

Eigen::Vector2d yielding(const JointLaw& law, const Hold& hold, const PointMemory& committed, Status status,
                         const Unknowns& unknowns) {
  return respond(law, hold, committed, status, unknowns).jump -
         respond(law, {}, committed, status, unknowns).jump;
}

double penetration(const JointLaw& law, const PointMemory& memory, double gap) {
  if (of_traction(law) || !touching(memory.status)) return 0;
  const bool soft = law.normal->form() == NormalLaw::Form::compliant;
  const double asked = soft ? law.normal->opening(memory.pressure).value : 0;
  return std::max(0.0, asked + memory.dilation - gap);
}

Status next_status(const JointLaw& law, const PointMemory& committed, Status status, const Unknowns& unknowns,
                   const PointResponse& response, const Tolerance& tolerance) {
  if (!touches(law, committed, status, unknowns, -response.traction[0], tolerance)) return Status::open;
  if (law.friction->frictionless()) return Status::slip_forward;
  switch (status) {
    case Status::open:
      return Status::stick;
    case Status::stick: {
      const double shear = response.traction[1];
      const double strength = law.friction->strength(-response.traction[0], committed.path).value;
      if (std::abs(shear) <= strength + tolerance.traction) return Status::stick;
      return shear > 0 ? Status::slip_forward : Status::slip_backward;
    }
    case Status::slip_forward:
    case Status::slip_backward:
      return unknowns[1] < -tolerance.displacement ? Status::stick : status;
  }
  assert(!"no such status");
  return status;
}

double violation(const JointLaw& law, const PointMemory& committed, Status status, const Unknowns& unknowns,
                 const PointResponse& response, double ground) {
  const double pressure = -response.traction[0], shear = std::abs(response.traction[1]);
  const double overlap = std::max(0.0, committed.dilation - response.jump[0]);
  if (of_traction(law)) {
    if (!touching(status)) return std::max(overlap, std::abs(pressure) / ground);
    if (!touches(law, committed, status, unknowns, pressure, {})) return unknowns[0];
  } else {
    if (!touching(status)) return overlap;
    const double pull = -pressure - law.normal->tensile_strength(committed.law);
    if (pull > 0) return pull / ground;
  }
  if (law.friction->frictionless()) return 0;
  if (status != Status::stick) return std::max(0.0, -unknowns[1]);
  return std::max(0.0, shear - law.friction->strength(pressure, committed.path).value) / ground;
}

PointMemory remember(const JointLaw& law, const Hold& hold, const PointMemory& committed, Status status,
                     const Unknowns& unknowns) {
  const PointResponse response = respond(law, hold, committed, status, unknowns);
  PointMemory memory = committed;
  memory.status = status;
  memory.pressure = 0 - response.traction[0];  // no −0
  memory.shear = response.traction[1];
  if (of_traction(law)) memory.law = couple(law, hold, committed, unknowns[0]).remembered;
  if (status == Status::open) {
    law.normal->part(memory.law);
    memory.rest = response.jump[1];
  } else if (law.friction->frictionless()) {
    memory.rest = response.jump[1];
  } else if (status != Status::stick) {
    const double growth = unknowns[1];
    memory.rest += sense(status) * growth;
    // Growth below 0 is within the tolerance, and no slip.
    memory.path += std::max(growth, 0.0);
    memory.dilation += law.friction->dilation(memory.pressure, committed.path, committed.path + growth).value;
  }
  return memory;
}

Unknowns begin_with(const JointLaw& law, Status status, const PointMemory& memory,
                    const Eigen::Vector2d& jump) {
  if (status == Status::open && !of_traction(law)) return jump;
  const double first = of_traction(law) ? jump[0] - memory.dilation : memory.pressure;
  if (status == Status::open) return {first, jump[1]};
  if (law.friction->frictionless()) return {first, jump[1] - memory.rest};
  return {first, status == Status::stick ? memory.shear : 0};
}

}  // namespace ashlar::contact
