// ashlar drive: a material law alone along a path of strains.

#include <iostream>

#include "app/host.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "output/drive_output.hpp"
#include "output/files.hpp"
#include "output/transaction.hpp"

namespace ashlar::app {

namespace {

namespace fs = std::filesystem;

model::Drive read_drive(const CommandLine& line, core::Registry& registry, script::ScriptResult& script) {
  core::Mistakes mistakes;
  script::Options options;
  options.set = line.set;
  options.trust = line.trust;
  options.library = script_folders();
  options.returns = {"Drive"};
  script = script::read_scene(line.words.front(), registry, options, mistakes);
  const core::Table* table = script.scene.table();
  model::Drive drive;
  if (table && table->constructor == "Drive") drive = model::read_drive(script.scene, registry, mistakes);
  mistakes.throw_if_any();
  return drive;
}

/// Beside the script and named after it: a scene's results in the same folder stay.
fs::path folder_of(const CommandLine& line) {
  if (!line.out.empty()) return line.out;
  const fs::path script = line.words.front();
  return fs::is_directory(script) ? script / "drive"
                                  : script.parent_path() / (script.stem().string() + "_drive");
}

std::vector<fs::path> write(const model::Drive& drive, const solve::DriveResult& result,
                            const fs::path& folder) {
  output::Transaction transaction(folder);
  const output::Picture picture = output::drive_picture(drive, result);
  output::write_file(transaction.file("drive.csv"), output::drive_csv(result));
  output::write_file(transaction.file("drive.png"), output::png_bytes(picture));
  output::write_file(transaction.file("drive.svg"), output::svg_bytes(picture));
  return transaction.commit();
}

}  // namespace

int drive(const CommandLine& line) {
  show_log(line.quiet);
  core::Registry registry = make_registry();
  script::ScriptResult script;
  const model::Drive drive = read_drive(line, registry, script);
  const solve::DriveResult result = solve::drive(drive);
  const auto files = write(drive, result, folder_of(line));
  if (!line.quiet) {
    std::cout << drive.title << "\n" << output::drive_table(result);
    for (const fs::path& file : files) std::cout << "  " << file.string() << '\n';
  }
  if (result.converged) return done;
  std::cerr << "Not reached: " << result.reason
            << "\n    what to try: a stress that the law can carry, or strains in its place\n";
  return not_converged;
}

}  // namespace ashlar::app
