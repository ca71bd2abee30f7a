#pragma once
// What is known of a case after its runs: the numbers measured, what they cost, or why it failed.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace ashlar::study {

/// How a process ended, as the state file keeps it.
struct RunRecord {
  int code = 0;
  std::string reason;  ///< of a failure: first line that the run said
  double wall = 0, cpu = 0;
  std::int64_t memory = 0;
};

struct CaseRecord {
  std::string inputs;  ///< changes when anything that the case depends on does
  std::vector<RunRecord> runs;
};

/// Where the time of a run goes; `other` is starting, reading, checking and the program's end.
enum class Part { mesh, assembly, factorisation, solve, output, other };
constexpr std::size_t part_count = 6;
constexpr std::array<const char*, part_count> part_names = {"meshing", "assembly", "factorisation",
                                                            "solve",   "output",   "other"};

struct Run {
  RunRecord record;
  std::array<double, part_count> wall{}, cpu{};
  std::map<std::string, double> effects;  ///< wall time by effect
};

struct Outcome {
  std::string name;  ///< folder of the case
  bool ok = false;
  std::string reason;     ///< why it failed, or was not run
  std::vector<Run> runs;  ///< those that converged
  double cells = 0, unknowns = 0;
  double h = 0;                               ///< sqrt(area / cells) [m]
  std::vector<std::optional<double>> values;  ///< by measure
  std::vector<std::string> missing;           ///< measures that its results lack, in words

  const Run& best() const;  ///< by wall time
  double worst_wall() const;
  double best_cpu() const;
  double memory() const;  ///< peak of all runs
};

/// Where run `number` (from 1) of a case keeps its results for machines, and what it said.
std::filesystem::path results_file(const std::filesystem::path& folder, const std::string& name,
                                   std::size_t number);
std::filesystem::path log_file(const std::filesystem::path& folder, const std::string& name,
                               std::size_t number);

Outcome read_outcome(const Study& study, const std::filesystem::path& folder, const std::string& name,
                     const CaseRecord& record);

}  // namespace ashlar::study
