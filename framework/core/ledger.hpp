#pragma once
// The cost ledger: time, calls, bytes and unknowns by phase (mesh, assemble, …) and effect.

#include <cstdint>
#include <string>
#include <vector>

namespace ashlar::core {

struct Cost {
  /// read, check, mesh, prepare, assemble, order, factor, solve, iterate, recover, write (0 in
  /// results.h5, which is written meanwhile)
  std::string phase;
  std::string effect;  ///< elasticity, contact, gravity …; "" for none
  double wall = 0;     ///< s
  double cpu = 0;      ///< s, of the whole process
  std::int64_t calls = 0;
  std::int64_t bytes = 0;
  std::int64_t unknowns = 0;
};

class Ledger {
 public:
  /// Adds the time until it goes out of scope. Time of an inner scope is not counted again in the outer one.
  class Scope {
   public:
    Scope(Ledger& ledger, std::size_t row);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Ledger& ledger_;
    std::size_t row_;
    double wall_, cpu_;
    Scope* outer_;
    double inner_wall_ = 0, inner_cpu_ = 0;
  };
  [[nodiscard]] Scope time(const std::string& phase, const std::string& effect = {});
  void add_bytes(const std::string& phase, const std::string& effect, std::int64_t bytes);
  void add_unknowns(const std::string& phase, const std::string& effect, std::int64_t unknowns);
  const std::vector<Cost>& rows() const { return rows_; }
  void clear() { rows_.clear(); }

 private:
  std::size_t row(const std::string& phase, const std::string& effect);
  std::vector<Cost> rows_;
  Scope* innermost_ = nullptr;
};

/// The program's ledger. Main thread only.
Ledger& ledger();

/// Peak resident memory of this process in bytes.
std::int64_t peak_memory();

}  // namespace ashlar::core
