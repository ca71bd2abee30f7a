// Reading scenarios and data files: see script.hpp.

#include <algorithm>

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

// `words` are what the script may return; another kind's table is not read any further.
void check_returned(lua_State* L, core::Value& value, const std::string& name,
                    const std::vector<std::string>& words, core::Mistakes& mistakes) {
  const core::Table* table = value.table();
  if (table && std::ranges::find(words, table->constructor) != words.end()) return;
  const core::Place place{name, table ? value.place.line : 0, {}};
  const std::string wanted = words.front() + " { … }";
  std::string advice;
  if (table && table->constructor == "Study") advice = "it is a study: `ashlar study " + name + "` runs it";
  if (table && table->constructor == "Scene") advice = "it is a scene: `ashlar run " + name + "` runs it";
  if (table && table->constructor == "Drive") advice = "it leads a law: `ashlar drive " + name + "` takes it";
  if (lua_isnil(L, -1))
    mistakes.add(
        place, "the script returns nothing",
        (wanted.starts_with("Scene") ? "a scenario" : "such a script") + (" ends with: return " + wanted));
  else if (!is_undefined(L, -1))
    mistakes.add(place, "the script must return " + wanted + ", but returns " + value.type_name(), advice);
  if (table && !table->constructor.empty()) value = {};
}

// Runs a file and converts what it returns.
core::Value run_file(const std::shared_ptr<Machine>& machine, const std::filesystem::path& file,
                     const core::Registry* registry, const Options& options, core::Mistakes& mistakes) {
  core::Value value;
  const std::string name = file.string();
  machine->mistakes = &mistakes;
  auto work = [&](lua_State* L) {
    make_sandbox(L, {registry, options.trust});
    if (machine->params) add_global(L, "param", guarded<param>);
    if (!machine->compile(L, file, name, read_text(file))) return;
    machine->run_chunk(L);
    value = convert(machine, L, -1, {name, 0, {}}, mistakes);
    if (!machine->params) return;
    check_returned(L, value, name, options.returns, mistakes);
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

// "Scene" → "scene.lua"
std::string file_of(std::string word) {
  word.front() = static_cast<char>(word.front() - 'A' + 'a');
  return word + ".lua";
}

}  // namespace

ScriptResult read_scene(const std::filesystem::path& file_or_folder, const core::Registry& registry,
                        const Options& options, core::Mistakes& mistakes) {
  std::error_code error;
  const bool folder = std::filesystem::is_directory(file_or_folder, error);
  const std::filesystem::path file =
      folder ? file_or_folder / file_of(options.returns.front()) : file_or_folder;
  const auto machine = std::make_shared<Machine>(options.seconds, options.memory);
  machine->require_from = options.library;
  machine->require_from.insert(machine->require_from.begin(), file.parent_path());
  machine->params = std::make_shared<Params>();
  for (const auto& [name, text] : options.set) machine->params->set[name] = text;
  ScriptResult result;
  result.scene = run_file(machine, file, &registry, options, mistakes);
  result.params = std::move(machine->params->uses);  // their functions must not keep their own owner alive
  for (const Source& source : machine->sources()) result.sources.emplace_back(source.path, source.text);
  return result;
}

core::Value read_data(const std::filesystem::path& file) {
  const auto machine = std::make_shared<Machine>(data_seconds, data_memory);
  core::Mistakes mistakes;
  core::Value value = run_file(machine, file, nullptr, {}, mistakes);
  if (mistakes.empty() && !value.table()) mistakes.add({file.string(), 0, {}}, "must return a table");
  mistakes.throw_if_any();
  return value;
}

}  // namespace ashlar::script
