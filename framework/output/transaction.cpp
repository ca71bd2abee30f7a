#include "output/transaction.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <future>
#include <system_error>

#include "output/files.hpp"

namespace ashlar::output {

namespace fs = std::filesystem;

namespace {

constexpr const char* manifest_name = ".ashlar-files";
constexpr const char* lock_name = ".lock";

std::string staging_prefix(const fs::path& folder) {
  return "." + folder.filename().string() + ".partial-";
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_to_write(folder, error.value());
  if (!fs::is_directory(folder)) fail_to_write(folder, ENOTDIR);
}

// The lock tells a living run from a killed one, even where process numbers mean nothing (containers).
bool is_abandoned(const fs::path& staging, const std::string& pid) {
  const int lock = ::open((staging / lock_name).c_str(), O_RDWR | O_CLOEXEC);
  if (lock >= 0) {
    const bool free = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
    ::close(lock);
    return free;
  }
  const bool number = !pid.empty() && pid.size() < 10 &&
                      std::all_of(pid.begin(), pid.end(), [](char c) { return c >= '0' && c <= '9'; });
  return number && ::kill(static_cast<pid_t>(std::stol(pid)), 0) != 0 && errno == ESRCH;
}

void sync(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail_to_write(path, errno);
  const int failed = ::fsync(file) != 0 ? errno : 0;
  ::close(file);
  if (failed != 0) fail_to_write(path, failed);
}

// Many files are waited for at once, so that the file system's journal commits once and not a dozen times;
// the threads do nothing but wait. Where the system gives no thread, one after the other is waited for. What
// follows are renames, which come whole.
void sync_all(const fs::path& folder, const std::vector<std::string>& names) {
  constexpr std::size_t at_once = 24;
  constexpr auto either = std::launch::async | std::launch::deferred;
  for (std::size_t begin = 0; begin < names.size(); begin += at_once) {
    std::vector<std::future<void>> waiting;
    for (std::size_t i = begin; i < std::min(names.size(), begin + at_once); ++i) {
      // A name of its own, so that it is copied: a moved one is lost where the thread does not come.
      const auto wait = [path = folder / names[i]] { sync(path); };
      waiting.push_back(std::async(either, wait));
    }
    for (std::future<void>& each : waiting) each.get();
  }
}

bool safe(const std::string& name) {
  const fs::path path(name);
  if (name.empty() || path.is_absolute()) return false;
  return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

// Removes one of our files, and its folder below `folder` if nothing is left in it.
void remove_file(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  const fs::path path = folder / name;
  if (fs::is_directory(fs::symlink_status(path, ignored))) return;
  fs::remove(path, ignored);
  if (path.parent_path() != folder && fs::is_empty(path.parent_path(), ignored))
    fs::remove(path.parent_path(), ignored);
}

}  // namespace

std::vector<std::string> manifest(const fs::path& folder) {
  std::vector<std::string> names;
  std::ifstream file(folder / manifest_name);
  for (std::string line; std::getline(file, line);)
    if (safe(line)) names.push_back(line);
  return names;
}

void remove_results(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / manifest_name, ignored)) return;
  for (const std::string& name : manifest(folder)) remove_file(folder, name);
  fs::remove(folder / manifest_name, ignored);
  if (fs::is_empty(folder, ignored)) fs::remove(folder, ignored);
}

Transaction::Transaction(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  folder_ = fs::absolute(folder_, error).lexically_normal();
  if (error) fail_to_write(folder_, error.value());
  if (folder_.filename().empty()) folder_ = folder_.parent_path();
  made_folder_ = !fs::exists(folder_, error);
  make_folders(folder_);
  // A folder that takes no files must show before anything is computed, not at the end.
  if (::access(folder_.c_str(), W_OK | X_OK) != 0) fail_to_write(folder_, errno);
  make_staging();
  remove_leftovers();
}

void Transaction::make_staging() {
  const std::string name = staging_prefix(folder_) + std::to_string(::getpid());
  staging_ = folder_.parent_path() / name;
  std::error_code error;
  fs::remove_all(staging_, error);
  fs::create_directory(staging_, error);
  // The folder's parent may be closed to us while the folder itself is ours.
  if (error) {
    staging_ = folder_ / name;
    fs::remove_all(staging_, error);
    fs::create_directory(staging_, error);
  }
  if (error) fail_to_write(staging_, error.value());
  const fs::path lock = staging_ / lock_name;
  lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0) {
    const int reason = errno;
    fs::remove_all(staging_, error);
    fail_to_write(lock, reason);
  }
  ::flock(lock_, LOCK_EX | LOCK_NB);
}

void Transaction::remove_leftovers() const {
  const std::string prefix = staging_prefix(folder_);
  std::error_code ignored;
  std::vector<fs::path> abandoned;
  for (const fs::path& place : {folder_.parent_path(), folder_})
    for (const fs::directory_entry& entry : fs::directory_iterator(place, ignored)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with(prefix) || entry.path() == staging_) continue;
      if (is_abandoned(entry.path(), name.substr(prefix.size()))) abandoned.push_back(entry.path());
    }
  for (const fs::path& path : abandoned) fs::remove_all(path, ignored);
}

Transaction::~Transaction() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (lock_ >= 0) ::close(lock_);
  if (made_folder_ && fs::is_empty(folder_, ignored)) fs::remove(folder_, ignored);
}

fs::path Transaction::file(const std::string& name) {
  if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  fs::path path = staging_ / name;
  make_folders(path.parent_path());
  return path;
}

void Transaction::write_manifest(const std::vector<std::string>& names) const {
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  write_file(staging_ / manifest_name, text);
  if (::rename((staging_ / manifest_name).c_str(), (folder_ / manifest_name).c_str()) != 0)
    fail_to_write(folder_ / manifest_name, errno);
}

void Transaction::move_files() const {
  for (const std::string& name : names_) {
    const fs::path place = folder_ / name;
    make_folders(place.parent_path());
    if (::rename((staging_ / name).c_str(), place.c_str()) != 0) fail_to_write(place, errno);
  }
}

std::vector<fs::path> Transaction::commit() {
  sync_all(staging_, names_);
  // Two runs that finish at once into one folder take turns.
  const int turn = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (turn >= 0) ::flock(turn, LOCK_EX);
  const std::vector<std::string> earlier = manifest(folder_);
  // First all names, old and new: whatever happens from here, the next run knows which files are ours.
  std::vector<std::string> all = names_;
  for (const std::string& name : earlier)
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) all.push_back(name);
  write_manifest(all);
  move_files();
  for (std::size_t i = names_.size(); i < all.size(); ++i) remove_file(folder_, all[i]);
  write_manifest(names_);
  if (turn >= 0) ::close(turn);
  std::vector<fs::path> places;
  for (const std::string& name : names_) places.push_back(folder_ / name);
  return places;
}

}  // namespace ashlar::output
