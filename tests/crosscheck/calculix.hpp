#pragma once
// The same scene in CalculiX: one layer of solid elements on Ashlar's mesh, held in z, which is plane strain.
// Understood: elastic regions, supports on edges, gravity, water, one frictionless joint with a penalty.

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "support/scene_run.hpp"

namespace ashlar::test {

/// By stage, then by probe: (ux, uy) [m].
using ProbeMoves = std::vector<std::map<std::string, std::array<double, 2>>>;

/// CalculiX's input, *STEP by stage. Quadrilaterals become C3D8, triangles C3D6.
/// Throws runtime_error for scenes that are not understood.
std::string calculix_input(const SceneRun& run);

/// Displacements at the probes from CalculiX's table (.dat).
ProbeMoves read_calculix_table(const SceneRun& run, const std::filesystem::path& dat);

/// Whether `ccx` can be called.
bool has_calculix();
/// Runs ccx, one thread, on JOB.inp in `folder`; what it says goes to JOB.log. Its exit code says little:
/// whether it finished, its tables must show.
void call_calculix(const std::filesystem::path& folder, const std::string& job);

struct CalculixRun {
  ProbeMoves moves;
  double cpu = 0;  ///< of the ccx process, one thread [s]
};
/// Writes the input into `folder`, runs ccx there and reads its table.
CalculixRun run_calculix(const SceneRun& run, const std::filesystem::path& folder);

/// Ashlar's own displacements at the probes.
ProbeMoves probe_moves(const SceneRun& run);

}  // namespace ashlar::test
