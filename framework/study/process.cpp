#include "study/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <limits>
#include <system_error>

namespace ashlar::study {

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int open_for(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw std::system_error(errno, std::generic_category(), path.string());
  return file;
}

// Only calls that are safe between fork and exec.
[[noreturn]] void become(char* const* words, int out, int err, int pipe, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  ::setpgid(0, 0);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::fcntl(pipe, F_SETFD, 0);
  ::execv(words[0], words);
  ::_exit(127);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

std::int64_t number_in(const char* path, std::int64_t otherwise) {
  std::ifstream file(path);
  std::int64_t number = 0;
  return file >> number ? number : otherwise;
}

}  // namespace

Processes::~Processes() {
  stop();
}

void Processes::start(std::size_t id, const std::vector<std::string>& words, const std::filesystem::path& out,
                      const std::filesystem::path& err) {
  std::vector<char*> list;
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  const int out_file = open_for(out), err_file = open_for(err);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const double began = now();
  const pid_t parent = ::getpid(), pid = ::fork();
  if (pid == 0) become(list.data(), out_file, err_file, ends[1], parent);
  const int error = errno;
  for (const int file : {out_file, err_file, ends[1]}) ::close(file);
  if (pid > 0) {
    ::setpgid(pid, pid);
    children_.push_back({id, pid, ends[0], began});
    return;
  }
  ::close(ends[0]);
  throw std::system_error(error, std::generic_category(), words.front());
}

std::vector<Ended> Processes::wait(double time) {
  std::vector<pollfd> watched;
  for (const Child& child : children_) watched.push_back({child.end, POLLIN, 0});
  std::vector<Ended> ended;
  if (::poll(watched.data(), watched.size(), static_cast<int>(1000 * time)) <= 0) return ended;
  const double moment = now();
  for (std::size_t i = watched.size(); i-- > 0;) {
    if (watched[i].revents == 0) continue;
    const Child child = children_[i];
    int status = 0;
    rusage use{};
    while (::wait4(child.pid, &status, 0, &use) < 0 && errno == EINTR) {
    }
    ::close(child.end);
    children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
    ended.push_back({child.id, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
                     moment - child.began, seconds(use.ru_utime) + seconds(use.ru_stime),
                     static_cast<std::int64_t>(use.ru_maxrss) * 1024});
  }
  return ended;
}

std::int64_t Processes::resident() const {
  std::int64_t bytes = 0;
  for (const Child& child : children_) {
    std::ifstream file("/proc/" + std::to_string(child.pid) + "/statm");
    std::int64_t size = 0, pages = 0;
    if (file >> size >> pages) bytes += pages * ::sysconf(_SC_PAGESIZE);
  }
  return bytes;
}

void Processes::stop() {
  // Each is a group of its own: what it started itself ends too.
  for (const Child& child : children_) ::kill(-child.pid, SIGTERM);
  const double patience = now() + 10;
  while (!children_.empty() && now() < patience) wait(0.2);
  for (const Child& child : children_) ::kill(-child.pid, SIGKILL);
  while (!children_.empty()) wait(1);
}

std::int64_t available_memory() {
  constexpr auto unlimited = std::numeric_limits<std::int64_t>::max();
  std::int64_t machine = unlimited, kilobytes = 0;
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;)
    if (word == "MemAvailable:" && file >> kilobytes) machine = kilobytes * 1024;
  const std::int64_t most = number_in("/sys/fs/cgroup/memory.max", unlimited);
  const std::int64_t used = number_in("/sys/fs/cgroup/memory.current", 0);
  return std::min(machine, most == unlimited ? unlimited : most - used);
}

}  // namespace ashlar::study
