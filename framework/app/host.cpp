#include "app/host.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/ledger.hpp"
#include "model/drive.hpp"
#include "model/scene_names.hpp"
#include "model/support_check.hpp"
#include "solve/build.hpp"
#include "study/study.hpp"

namespace ashlar::app {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders_named_by(const char* variable) {
  std::vector<fs::path> folders;
  const char* text = std::getenv(variable);
  std::istringstream words(text ? text : "");
  for (std::string word; std::getline(words, word, ':');)
    if (!word.empty()) folders.emplace_back(word);
  return folders;
}

// The first of the places, seen from the program's own folder, that exists.
std::vector<fs::path> beside_program(std::initializer_list<const char*> places) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (const char* place : places) {
    const fs::path folder = program.parent_path() / place;
    if (fs::is_directory(folder, error)) return {folder.lexically_normal()};
  }
  return {};
}

// Everything that needs the whole scene, but no mesh.
void check_scenario(Scenario& scenario, core::Mistakes& mistakes) {
  const model::Scene& scene = scenario.scene;
  solve::build_materials(scene, scenario.registry, mistakes);
  const mesh::Domain domain = solve::build_domain(scene, mistakes);
  scenario.effects = model::make_effects(scenario.plan, scene, scenario.registry, mistakes);
  if (mistakes.empty()) model::check_places(scene, domain, mistakes);
  if (mistakes.empty()) model::check_support(scene, domain, mistakes);
  if (mistakes.empty()) model::warn_of_held_loads(scene, scenario.registry);
}

/// What can be judged although other parts of the scene are wrong, so that one run reports as much as it can.
void check_sound_parts(Scenario& scenario, core::Mistakes& mistakes) {
  if (scenario.scene.root.has("plane")) solve::build_materials(scenario.scene, scenario.registry, mistakes);
  if (scenario.scene.drawn) solve::build_domain(scenario.scene, mistakes);
}

}  // namespace

std::vector<fs::path> module_folders() {
  const auto named = folders_named_by("ASHLAR_MODULES");
  return named.empty() ? beside_program({"modules", "../" ASHLAR_LIBDIR "/ashlar/modules"}) : named;
}

std::vector<fs::path> script_folders() {
  const auto named = folders_named_by("ASHLAR_SCRIPTS");
  return named.empty() ? beside_program({"../share/ashlar/scripts", "../scripts"}) : named;
}

std::vector<std::string> library_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::path& folder : script_folders())
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string library_doc(const std::string& name) {
  for (const fs::path& folder : script_folders()) {
    std::ifstream file(folder / (name + ".lua"));
    std::string text;
    for (std::string line; std::getline(file, line) && line.starts_with("--");)
      text += line.substr(line.starts_with("-- ") ? 3 : 2) + "\n";
    if (!text.empty()) return text;
  }
  return {};
}

core::Registry make_registry() {
  core::Registry registry;
  model::register_scene_kinds(registry);
  study::register_study_kinds(registry);
  model::register_drive_kinds(registry);
  script::read_module_manifests(module_folders(), registry);
  registry.set_opener(core::shared_object_opener());
  return registry;
}

std::unique_ptr<Scenario> read_scenario(const CommandLine& line) {
  auto scenario = std::make_unique<Scenario>();
  core::Mistakes mistakes;
  script::Options options;
  options.set = line.set;
  options.trust = line.trust;
  options.library = script_folders();
  {
    const auto timing = core::ledger().time("read");
    scenario->script = script::read_scene(line.words.front(), scenario->registry, options, mistakes);
  }
  const auto timing = core::ledger().time("check");
  if (!scenario->script.scene.is_nothing()) {
    scenario->scene = model::read_scene(scenario->script.scene, scenario->registry, mistakes);
    if (!mistakes.empty()) check_sound_parts(*scenario, mistakes);
  }
  mistakes.throw_if_any();
  scenario->plan = model::make_plan(scenario->scene, scenario->registry);
  check_scenario(*scenario, mistakes);
  mistakes.throw_if_any();
  return scenario;
}

}  // namespace ashlar::app
