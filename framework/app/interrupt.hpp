#pragma once
// Ctrl-C: the first one stops the script or the march at its next step, the second one at once.

#include <stdexcept>

namespace ashlar::app {

/// Thrown where the work can stop cleanly.
class Interrupted : public std::exception {};

void watch_for_interrupts();
bool was_interrupted();
/// Throws Interrupted if Ctrl-C was pressed.
void stop_if_interrupted();

}  // namespace ashlar::app
