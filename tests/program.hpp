#pragma once
// Runs the built program on scenes written by tests, in a folder of its own.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace program {

namespace fs = std::filesystem;

/// A new empty folder, removed at the end.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::temp_directory_path() / ("ashlar-" + name + "-" + std::to_string(getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

inline std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// What a run left behind.
struct Run {
  int exit_code = -1;
  std::string said;     ///< stdout and stderr
  nlohmann::json json;  ///< of --json; null if there is none
  fs::path out;
};

/// `ashlar run scene --out … --json … words`, with `environment` in front ("ASHLAR_MODULES=…").
inline Run run(const fs::path& scene, const fs::path& out, const std::string& words = {},
               const std::string& environment = {}) {
  Run result;
  result.out = out;
  const fs::path log = out.string() + ".log", json = out.string() + ".json";
  const std::string command = environment + " '" ASHLAR_BINARY_DIR "/ashlar' run '" + scene.string() +
                              "' --out '" + out.string() + "' --json '" + json.string() + "' " + words +
                              " > '" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.said = read(log);
  if (fs::exists(json)) result.json = nlohmann::json::parse(read(json));
  return result;
}

}  // namespace program
