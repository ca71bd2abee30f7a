#include "app/command_line.hpp"

#include <algorithm>
#include <charconv>

#include "core/error.hpp"

namespace ashlar::app {

namespace {

const std::vector<std::string> verbs = {"run", "check", "plan", "study", "drive", "list", "describe"};
const std::vector<std::string> options = {"--set",  "--out",      "--json",   "--threads",
                                          "--jobs", "--resume",   "--quiet",  "--trust",
                                          "--help", "--no-files", "--version"};

int read_count(const std::string& name, const std::string& word) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || number < 1 || number > 1024)
    fail(name + " takes a whole number from 1 to 1024, got '" + word + "'");
  return number;
}

std::string read_resume(const std::string& word) {
  static const std::vector<std::string> choices = {"all", "good", "none"};
  if (std::find(choices.begin(), choices.end(), word) == choices.end())
    fail("--resume takes all, good or none, got '" + word + "'", core::did_you_mean(word, choices));
  return word;
}

std::pair<std::string, std::string> read_setting(const std::string& word) {
  const auto equal = word.find('=');
  if (equal == std::string::npos || equal == 0)
    fail("--set takes key=value, got '" + word + "'", "for example --set level=12");
  return {word.substr(0, equal), word.substr(equal + 1)};
}

/// Reads one option; `value` gives the word that follows it.
template <class Value>
void read_option(const std::string& name, Value value, CommandLine& line) {
  if (name == "--quiet")
    line.quiet = true;
  else if (name == "--trust")
    line.trust = true;
  else if (name == "--set")
    line.set.push_back(read_setting(value()));
  else if (name == "--out")
    line.out = value();
  else if (name == "--json")
    line.json = value();
  else if (name == "--threads")
    line.threads = read_count(name, value());
  else if (name == "--jobs")
    line.jobs = read_count(name, value());
  else if (name == "--resume")
    line.resume = read_resume(value());
  else if (name == "--no-files")
    line.files = false;
  else
    fail("there is no option '" + name + "'", core::did_you_mean(name, options));
}

void check_words(const CommandLine& line) {
  const auto count = line.words.size();
  const bool takes_scene = line.verb == "run" || line.verb == "check" || line.verb == "plan";
  if (takes_scene && count != 1)
    fail("`ashlar " + line.verb + "` takes one scene, got " + std::to_string(count),
         "for example: ashlar " + line.verb + " examples/jointed_dam");
  if (line.verb == "study" && count != 1)
    fail("`ashlar study` takes one study, got " + std::to_string(count),
         "for example: ashlar study examples/jointed_dam");
  if (line.verb == "study" && (!line.json.empty() || !line.files))
    fail("`ashlar study` takes neither --json nor --no-files",
         "it always writes study.json; whether the runs write files says `files` in the study");
  if (line.verb != "study" && (line.jobs != 0 || line.resume != "all"))
    fail("--jobs and --resume are for `ashlar study`", "`ashlar --help` tells what each verb takes");
  if (line.verb == "drive" && count != 1)
    fail("`ashlar drive` takes one script, got " + std::to_string(count),
         "one that returns Drive { … }: see `ashlar describe Drive`");
  if (line.verb == "drive" && !line.json.empty())
    fail("`ashlar drive` writes no JSON", "its numbers are in drive.csv");
  if (line.verb == "list" && count > 1) fail("`ashlar list` takes one kind or nothing");
  if (line.verb == "describe" && count != 1)
    fail("`ashlar describe` takes a kind, an entry or a word of the script",
         "for example: ashlar describe Polygon");
}

}  // namespace

void fail(std::string what, std::string advice) {
  core::Mistakes mistakes;
  mistakes.add({}, std::move(what), std::move(advice));
  throw core::InputError(mistakes.list());
}

CommandLine read_command_line(std::span<char* const> arguments) {
  CommandLine line;
  std::vector<std::string> words(arguments.begin() + 1, arguments.end());
  line.text = "ashlar";
  for (const std::string& word : words) line.text += " " + word;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    if (word == "--help" || word == "-h" || word == "--version") {
      line.verb = word == "--version" ? "version" : "help";
      return line;
    }
    if (!word.starts_with("-")) {
      (line.verb.empty() ? line.verb : line.words.emplace_back()) = word;
      continue;
    }
    std::string name = word.substr(0, word.find('='));
    const bool joined = name != word;
    const auto value = [&]() -> std::string {
      if (joined) return word.substr(name.size() + 1);
      if (++i == words.size()) fail(name + " needs a value");
      return words[i];
    };
    read_option(name, value, line);
  }
  if (line.verb.empty()) line.verb = "help";
  if (line.verb == "help") return line;
  if (std::find(verbs.begin(), verbs.end(), line.verb) == verbs.end())
    fail("'" + line.verb + "' is nothing that ashlar can do", core::did_you_mean(line.verb, verbs));
  check_words(line);
  return line;
}

std::string help_text() {
  return R"(ashlar computes how jointed masses carry load: dams, their foundations, the joints in and between them.

  ashlar run SCENE         compute a scene and write its results
  ashlar check SCENE       report every mistake in a scene; nothing is computed
  ashlar plan SCENE        mesh a scene and say what would be simulated, what not, and at what size
  ashlar study STUDY       run a scene many times and tell what accuracy costs: table, JSON and a page with plots
  ashlar drive FILE        lead the law of a material or joint alone along a path: table, CSV, picture
  ashlar list [KIND]       what can be said in a script, by kind
  ashlar describe WORD     keys, units, defaults, ranges of a kind, an entry or a word: mesh, mesh.voronoi, Polygon, units

SCENE is a Lua file, or a folder with scene.lua in it; STUDY the same with study.lua;
FILE is one that returns Drive { … }.

  --set key=value    give a parameter of the scene another value; may be repeated
  --out DIR          where results go; default: the folder results beside the scene, results/study beside a study,
                     NAME_drive beside a Drive
  --json FILE        also write the results for machines; - for the terminal
  --no-files         write nothing but what --json asks for
  --threads N        default: as many as the machine has; results do not depend on it
  --jobs N           study: runs side by side, if memory allows; default: as many as the machine has
  --resume WHICH     study: earlier runs to keep: all (the default), good (failed ones are run again) or none
  --quiet            say nothing but mistakes and warnings
  --trust            let the script read and write files and run programs
  --version, --help

Exit codes: 0 done, 2 a mistake in the input, 3 not converged, 1 our fault, 130 stopped by Ctrl-C.
ASHLAR_MODULES and ASHLAR_SCRIPTS name other folders for modules and for the script library, separated by ':'.
)";
}

}  // namespace ashlar::app
