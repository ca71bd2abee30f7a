#pragma once
// Finite sliding: lips that move far along each other are paired anew before each step.

#include "contact/contact_term.hpp"

namespace ashlar::contact {

/// The slave nodes of a joint that follows; `joint.points` are those of the undeformed lips.
Follower make_follower(const model::Model& model, const JointContact& joint, std::size_t number);

/// Displacements by dof and slips by point, at the step's begin.
struct Motion {
  std::span<const double> before, slip;
};

/// The follower's points where the lips of `moved` stand now, as they enter the jumps of any displacement:
/// their gap is that of the undeformed places, and `slip` makes the slip go on from that at the step's begin.
std::vector<ContactPoint> points_now(const Follower& follower, const Pairing& pairing,
                                     const model::Model& moved, const Motion& motion);

}  // namespace ashlar::contact
