#pragma once
// The table's scenes, run through the program, and meshes for them.

#include <filesystem>

#include "algebra/linear_solver.hpp"
#include "stability/table.hpp"
#include "support/scene_run.hpp"

namespace ashlar::stability {

using Change = std::function<void(app::Scenario&)>;
using MakeSolver = std::function<std::unique_ptr<algebra::LinearSolver>()>;

/// Runs tests/stability/scenes/NAME.lua, with a fault of elements or laws planted in it. `solver`, if given,
/// makes the linear solver in place of the scene's; `change` is made before all.
test::SceneRun run_scene(const std::string& name, const test::ParameterValues& set, Fault fault,
                         const MakeSolver& solver = {}, const Change& change = {});

/// The words of the mistake or of the stage that does not converge; empty if the scene runs to its end.
std::string stopped_by(const std::string& name, const test::ParameterValues& set, Fault fault,
                       const MakeSolver& solver = {}, const Change& change = {});

/// A mesh in a file of a temporary folder, gone with this object.
class MeshFile {
 public:
  explicit MeshFile(const mesh::RawMesh& raw);
  ~MeshFile();
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;
  std::string path() const { return file_.string(); }

 private:
  std::filesystem::path file_;
};

/// Worst of all stages: loads against reactions, backward error of the solves.
double worst_balance(const model::RunResult& result);
double worst_backward_error(const model::RunResult& result);

/// A field of a stage.
const std::vector<double>& values(const model::StageResult& stage, const std::string& field);
/// max |a − b| over max |b|.
double relative_difference(const std::vector<double>& a, const std::vector<double>& b);
/// How far two runs of a scene in different units are from each other: steps, residuals, displacements.
void compare_units(const test::SceneRun& si, const test::SceneRun& other, double metre, double bound,
                   const std::string& name, Outcome& outcome);
/// A joint of a stage.
const model::JointResult& joint_of(const test::SceneRun& run, const std::string& stage,
                                   std::size_t number = 0);
/// All digits of a number, for a scene's parameter.
std::string digits(double x);

}  // namespace ashlar::stability
