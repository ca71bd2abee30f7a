#include "core/log.hpp"

namespace ashlar::core {

void Log::say(Level level, const std::string& text) {
  lines_.emplace_back(level, text);
  if (sink_) sink_(level, text);
}

Log& log() {
  static Log instance;
  return instance;
}

}  // namespace ashlar::core
