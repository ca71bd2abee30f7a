// ashlar drive: the law of a material, or of a joint, alone along a path.

#include <iostream>

#include "app/host.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "output/drive_joint_output.hpp"
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

/// What a drive left: its words, its table and picture, and how it ended.
struct Outcome {
  std::string csv, table;
  output::Picture picture;
  bool converged = true;
  std::string reason, advice;
};

std::vector<fs::path> write(const Outcome& outcome, const fs::path& folder) {
  output::Transaction transaction(folder);
  output::write_file(transaction.file("drive.csv"), outcome.csv);
  output::write_file(transaction.file("drive.png"), output::png_bytes(outcome.picture));
  output::write_file(transaction.file("drive.svg"), output::svg_bytes(outcome.picture));
  return transaction.commit();
}

int finish(const CommandLine& line, const std::string& title, const Outcome& outcome) {
  const auto files = write(outcome, folder_of(line));
  if (!line.quiet) {
    std::cout << title << "\n" << outcome.table;
    for (const fs::path& file : files) std::cout << "  " << file.string() << '\n';
  }
  if (outcome.converged) return done;
  std::cerr << "Not reached: " << outcome.reason << "\n    what to try: " << outcome.advice << '\n';
  return not_converged;
}

int drive_material(const CommandLine& line, const model::Drive& drive) {
  const solve::DriveResult result = solve::drive(drive);
  return finish(
      line, drive.title,
      {output::drive_csv(result), output::drive_table(result), output::drive_picture(drive, result),
       result.converged, result.reason, "a stress that the law can carry, or strains in its place"});
}

int drive_joint(const CommandLine& line, const model::Drive& drive) {
  const solve::JointDriveResult result = solve::drive_joint(drive);
  return finish(line, drive.title,
                {output::drive_csv(drive, result), output::drive_table(result),
                 output::drive_picture(drive, result), result.converged, result.reason,
                 "a pressure and a shear that the laws can carry, or opening and slip in their place"});
}

}  // namespace

int drive(const CommandLine& line) {
  show_log(line.quiet);
  core::Registry registry = make_registry();
  script::ScriptResult script;
  const model::Drive drive = read_drive(line, registry, script);
  return drive.joint ? drive_joint(line, drive) : drive_material(line, drive);
}

}  // namespace ashlar::app
