#pragma once
// The words after `ashlar` as data.

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ashlar::app {

struct CommandLine {
  std::string verb;                                      ///< "run", "check" …, "help" or "version"
  std::vector<std::string> words;                        ///< SCENE, or KIND[.NAME]
  std::vector<std::pair<std::string, std::string>> set;  ///< --set key=value
  std::string out;                                       ///< --out; empty: `results` beside the scene
  std::string json;                                      ///< --json; empty: none
  int threads = 0;                                       ///< --threads; 0: as many as the machine has
  int jobs = 0;                                          ///< --jobs; 0: as many as the machine has
  std::string resume = "all";                            ///< --resume: which earlier runs of a study are kept
  bool files = true;                                     ///< false: --no-files
  bool quiet = false;
  bool trust = false;
  std::string text;  ///< the whole line, for provenance
};

/// Throws InputError for what cannot be understood.
CommandLine read_command_line(std::span<char* const> arguments);

/// Throws the InputError of a mistake on the command line.
[[noreturn]] void fail(std::string what, std::string advice = "`ashlar --help` tells how to call it");

/// What `ashlar --help` prints.
std::string help_text();

}  // namespace ashlar::app
