#pragma once
// Calls the built program as a user would, in folders of its own.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

namespace ashlar::test {

namespace fs = std::filesystem;

inline const fs::path source_folder = ASHLAR_SOURCE_DIR;

inline std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

/// A new empty folder, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(fs::temp_directory_path() /
              ("ashlar-scratch-" + std::to_string(getpid()) + "-" + std::to_string(count_++))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }

 private:
  static inline int count_ = 0;
  fs::path path_;
};

/// Every file below a folder with its bytes, hidden ones included; folders end with '/'.
inline std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_directory())
      all[name + "/"] = "";
    else
      all[name] = read(entry.path());
  }
  return all;
}

struct Ended {
  int code = -1;  ///< 128 + signal if it was killed
  std::string out, err;
};

/// The shell's line for `before ashlar arguments`, its output going to files in `scratch`.
inline std::string command(const std::string& arguments, const std::string& before,
                           const ScratchFolder& scratch) {
  return before + " " + quoted(ASHLAR_BINARY_DIR "/ashlar") + " " + arguments + " >" +
         quoted(scratch / "out") + " 2>" + quoted(scratch / "err") + " </dev/null";
}

inline Ended ended(int status, const ScratchFolder& scratch) {
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read(scratch / "out"),
          read(scratch / "err")};
}

/// Runs `ashlar ARGUMENTS` in `folder`; `before` is shell text such as "ulimit -f 20;" or "ASHLAR_MODULES=…".
inline Ended call(const std::string& arguments, const fs::path& folder = source_folder,
                  const std::string& before = {}) {
  const ScratchFolder scratch;
  const std::string line = "cd " + quoted(folder) + " && " + command(arguments, before, scratch);
  return ended(std::system(line.c_str()), scratch);
}

/// Runs `ashlar ARGUMENTS` and presses Ctrl-C as soon as it has said `word` on stderr; at once if `word` is
/// empty. A program that neither says it nor ends is killed after two minutes.
inline Ended call_and_interrupt(const std::string& arguments, const std::string& word) {
  const ScratchFolder scratch;
  const std::string line = command(arguments, "exec", scratch);
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  bool pressed = false;
  const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (!pressed && read(scratch / "err").find(word) != std::string::npos) pressed = kill(child, SIGINT) == 0;
    if (std::chrono::steady_clock::now() > last) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return ended(status, scratch);
}

/// What a run left behind.
struct Ran : Ended {
  nlohmann::json json;  ///< of --json; null if there is none
  fs::path folder;      ///< its results
};

/// `ashlar run scene --out folder --json … words`, with `before` in front.
inline Ran run(const fs::path& scene, const fs::path& folder, const std::string& words = {},
               const std::string& before = {}) {
  const fs::path json = folder.string() + ".json";
  Ran result{
      call("run " + quoted(scene) + " --out " + quoted(folder) + " --json " + quoted(json) + " " + words,
           source_folder, before),
      {},
      folder};
  if (fs::exists(json)) result.json = nlohmann::json::parse(read(json));
  return result;
}

}  // namespace ashlar::test
