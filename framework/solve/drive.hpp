#pragma once
// Leads a law along a path without a mesh. Strains that are given are imposed; stresses that are given are
// met by Newton's method on the law's tangent.

#include <string>
#include <vector>

#include "model/drive.hpp"

namespace ashlar::solve {

struct DrivePoint {
  int leg = 1, step = 0;  ///< the first point is step 0 of leg 1: no strain
  model::Voigt strain{}, stress{};
  std::vector<double> variables;
  int iterations = 0;  ///< of Newton's method, all cuts together
};

struct DriveResult {
  std::vector<DrivePoint> points;  ///< all that were reached
  bool converged = true;
  std::string reason;  ///< why it ended early
};

/// Throws InputError if the path's function fails.
DriveResult drive(const model::Drive& drive);

}  // namespace ashlar::solve
