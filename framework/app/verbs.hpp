#pragma once
// What the program can do, one file each. All return the exit code.

#include "app/command_line.hpp"

namespace ashlar::app {

constexpr int done = 0, our_fault = 1, input_mistake = 2, not_converged = 3, interrupted = 130;

int run(const CommandLine& line);
int check(const CommandLine& line);
int plan(const CommandLine& line);
int study(const CommandLine& line);
int drive(const CommandLine& line);
int list(const CommandLine& line);
int describe(const CommandLine& line);

}  // namespace ashlar::app
