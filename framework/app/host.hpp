#pragma once
// What the program finds around itself: modules, the script library, and the scene it is given.

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "app/command_line.hpp"
#include "core/registry.hpp"
#include "model/plan.hpp"
#include "script/script.hpp"

namespace ashlar::app {

std::vector<std::filesystem::path> module_folders();
std::vector<std::filesystem::path> script_folders();

/// The names that `require` finds in the script library.
std::vector<std::string> library_names();
/// The comment that such a file begins with, without its dashes; empty if there is none.
std::string library_doc(const std::string& name);

/// The framework's kinds and those of all modules found. Opens no module's library.
core::Registry make_registry();

/// A scene that was read and checked as far as this goes without a mesh.
struct Scenario {
  core::Registry registry = make_registry();
  script::ScriptResult script;
  model::Scene scene;
  model::Plan plan;
  std::map<std::string, std::unique_ptr<model::Effect>> effects;
};

/// Throws InputError with every mistake found.
std::unique_ptr<Scenario> read_scenario(const CommandLine& line);

}  // namespace ashlar::app
