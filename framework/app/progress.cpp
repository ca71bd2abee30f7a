#include "app/progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <iostream>

#include "app/interrupt.hpp"
#include "core/log.hpp"

namespace ashlar::app {

namespace {

constexpr const char* clear_line = "\r\033[K";

bool on_terminal() {
  return isatty(STDERR_FILENO) != 0;
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(on_terminal()) {}

Progress::~Progress() {
  if (terminal_ && !quiet_) std::cerr << clear_line << std::flush;
}

void Progress::begin(const std::string& what) {
  stop_if_interrupted();
  show(what, true);
}

void Progress::stage_begins(const std::string& name, int number, int of) {
  stop_if_interrupted();
  if (number == 1) march_began_ = std::chrono::steady_clock::now();
  stage_ = "stage " + std::to_string(number) + " of " + std::to_string(of) + ": " + name;
  number_ = number;
  of_ = of;
  show(stage_ + remaining(), true);
}

void Progress::iterated(const model::Iteration& iteration) {
  stop_if_interrupted();
  char residual[32];
  std::snprintf(residual, sizeof residual, "%.1e", iteration.residual);
  show(stage_ + ", step " + std::to_string(iteration.step) + ", iteration " +
           std::to_string(iteration.number) + ", residual " + residual + remaining(),
       false);
}

void Progress::stage_ends(const model::StageResult&) {
  stop_if_interrupted();
}

// Stages that are done tell how long the others take; the first has nothing to go by.
std::string Progress::remaining() const {
  if (!terminal_ || number_ < 2) return {};
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - march_began_;
  const double each = spent.count() / (number_ - 1);
  const int seconds = static_cast<int>(std::ceil(each * (of_ - number_ + 1)));
  return ", about " + std::to_string(seconds) + " s left";
}

void Progress::show(const std::string& text, bool every_time) {
  if (quiet_) return;
  if (terminal_)
    std::cerr << clear_line << text << std::flush;
  else if (every_time)
    std::cerr << text << '\n';
}

void show_log(bool quiet) {
  const bool terminal = on_terminal();
  core::log().set_sink([quiet, terminal](core::Level level, const std::string& text) {
    if (level == core::Level::debug || (quiet && level == core::Level::info)) return;
    if (terminal) std::cerr << clear_line;
    std::cerr << (level == core::Level::warning ? "warning: " : "") << text << '\n';
  });
}

}  // namespace ashlar::app
