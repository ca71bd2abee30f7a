// ashlar run: the straight line from a script to results.

#include <iostream>
#include <thread>

#include "app/host.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "core/ledger.hpp"
#include "core/log.hpp"
#include "core/parallel.hpp"
#include "output/files.hpp"
#include "output/json.hpp"
#include "output/summary.hpp"
#include "output/transaction.hpp"
#include "output/write_all.hpp"
#include "solve/build.hpp"

namespace ashlar::app {

namespace {

namespace fs = std::filesystem;

fs::path results_folder(const CommandLine& line) {
  if (!line.out.empty()) return line.out;
  const fs::path scene = line.words.front();
  return (fs::is_directory(scene) ? scene : scene.parent_path()) / "results";
}

/// A folder or file that cannot be written shows now, before anything is computed.
void check_writable(const CommandLine& line, const fs::path& out) {
  if (line.files) const output::Transaction trial(out);
  if (line.json.empty() || line.json == "-") return;
  const fs::path folder = fs::absolute(line.json).parent_path();
  if (!fs::is_directory(folder)) fail("--json: there is no folder " + folder.string(), "");
  if (fs::is_directory(line.json)) fail("--json: " + line.json + " is a folder", "name a file in it");
}

std::string text_of(const core::Value& value) {
  if (const core::Quantity* quantity = value.quantity())
    return output::shortest(quantity->value) +
           (quantity->bare ? "" : " " + core::to_string(quantity->dimension));
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  return value.text() ? *value.text() : value.type_name();
}

void add_provenance(const CommandLine& line, const script::ScriptResult& script, output::RunRecord& record) {
  for (const auto& [path, text] : script.sources) record.sources.push_back({path.string(), text});
  for (const script::ParamUse& param : script.params)
    record.parameters.push_back({param.name, text_of(param.value), param.said});
  record.versions.emplace_back("ashlar", ASHLAR_VERSION);
  record.command_line = line.text;
  record.threads = core::thread_count();
}

/// The file appears whole or not at all.
void write_json(const CommandLine& line, const output::RunRecord& record) {
  if (line.json.empty()) return;
  const std::string text = output::results_json(record);
  if (line.json == "-") {
    std::cout << text << '\n';
    return;
  }
  const fs::path partial = line.json + ".partial";
  std::error_code error;
  try {
    output::write_file(partial, text);
    fs::rename(partial, line.json);
  } catch (...) {
    fs::remove(partial, error);
    throw;
  }
}

void tell_failure(const output::RunRecord& record, const std::vector<fs::path>& files) {
  const model::RunResult& result = record.result;
  const model::StageResult& failed = result.stages.back();
  std::cerr << "Stage '" << failed.name << "' did not converge: " << failed.reason << '\n';
  if (!failed.advice.empty()) std::cerr << "    what to try: " << failed.advice << '\n';
  std::cerr << "    "
            << (result.good().empty() ? "no stage before it was computed"
                                      : "the last good stage is '" + result.good().back().name + "'");
  if (!files.empty()) std::cerr << ": see " << files.front().parent_path().string();
  std::cerr << "; results of earlier runs are untouched\n";
}

int conclude(const CommandLine& line, const output::RunRecord& record, const std::vector<fs::path>& files) {
  // With --json - the terminal belongs to the machine that reads it.
  std::ostream& out = line.json == "-" ? std::cerr : std::cout;
  if (!line.quiet) out << output::summary(record, files);
  if (record.result.converged) return done;
  tell_failure(record, files);
  return not_converged;
}

}  // namespace

int run(const CommandLine& line) {
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  core::set_thread_count(line.threads > 0 ? line.threads : cores);
  show_log(line.quiet);
  Progress progress(line.quiet);

  const auto scenario = read_scenario(line);
  const fs::path out = results_folder(line);
  check_writable(line, out);

  progress.begin("meshing");
  core::Mistakes mistakes;
  const model::Model model =
      solve::build_model(scenario->scene, scenario->effects, scenario->registry, mistakes);
  mistakes.throw_if_any();
  const mesh::MeshReport mesh_report = mesh::report(model.mesh);

  const model::RunResult result =
      solve::march({scenario->scene, scenario->plan, model, scenario->registry, scenario->effects}, progress);

  progress.begin("writing");
  output::RunRecord record{scenario->scene,
                           scenario->plan,
                           model,
                           result,
                           mesh_report,
                           core::ledger(),
                           core::log(),
                           {},
                           {},
                           {},
                           scenario->registry.open_modules(),
                           {},
                           1};
  add_provenance(line, scenario->script, record);
  std::vector<fs::path> files;
  if (line.files) {
    const auto timing = core::ledger().time("write");
    files = output::write_results(record, out);
  }
  write_json(line, record);
  return conclude(line, record, files);
}

}  // namespace ashlar::app
