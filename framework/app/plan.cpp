// ashlar plan: what would be simulated, why, at what size, and what would not.

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "app/host.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "solve/build.hpp"

namespace ashlar::app {

namespace {

std::string why(const core::Settings& settings, const Scenario& scenario, const std::string& key) {
  const bool only = scenario.registry.names(key).size() == 1;
  if (!scenario.scene.root.said(key)) return only ? "the only one there is" : "the usual one";
  return "asked for at " + core::to_string(core::Place{settings.place.file, settings.place.line, ""});
}

std::string solver_text(const Scenario& scenario, const model::Model& model) {
  const core::Settings& solver = scenario.scene.solver;
  const std::vector<std::string> others = scenario.registry.names("unsymmetric_solver");
  if (std::ranges::all_of(model.materials, [](const auto& law) { return law->symmetric(); }) ||
      others.empty())
    return solver.name + ", " + why(solver, scenario, "solver") + ": " +
           scenario.registry.find("solver", solver.name)->schema.doc;
  return others.front() + ", as a law's tangent is not symmetric: " +
         scenario.registry.find("unsymmetric_solver", others.front())->schema.doc;
}

void tell_parts(const Scenario& scenario, const model::Model& model) {
  const model::Scene& scene = scenario.scene;
  const fields::Field& field = model.dofs.field();
  std::cout << scene.title << " (" << model::words(scene.plane) << ")\n"
            << "  mesh     " << scene.mesh.name << ": " << model.mesh.cell_count() << " cells, "
            << model.mesh.point_count() << " points\n"
            << "  element  " << scene.element.name << " of order " << scene.order << ", "
            << why(scene.element, scenario, "element") << '\n'
            << "  field    " << field.name << " [" << field.unit << "]: " << field.width << " components, "
            << model.dofs.size() << " degrees of freedom\n"
            << "  solver   " << solver_text(scenario, model) << '\n';
}

void tell_stage(const model::StagePlan& planned, const model::StageData& stage, const model::Scene& scene,
                const model::Constraints& constraints, bool yields) {
  std::cout << "\nstage '" << planned.stage << "'";
  if (stage.parent >= 0)
    std::cout << " after '" << scene.stages[static_cast<std::size_t>(stage.parent)].name << "'";
  std::cout << '\n';
  bool nonlinear = false;
  for (const model::Call& call : planned.calls) {
    std::cout << "  " << std::left << std::setw(20) << call.effect << "called for by "
              << core::to_string(call.place) << '\n';
    nonlinear = nonlinear || call.nonlinear;
  }
  std::cout
      << "  " << constraints.unknowns() << " unknowns, " << constraints.held.size() - constraints.dof.size()
      << " degrees of freedom held by " << stage.supports.size() << " supports\n"
      << (yields ? "  nonlinear: the whole matrix is factored anew in every iteration, in steps as large as "
                   "settle\n"
          : nonlinear
              ? "  nonlinear: one factorisation of the bulk, then an iteration on the joints' own unknowns\n"
              : "  linear: one factorisation and one solve, no iteration\n");
}

}  // namespace

int plan(const CommandLine& line) {
  show_log(line.quiet);
  const auto scenario = read_scenario(line);
  core::Mistakes mistakes;
  const model::Model model =
      solve::build_model(scenario->scene, scenario->effects, scenario->registry, mistakes);
  mistakes.throw_if_any();
  tell_parts(*scenario, model);
  const model::Scene& scene = scenario->scene;
  const bool yields = std::ranges::any_of(model.materials, [](const auto& law) { return !law->linear(); });
  for (std::size_t s = 0; s < scene.stages.size(); ++s) {
    const auto constraints = solve::build_constraints(model, scene.stages[s], mistakes);
    mistakes.throw_if_any();
    tell_stage(scenario->plan.stages[s], scene.stages[s], scene, constraints, yields);
  }
  if (!scenario->plan.left_out.empty()) std::cout << "\nnot simulated\n";
  for (const core::EffectEntry& effect : scenario->plan.left_out)
    std::cout << "  " << std::left << std::setw(20) << effect.name << effect.left_out << '\n';
  return done;
}

}  // namespace ashlar::app
