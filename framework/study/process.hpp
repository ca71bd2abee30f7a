#pragma once
// Other processes: started, watched, stopped; with what they cost.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ashlar::study {

struct Ended {
  std::size_t id = 0;
  int code = 0;              ///< exit code; 128 + signal if one killed it
  double wall = 0, cpu = 0;  ///< s, start of the process included
  std::int64_t memory = 0;   ///< peak resident bytes
};

class Processes {
 public:
  /// Stops what still runs.
  ~Processes();
  Processes() = default;
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// Starts a program; its two streams go to files. It hears no Ctrl-C, and ends when this program dies.
  /// Throws std::system_error.
  void start(std::size_t id, const std::vector<std::string>& words, const std::filesystem::path& out,
             const std::filesystem::path& err);
  /// Waits until something ends, a signal comes or the time is over.
  std::vector<Ended> wait(double seconds);
  /// Resident bytes of all that run now.
  std::int64_t resident() const;
  std::size_t count() const { return children_.size(); }
  void stop();

 private:
  struct Child {
    std::size_t id;
    pid_t pid;
    int end;  ///< reading end of a pipe that closes when the child ends
    double began;
  };
  std::vector<Child> children_;
};

/// Bytes that new processes may take without harm to others: of the machine, and of the group this one is in.
std::int64_t available_memory();

}  // namespace ashlar::study
