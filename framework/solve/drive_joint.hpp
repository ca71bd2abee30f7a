#pragma once
// Leads a point of a joint along a path without a mesh.

#include <string>
#include <vector>

#include "model/drive.hpp"

namespace ashlar::solve {

struct JointDrivePoint {
  int leg = 1, step = 0;  ///< the first point is step 0 of leg 1: closed, without tractions
  model::JointPoint at;
};

struct JointDriveResult {
  std::vector<JointDrivePoint> points;  ///< all that were reached
  bool converged = true;
  std::string reason;  ///< why it ended early
};

/// Leads `drive.joint`. Throws InputError if the path's function, or a law of the script, fails.
JointDriveResult drive_joint(const model::Drive& drive);

}  // namespace ashlar::solve
