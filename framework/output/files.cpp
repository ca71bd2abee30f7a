#include "output/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstring>

#include "core/error.hpp"

namespace ashlar::output {

void fail_to_write(const std::filesystem::path& path, int error) {
  core::Mistake mistake;
  mistake.place.file = path.string();
  mistake.what = std::string("cannot be written: ") + std::strerror(error);
  if (error == EACCES || error == EROFS || error == EPERM)
    mistake.advice = "name a folder that you may write to with --out";
  if (error == ENOSPC || error == EDQUOT || error == EFBIG)
    mistake.advice = "make room, or name another folder with --out; earlier results are untouched";
  throw core::InputError(mistake);
}

namespace {

/// A limit on file sizes must come back as an error, not as a signal that ends the program.
class NoSizeSignal {
 public:
  NoSizeSignal() { earlier_ = std::signal(SIGXFSZ, SIG_IGN); }
  ~NoSizeSignal() { std::signal(SIGXFSZ, earlier_); }
  NoSizeSignal(const NoSizeSignal&) = delete;
  NoSizeSignal& operator=(const NoSizeSignal&) = delete;

 private:
  void (*earlier_)(int);
};

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  const NoSizeSignal guard;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail_to_write(path, errno);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int error = written < 0 ? errno : ENOSPC;
      ::close(file);
      fail_to_write(path, error);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  // Quotas and network file systems may complain only now.
  if (::close(file) != 0) fail_to_write(path, errno);
}

std::string file_name(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const auto u = static_cast<unsigned char>(c);
    const bool plain = u >= 0x80 || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                       (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || c == '.';
    text += plain ? c : '_';
  }
  // Neither a hidden file nor "..", and short enough for every file system with what is added to it.
  if (text.empty() || text.front() == '.') text.insert(0, 1, '_');
  if (text.size() > 120) text.resize(120);
  return text;
}

std::string stage_file_name(std::size_t number, const std::string& name) {
  const std::string digits = std::to_string(number);
  return (digits.size() < 2 ? "0" + digits : digits) + "_" + file_name(name);
}

std::string shortest(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace ashlar::output
