#include "convergence/dam_numbers.hpp"

#include <cmath>

namespace ashlar::test {

namespace {

DamNumbers stage_numbers(const SceneRun& run, const model::StageResult& stage) {
  const auto probe = [&](const char* name, const char* u) { return 1e3 * run.value(stage.name, name, u); };
  const double jump = std::hypot(probe("mouth_upper", "ux") - probe("mouth_lower", "ux"),
                                 probe("mouth_upper", "uy") - probe("mouth_lower", "uy"));
  const model::JointResult& joint = stage.joints.at(0);
  DamNumbers numbers{run.model.mesh.cell_count(),
                     stage.name,
                     {{"crest ux", probe("crest", "ux")},
                      {"crest uy", probe("crest", "uy")},
                      {"heel uy", probe("heel", "uy")},
                      {"toe uy", probe("toe", "uy")},
                      {"mouth jump", jump},
                      {"max slip", 1e3 * joint.max_slip},
                      {"joint force", 1e-3 * joint.normal_force}},
                     0};
  for (const model::Extreme& extreme : stage.extremes)
    if (extreme.quantity == "s3") numbers.peak = -1e-6 * extreme.least;
  return numbers;
}

}  // namespace

std::vector<DamNumbers> dam_numbers(const std::string& mesh, int cells) {
  const SceneRun run = run_scene(jointed_dam(), {{"mesh", mesh}, {"cells", std::to_string(cells)}});
  std::vector<DamNumbers> numbers;
  for (const model::StageResult& stage : run.result.stages) numbers.push_back(stage_numbers(run, stage));
  return numbers;
}

double relative_change(const DamNumbers& before, const DamNumbers& now) {
  double sum = 0;
  for (std::size_t i = 0; i < now.settling.size(); ++i) {
    const double change = before.settling[i].second / now.settling[i].second - 1;
    sum += change * change;
  }
  return std::sqrt(sum / static_cast<double>(now.settling.size()));
}

}  // namespace ashlar::test
