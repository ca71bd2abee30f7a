#pragma once
// Calls the built program as a user would.

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ashlar::test {

namespace fs = std::filesystem;

inline const fs::path source_folder = ASHLAR_SOURCE_DIR;

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// An empty folder that goes away with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "ashlar-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
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
  const std::string line = "cd " + quoted(folder) + " && " + before + " " + quoted(ASHLAR_PROGRAM) + " " +
                           arguments + " >" + quoted(scratch / "out") + " 2>" + quoted(scratch / "err") +
                           " </dev/null";
  const int status = std::system(line.c_str());
  Ended ended{-1, text_of(scratch / "out"), text_of(scratch / "err")};
  if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.code = 128 + WTERMSIG(status);
  return ended;
}

}  // namespace ashlar::test
