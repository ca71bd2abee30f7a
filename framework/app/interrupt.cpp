#include "app/interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "app/verbs.hpp"
#include "script/script.hpp"

namespace ashlar::app {

namespace {

volatile std::sig_atomic_t pressed = 0;

extern "C" void on_interrupt(int) {
  if (pressed) _exit(interrupted);
  pressed = 1;
  script::request_stop();
}

}  // namespace

void watch_for_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A limit on file sizes shall be an error of the write, which is reported, not a sudden death.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool was_interrupted() {
  return pressed != 0;
}

void stop_if_interrupted() {
  if (pressed) throw Interrupted();
}

}  // namespace ashlar::app
