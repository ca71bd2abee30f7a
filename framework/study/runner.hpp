#pragma once
// Runs the cases of a study, each as a process of this program, side by side as far as memory allows.

#include <functional>
#include <string>
#include <vector>

#include "study/process.hpp"
#include "study/state.hpp"

namespace ashlar::study {

struct RunnerOptions {
  std::string program;             ///< this program's file
  std::vector<std::string> words;  ///< more words for every run, such as --trust
  int jobs = 1;                    ///< processes side by side
  std::function<void(const std::string&)> say;
  std::function<bool()> stopped;  ///< true: end the runs and return
};

/// A case with everything the runner needs to know of it.
struct Job {
  std::string name;                   ///< of its folder
  std::string label;                  ///< for people
  std::string inputs;                 ///< fingerprint
  std::vector<std::string> settings;  ///< "cells=500"
};

/// True: this record needs no further run.
bool is_finished(const CaseRecord& record, int repeats);

/// Runs what the state does not hold yet; it is saved after every run. A run that the memory did not suffice
/// for while others ran beside it is done again alone. False if it was stopped.
bool run_jobs(const Study& study, const std::vector<Job>& jobs, const RunnerOptions& options, State& state);

}  // namespace ashlar::study
