#include "solve/drive_joint.hpp"

namespace ashlar::solve {

using model::JointLeg;
using model::JointPoint;
using model::JointTarget;

namespace {

// Steps are halved this often before they are given up.
constexpr int deepest_cut = 8;

double here(double displacement, double traction, bool by_traction) {
  return by_traction ? traction : displacement;
}

/// Between where the point stands and the target, in the target's own quantities.
JointTarget between(const JointPoint& from, const JointTarget& target, double share) {
  JointTarget made = target;
  const double normal = here(from.opening, from.pressure, target.pressure);
  const double tangential = here(from.slip, from.shear, target.shear);
  made.normal = share == 1 ? target.normal : normal + share * (target.normal - normal);
  made.tangential = share == 1 ? target.tangential : tangential + share * (target.tangential - tangential);
  return made;
}

/// In one step, or in halves where that fails. False leaves the last good point.
bool go(model::JointDriver& joint, const JointTarget& target, int cut = 0) {
  if (joint.go(target)) return true;
  if (cut == deepest_cut) return false;
  return go(joint, between(joint.at(), target, 0.5), cut + 1) && go(joint, target, cut + 1);
}

/// The end of a leg; directions that it does not name keep what led them.
JointTarget end_of(const JointLeg& leg, JointTarget target) {
  if (leg.opening) target.normal = *leg.opening, target.pressure = false;
  if (leg.pressure) target.normal = *leg.pressure, target.pressure = true;
  if (leg.slip) target.tangential = *leg.slip, target.shear = false;
  if (leg.shear) target.tangential = *leg.shear, target.shear = true;
  return target;
}

JointTarget target_of(const model::Drive& drive, double t) {
  const double arguments[] = {t};
  const std::vector<double> values = drive.path->call(arguments);
  if (values.size() != 2)
    throw core::InputError(
        core::Mistake{drive.path_place,
                      "the path's function must return the opening and the slip of the joint; it returns " +
                          std::to_string(values.size()) + (values.size() == 1 ? " value" : " values"),
                      "return opening, slip"});
  return {values[0], values[1]};
}

}  // namespace

JointDriveResult drive_joint(const model::Drive& drive) {
  model::JointDriver& joint = *drive.joint;
  JointDriveResult result;
  result.points.push_back({1, 0, joint.at()});
  JointTarget end;
  const int legs = drive.path ? 1 : static_cast<int>(drive.joint_legs.size());
  for (int leg = 1; leg <= legs; ++leg) {
    const JointPoint from = joint.at();
    if (!drive.path) end = end_of(drive.joint_legs[leg - 1], end);
    for (int step = 1; step <= drive.steps; ++step) {
      const double share = static_cast<double>(step) / drive.steps;
      result.converged = go(joint, drive.path ? target_of(drive, share) : between(from, end, share));
      if (!result.converged) {
        result.reason = "leg " + std::to_string(leg) + ", step " + std::to_string(step) + " of " +
                        std::to_string(drive.steps) + ": the laws allow no such point";
        return result;
      }
      result.points.push_back({leg, step, joint.at()});
    }
  }
  return result;
}

}  // namespace ashlar::solve
