#include "core/ledger.hpp"

#include <sys/resource.h>

#include <chrono>

namespace ashlar::core {

namespace {

double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_now() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(use.ru_utime) + seconds(use.ru_stime);
}

}  // namespace

Ledger::Scope::Scope(Ledger& ledger, std::size_t row)
    : ledger_(ledger), row_(row), wall_(wall_now()), cpu_(cpu_now()), outer_(ledger.innermost_) {
  ledger_.innermost_ = this;
}

Ledger::Scope::~Scope() {
  const double wall = wall_now() - wall_;
  const double cpu = cpu_now() - cpu_;
  Cost& cost = ledger_.rows_[row_];
  cost.wall += wall - inner_wall_;
  cost.cpu += cpu - inner_cpu_;
  ++cost.calls;
  if (outer_) {
    outer_->inner_wall_ += wall;
    outer_->inner_cpu_ += cpu;
  }
  ledger_.innermost_ = outer_;
}

Ledger::Scope Ledger::time(const std::string& phase, const std::string& effect) {
  return Scope(*this, row(phase, effect));
}

void Ledger::add_bytes(const std::string& phase, const std::string& effect, std::int64_t bytes) {
  rows_[row(phase, effect)].bytes += bytes;
}

void Ledger::add_unknowns(const std::string& phase, const std::string& effect, std::int64_t unknowns) {
  rows_[row(phase, effect)].unknowns += unknowns;
}

std::size_t Ledger::row(const std::string& phase, const std::string& effect) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].phase == phase && rows_[i].effect == effect) return i;
  rows_.push_back(Cost{phase, effect, 0, 0, 0, 0, 0});
  return rows_.size() - 1;
}

Ledger& ledger() {
  static Ledger instance;
  return instance;
}

std::int64_t peak_memory() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<std::int64_t>(use.ru_maxrss) * 1024;
}

}  // namespace ashlar::core
