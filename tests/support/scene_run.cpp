#include "support/scene_run.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "solve/build.hpp"
#include "solve/march.hpp"

namespace ashlar::test {

const model::StageResult& SceneRun::stage(const std::string& name) const {
  const auto found =
      std::find_if(result.stages.begin(), result.stages.end(), [&](const auto& s) { return s.name == name; });
  if (found == result.stages.end()) throw std::runtime_error("no stage '" + name + "'");
  return *found;
}

double SceneRun::value(const std::string& stage_name, const std::string& probe,
                       const std::string& quantity) const {
  for (const model::ProbeResult& each : stage(stage_name).probes)
    if (each.name == probe) return each.values.at(quantity);
  throw std::runtime_error("no probe '" + probe + "'");
}

SceneRun run_scene(const std::filesystem::path& scene, const ParameterValues& set,
                   const std::function<void(app::Scenario&, model::Model&)>& adjust) {
  // The program looks beside itself; tests lie elsewhere in the build.
  setenv("ASHLAR_MODULES", ASHLAR_BINARY_DIR "/modules", 0);
  setenv("ASHLAR_SCRIPTS", ASHLAR_SOURCE_DIR "/scripts", 0);
  app::CommandLine line;
  line.words = {scene.string()};
  line.set = set;
  SceneRun run{app::read_scenario(line), {}, {}};
  app::Scenario& parts = *run.scenario;
  core::Mistakes mistakes;
  run.model = solve::build_model(parts.scene, parts.effects, parts.registry, mistakes);
  mistakes.throw_if_any();
  if (adjust) adjust(parts, run.model);
  solve::Observer silent;
  run.result = solve::march({parts.scene, parts.plan, run.model, parts.registry, parts.effects}, silent);
  if (!run.result.converged)
    throw std::runtime_error("stage '" + run.result.stages.back().name + "' did not converge: " +
                             run.result.stages.back().reason + "; " + run.result.stages.back().advice);
  return run;
}

std::filesystem::path jointed_dam() {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "examples" / "jointed_dam";
}

}  // namespace ashlar::test
