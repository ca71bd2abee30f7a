#pragma once
// Lua in, plain data out: scenarios, modules' manifests and tables of expected numbers.
// Scripts run in a sandbox with limits; nothing is computed here.

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/registry.hpp"
#include "core/value.hpp"

namespace ashlar::script {

struct Options {
  std::vector<std::pair<std::string, std::string>> set;  ///< `--set name=expression`; the last of a name wins
  std::vector<std::filesystem::path> library;            ///< searched by `require` after the scene's folder
  std::string returns = "Scene";              ///< the word of the table that the script must return
  bool trust = false;                         ///< gives the script io and os
  double seconds = 10;                        ///< wall time of the script, and of each later call
  std::size_t memory = std::size_t{1} << 30;  ///< bytes of the script's own memory
};

/// One `param { "name", default = …, doc = … }` of the script.
struct ParamUse {
  std::string name;
  core::Value value;
  core::Value fallback;  ///< the default
  std::string doc;
  bool said = false;  ///< set from outside
  core::Place place;
};

/// The keys of `param { … }`, for describe.
const core::Schema& param_schema();

struct ScriptResult {
  core::Value scene;  ///< the table of `return Scene { … }`; nothing if the script failed
  std::vector<ParamUse> params;
  std::vector<std::pair<std::filesystem::path, std::string>>
      sources;  ///< every file that was read, and its text
};

/// Runs a scenario: a file, or a folder with scene.lua in it. Every mistake goes to `mistakes`, with the
/// file as it was given; nothing is thrown for a user's mistake. Undefined names give a value that absorbs
/// whatever is done with it (it arrives as nothing), so that later mistakes are found in the same run.
/// Functions inside the scene keep the script's memory alive and may be called until they are destroyed.
ScriptResult read_scene(const std::filesystem::path& file_or_folder, const core::Registry& registry,
                        const Options& options, core::Mistakes& mistakes);

/// Reads every */module.lua in the folders, sorted by folder name, and registers what they provide; opens no
/// library. A module's library is FOLDER/ashlar_NAME.so. Folders that do not exist are skipped.
/// Throws InputError with all mistakes found.
void read_module_manifests(const std::vector<std::filesystem::path>& folders, core::Registry& registry);

/// The table that a data file such as expected.lua returns. Throws InputError.
core::Value read_data(const std::filesystem::path& file);

/// Ends the running script at its next step; safe in a signal handler.
void request_stop() noexcept;
/// Forgets an earlier request, so that scripts may run again.
void clear_stop() noexcept;

}  // namespace ashlar::script
