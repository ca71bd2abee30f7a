// Reading scenarios and data files: see script.hpp.

#include "script/convert.hpp"
#include "script/param.hpp"
#include "script/sandbox.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

constexpr double data_seconds = 10;
constexpr std::size_t data_memory = std::size_t{1} << 30;

// A message about an undefined value only follows from a mistake that is reported already.
void add_failure(const Failure& failure, core::Mistakes& mistakes) {
  const bool follows = failure.what.find(undefined_type_name) != std::string::npos && !mistakes.empty();
  if (!follows) mistakes.add(failure.place, failure.what, failure.advice);
}

void check_is_scene(lua_State* L, const core::Value& value, const std::string& name,
                    core::Mistakes& mistakes) {
  const core::Table* table = value.table();
  if (table && table->constructor == "Scene") return;
  const core::Place place{name, table ? value.place.line : 0, {}};
  if (lua_isnil(L, -1))
    mistakes.add(place, "the script returns nothing", "a scenario ends with: return Scene { … }");
  else if (!is_undefined(L, -1))
    mistakes.add(place, "the script must return Scene { … }, but returns " + value.type_name());
}

// Runs a file and converts what it returns.
core::Value run_file(const std::shared_ptr<Machine>& machine, const std::filesystem::path& file,
                     const core::Registry* registry, bool trust, core::Mistakes& mistakes) {
  core::Value value;
  const std::string name = file.string();
  machine->mistakes = &mistakes;
  auto work = [&](lua_State* L) {
    make_sandbox(L, {registry, trust});
    if (machine->params) add_global(L, "param", guarded<param>);
    if (!machine->compile(L, file, name, read_text(file))) return;
    machine->run_chunk(L);
    value = convert(machine, L, -1, {name, 0, {}}, mistakes);
    if (!machine->params) return;
    check_is_scene(L, value, name, mistakes);
    check_all_used(*machine->params, mistakes);
  };
  try {
    if (const auto failure = machine->protect(work)) add_failure(*failure, mistakes);
  } catch (const core::InputError& error) {
    mistakes.add(error);
  }
  machine->mistakes = nullptr;
  return value;
}

}  // namespace

ScriptResult read_scene(const std::filesystem::path& file_or_folder, const core::Registry& registry,
                        const Options& options, core::Mistakes& mistakes) {
  std::error_code error;
  const bool folder = std::filesystem::is_directory(file_or_folder, error);
  const std::filesystem::path file = folder ? file_or_folder / "scene.lua" : file_or_folder;
  const auto machine = std::make_shared<Machine>(options.seconds, options.memory);
  machine->require_from = options.library;
  machine->require_from.insert(machine->require_from.begin(), file.parent_path());
  machine->params = std::make_shared<Params>();
  for (const auto& [name, text] : options.set) machine->params->set[name] = text;
  ScriptResult result;
  result.scene = run_file(machine, file, &registry, options.trust, mistakes);
  result.params = std::move(machine->params->uses);  // their functions must not keep their own owner alive
  for (const Source& source : machine->sources()) result.sources.emplace_back(source.path, source.text);
  return result;
}

core::Value read_data(const std::filesystem::path& file) {
  const auto machine = std::make_shared<Machine>(data_seconds, data_memory);
  core::Mistakes mistakes;
  core::Value value = run_file(machine, file, nullptr, false, mistakes);
  if (mistakes.empty() && !value.table()) mistakes.add({file.string(), 0, {}}, "must return a table");
  mistakes.throw_if_any();
  return value;
}

}  // namespace ashlar::script
