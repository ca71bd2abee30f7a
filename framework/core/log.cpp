#include "core/log.hpp"

#include <algorithm>

namespace ashlar::core {

void Log::say(Level level, const std::string& text) {
  // Stages that inherit an entry say the same of it again.
  if (level != Level::debug &&
      std::find(lines_.begin(), lines_.end(), std::pair(level, text)) != lines_.end())
    return;
  lines_.emplace_back(level, text);
  if (sink_) sink_(level, text);
}

Log& log() {
  static Log instance;
  return instance;
}

}  // namespace ashlar::core
