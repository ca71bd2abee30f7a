#pragma once
// How far two sets of probe displacements lie apart.

#include "crosscheck/calculix.hpp"

namespace ashlar::test {

/// ‖a − b‖ / ‖b‖ over all stages, probes and components.
double relative_difference(const ProbeMoves& a, const ProbeMoves& b);

/// The dam on one mesh of quadrilaterals by both programs.
struct Comparison {
  mesh::Index cells = 0;
  ProbeMoves ours, theirs;
  double calculix_cpu = 0;  ///< [s]
};
Comparison compare_dam(int cells, const std::filesystem::path& folder);

}  // namespace ashlar::test
