#include "study/runner.hpp"

#include <algorithm>
#include <csignal>
#include <deque>
#include <fstream>
#include <system_error>

namespace ashlar::study {

namespace {

namespace fs = std::filesystem;

constexpr double share = 0.9;       // of the memory that is there; the rest is the machine's own
constexpr double growth = 1.5;      // a case may need more than those that are done
constexpr double look_again = 0.5;  // s, until memory is looked at again

/// The first line that is neither empty nor a warning.
std::string first_words(const fs::path& log) {
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && !line.starts_with("warning: ") && !line.starts_with("This is our fault"))
      return line.substr(0, 400);
    else if (line.starts_with("This is our fault"))
      return line;
  return {};
}

std::string reason_of(const Ended& ended, const fs::path& log) {
  if (ended.code == 0) return {};
  std::string said = first_words(log);
  if (!said.empty()) return said;
  return ended.code > 128 ? "ended by signal " + std::to_string(ended.code - 128) : "it said nothing";
}

class Runner {
 public:
  Runner(const Study& study, const std::vector<Job>& jobs, const RunnerOptions& options, State& state)
      : study_(study), jobs_(jobs), options_(options), state_(state) {
    for (std::size_t j = 0; j < jobs.size(); ++j) {
      CaseRecord& record = record_of(j);
      drop_lost_runs(j, record);
      for (const RunRecord& run : record.runs) peak_ = std::max(peak_, run.memory);
      const auto have = static_cast<int>(record.runs.size());
      total_ += is_finished(record, study.repeats) ? 0 : study.repeats - have;
    }
    // All cases once, then all again: an early stop leaves something of everything.
    for (int round = 0; round < study.repeats; ++round)
      for (std::size_t j = 0; j < jobs.size(); ++j)
        if (round >= static_cast<int>(record_of(j).runs.size()) && !is_finished(record_of(j), study.repeats))
          waiting_.push_back(j);
  }

  bool run() {
    while (!waiting_.empty() || processes_.count() > 0) {
      if (options_.stopped()) return processes_.stop(), false;
      while (may_start()) start(take());
      for (const Ended& ended : processes_.wait(look_again)) finish(ended);
    }
    return !options_.stopped();
  }

 private:
  CaseRecord& record_of(std::size_t job) { return state_.record(jobs_[job].name, jobs_[job].inputs); }

  void drop_lost_runs(std::size_t job, CaseRecord& record) {
    for (std::size_t i = 0; i < record.runs.size(); ++i)
      if (record.runs[i].code == 0 && !fs::exists(results_file(state_.folder(), jobs_[job].name, i + 1)))
        record.runs.resize(i);
  }

  bool may_start() const {
    if (waiting_.empty()) return false;
    if (processes_.count() == 0) return true;
    const std::size_t next = waiting_.front();
    if (alone_ || std::ranges::count(alone_jobs_, next) > 0 || beside_.contains(next)) return false;
    if (static_cast<int>(processes_.count()) >= options_.jobs) return false;
    // Those that run may still grow to what the largest took.
    const double need = growth * static_cast<double>(peak_);
    const double owed = std::max(
        0.0, need * static_cast<double>(processes_.count()) - static_cast<double>(processes_.resident()));
    return need + owed <= share * static_cast<double>(available_memory());
  }

  std::size_t take() {
    const std::size_t job = waiting_.front();
    waiting_.pop_front();
    return job;
  }

  void start(std::size_t job) {
    const Job& one = jobs_[job];
    const std::size_t number = record_of(job).runs.size() + 1;
    const fs::path results = results_file(state_.folder(), one.name, number);
    fs::create_directories(results.parent_path());
    fs::remove(results);
    std::vector<std::string> words = {options_.program, "run", study_.scene.string()};
    for (const std::string& setting : one.settings) words.insert(words.end(), {"--set", setting});
    words.insert(words.end(),
                 {"--quiet", "--threads", std::to_string(study_.threads), "--json", results.string()});
    if (study_.files)
      words.insert(words.end(), {"--out", (results.parent_path() / "results").string()});
    else
      words.emplace_back("--no-files");
    words.insert(words.end(), options_.words.begin(), options_.words.end());
    alone_ = std::ranges::count(alone_jobs_, job) > 0;
    beside_[job] = processes_.count() > 0;
    for (auto& [other, crowded] : beside_) crowded = crowded || processes_.count() > 0;
    processes_.start(job, words, "/dev/null", log_file(state_.folder(), one.name, number));
    options_.say(std::to_string(++started_) + " of " + std::to_string(total_) + ": " + one.label);
  }

  void finish(const Ended& ended) {
    const Job& job = jobs_[ended.id];
    CaseRecord& record = record_of(ended.id);
    const fs::path log = log_file(state_.folder(), job.name, record.runs.size() + 1);
    const std::string reason = reason_of(ended, log);
    const bool crowded = beside_[ended.id];
    beside_.erase(ended.id);
    alone_ = false;
    const bool memory = ended.code == 128 + SIGKILL || reason.find("not enough memory") != std::string::npos;
    if (memory && crowded && !options_.stopped()) {
      options_.say("memory did not suffice for " + job.label + ": it is run again alone");
      --started_;
      alone_jobs_.push_back(ended.id);
      waiting_.push_front(ended.id);
      return;
    }
    // Ended by our own stop: neither a result nor a failure.
    if (options_.stopped() && ended.code != 0) return;
    record.runs.push_back({ended.code, reason, ended.wall, ended.cpu, ended.memory});
    peak_ = std::max(peak_, ended.memory);
    if (ended.code != 0) {
      options_.say(job.label + " failed: " + reason);
      total_ -= static_cast<int>(std::erase(waiting_, ended.id));
    }
    state_.save();
  }

  const Study& study_;
  const std::vector<Job>& jobs_;
  const RunnerOptions& options_;
  State& state_;
  Processes processes_;
  std::deque<std::size_t> waiting_;
  std::vector<std::size_t> alone_jobs_;  // those that need the machine for themselves
  std::map<std::size_t, bool> beside_;   // running: did another one run meanwhile?
  std::int64_t peak_ = 0;
  bool alone_ = false;
  int total_ = 0, started_ = 0;
};

}  // namespace

bool is_finished(const CaseRecord& record, int repeats) {
  const bool failed = !record.runs.empty() && record.runs.back().code != 0;
  return failed || static_cast<int>(record.runs.size()) >= repeats;
}

bool run_jobs(const Study& study, const std::vector<Job>& jobs, const RunnerOptions& options, State& state) {
  const bool finished = Runner(study, jobs, options, state).run();
  state.save();
  return finished;
}

}  // namespace ashlar::study
