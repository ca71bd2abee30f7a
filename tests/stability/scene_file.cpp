#include "stability/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <stdexcept>

#include <unistd.h>

#include "core/error.hpp"

namespace ashlar::stability {

namespace fs = std::filesystem;

test::SceneRun run_scene(const std::string& name, const test::ParameterValues& set, Fault fault,
                         const MakeSolver& solver, const Change& change) {
  const fs::path scene = fs::path(ASHLAR_SOURCE_DIR) / "tests" / "stability" / "scenes" / (name + ".lua");
  return test::run_scene(scene, set, [&](app::Scenario& scenario, model::Model& model) {
    if (change) change(scenario);
    model.element = with_fault(model.element, fault, model.mesh);
    for (auto& law : model.materials) law = with_fault(law, fault);
    plant_in_joints(scenario.effects, fault);
    if (!solver) return;
    scenario.registry.add_schema({"solver", "planted", "", "", {}});
    scenario.registry.add_make(
        "solver", "planted",
        std::function<algebra::MakeSolver>([solver](const core::Settings&) { return solver(); }));
    scenario.scene.solver.name = "planted";
  });
}

std::string stopped_by(const std::string& name, const test::ParameterValues& set, Fault fault,
                       const MakeSolver& solver, const Change& change) {
  try {
    run_scene(name, set, fault, solver, change);
    return {};
  } catch (const core::InputError& error) {
    std::string words;
    for (const core::Mistake& each : error.mistakes())
      words += (words.empty() ? "" : " ") + each.what + "; " + each.advice;
    return words;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

MeshFile::MeshFile(const mesh::RawMesh& raw) {
  static int count = 0;
  file_ = fs::temp_directory_path() /
          ("ashlar-stability-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".vtk");
  std::ofstream out(file_);
  out << "# vtk DataFile Version 3.0\nA hard mesh\nASCII\nDATASET POLYDATA\nPOINTS " << raw.points.size()
      << " double\n"
      << std::setprecision(17);
  for (const geometry::Point p : raw.points) out << p.x << ' ' << p.y << " 0\n";
  std::size_t corners = 0;
  for (mesh::Index c = 0; c < raw.cell_points.size(); ++c) corners += raw.cell_points[c].size();
  out << "POLYGONS " << raw.cell_points.size() << ' '
      << corners + static_cast<std::size_t>(raw.cell_points.size()) << '\n';
  for (mesh::Index c = 0; c < raw.cell_points.size(); ++c) {
    out << raw.cell_points[c].size();
    for (const mesh::Index p : raw.cell_points[c]) out << ' ' << p;
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + file_.string());
}

MeshFile::~MeshFile() {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

double worst_balance(const model::RunResult& result) {
  double worst = 0;
  for (const auto& stage : result.stages) worst = std::max(worst, stage.balance.relative_error);
  return worst;
}

double worst_backward_error(const model::RunResult& result) {
  double worst = 0;
  for (const auto& stage : result.stages) worst = std::max(worst, stage.backward_error);
  return worst;
}

const std::vector<double>& values(const model::StageResult& stage, const std::string& field) {
  for (const model::FieldResult& each : stage.fields)
    if (each.name == field) return each.values;
  throw std::runtime_error("no field '" + field + "'");
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) throw std::runtime_error("fields of different sizes");
  double most = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return most / scale;
}

void compare_units(const test::SceneRun& si, const test::SceneRun& other, double metre, double bound,
                   const std::string& name, Outcome& outcome) {
  for (std::size_t s = 0; s < si.result.stages.size(); ++s) {
    const model::StageResult &a = si.result.stages[s], &b = other.result.stages[s];
    if (a.iterations.size() != b.iterations.size()) {
      outcome.missing.push_back(name + ": another number of iterations in stage '" + a.name + "'");
      return;
    }
    double most = 0;
    for (std::size_t i = 0; i < a.iterations.size(); ++i)
      most = std::max(most, std::abs(a.iterations[i].residual - b.iterations[i].residual));
    outcome.worst(name + " residuals", most, bound);
    std::vector<double> u = values(b, "displacement");
    for (double& each : u) each /= metre;
    outcome.worst(name + " u", relative_difference(u, values(a, "displacement")), bound);
  }
}

const model::JointResult& joint_of(const test::SceneRun& run, const std::string& stage, std::size_t number) {
  return run.stage(stage).joints.at(number);
}

std::string digits(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

}  // namespace ashlar::stability
