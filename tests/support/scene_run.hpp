#pragma once
// A scene run in this process, as `ashlar run` does it but without files.

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/host.hpp"
#include "model/results.hpp"

namespace ashlar::test {

using ParameterValues = std::vector<std::pair<std::string, std::string>>;

struct SceneRun {
  std::unique_ptr<app::Scenario> scenario;
  model::Model model;
  model::RunResult result;

  const model::StageResult& stage(const std::string& name) const;
  /// A probe's value in a stage: value("reservoir", "crest", "ux").
  double value(const std::string& stage, const std::string& probe, const std::string& quantity) const;
};

/// Reads, plans, builds and marches the scene in a file or folder, modules from the build. Throws InputError
/// for mistakes and runtime_error if a stage does not converge. `adjust` may change the scenario and its
/// model before it is solved.
SceneRun run_scene(const std::filesystem::path& scene, const ParameterValues& set = {},
                   const std::function<void(app::Scenario&, model::Model&)>& adjust = {});

/// examples/jointed_dam.
std::filesystem::path jointed_dam();

}  // namespace ashlar::test
