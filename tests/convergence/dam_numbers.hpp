#pragma once
// The jointed dam's numbers on one mesh, for tables over meshes.

#include <string>
#include <utility>
#include <vector>

#include "support/scene_run.hpp"

namespace ashlar::test {

struct DamNumbers {
  mesh::Index cells = 0;
  std::string stage;
  /// (name, value), lengths in mm, forces in kN: what settles as the mesh is refined.
  std::vector<std::pair<std::string, double>> settling;
  /// Greatest compression of a cell [MPa], beside the joint's tip: grows without bound.
  double peak = 0;
};

/// Stage by stage. `mesh`: "voronoi", "quads" or "triangles".
std::vector<DamNumbers> dam_numbers(const std::string& mesh, int cells);

/// The root mean square of the settling numbers' relative changes from `before` to `now`.
double relative_change(const DamNumbers& before, const DamNumbers& now);

}  // namespace ashlar::test
