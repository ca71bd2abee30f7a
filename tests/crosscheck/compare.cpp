#include "crosscheck/compare.hpp"

#include <cmath>

namespace ashlar::test {

double relative_difference(const ProbeMoves& a, const ProbeMoves& b) {
  double apart = 0, size = 0;
  for (std::size_t stage = 0; stage < b.size(); ++stage)
    for (const auto& [probe, u] : b[stage])
      for (std::size_t axis = 0; axis < u.size(); ++axis) {
        const double difference = a[stage].at(probe)[axis] - u[axis];
        apart += difference * difference;
        size += u[axis] * u[axis];
      }
  return std::sqrt(apart / size);
}

Comparison compare_dam(int cells, const std::filesystem::path& folder) {
  const SceneRun run = run_scene(jointed_dam(), {{"mesh", "quads"}, {"cells", std::to_string(cells)}});
  CalculixRun calculix = run_calculix(run, folder / std::to_string(cells));
  return {run.model.mesh.cell_count(), probe_moves(run), std::move(calculix.moves), calculix.cpu};
}

}  // namespace ashlar::test
