#pragma once
// Calls the built program with any words, as a user would.

#include <string>

#include "program.hpp"

namespace ashlar::test {

namespace fs = std::filesystem;
using program::read;
using program::write;

inline const fs::path source_folder = ASHLAR_SOURCE_DIR;

/// An empty folder of its own name.
class ScratchFolder : public program::Folder {
 public:
  ScratchFolder() : Folder("scratch-" + std::to_string(count_++)) {}

 private:
  static inline int count_ = 0;
};

struct Ended {
  int code = -1;  ///< 128 + signal if it was killed
  std::string out, err;
};

inline std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

/// Runs `ashlar ARGUMENTS` in `folder`; `before` is shell text such as "ulimit -f 20;".
inline Ended call(const std::string& arguments, const fs::path& folder = source_folder,
                  const std::string& before = {}) {
  const ScratchFolder scratch;
  const std::string line = "cd " + quoted(folder) + " && " + before + " " +
                           quoted(ASHLAR_BINARY_DIR "/ashlar") + " " + arguments + " >" +
                           quoted(scratch / "out") + " 2>" + quoted(scratch / "err") + " </dev/null";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read(scratch / "out"),
          read(scratch / "err")};
}

}  // namespace ashlar::test
