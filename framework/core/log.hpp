#pragma once
// What the program says while it works. Lines go to stderr; progress only to a terminal.

#include <functional>
#include <string>
#include <vector>

namespace ashlar::core {

enum class Level { debug, info, warning };

/// A line that was said before is not said again.
class Log {
 public:
  using Sink = std::function<void(Level, const std::string&)>;
  void set_sink(Sink sink) { sink_ = std::move(sink); }
  void debug(const std::string& text) { say(Level::debug, text); }
  void info(const std::string& text) { say(Level::info, text); }
  void warning(const std::string& text) { say(Level::warning, text); }
  /// Everything that was said, for the results' provenance.
  const std::vector<std::pair<Level, std::string>>& lines() const { return lines_; }
  void clear() { lines_.clear(); }

 private:
  void say(Level level, const std::string& text);
  Sink sink_;
  std::vector<std::pair<Level, std::string>> lines_;
};

/// The program's log. Main thread only.
Log& log();

}  // namespace ashlar::core
