#pragma once
// Everything that moves, in two copies: committed and trial. One type for step cuts, stage branches and
// results.

#include <span>
#include <string>
#include <vector>

namespace ashlar::fields {

class State {
 public:
  /// A handle of one named array.
  using Id = int;

  /// Adds an array of `size` zeros, or finds the one of that name (its size must agree).
  Id add(const std::string& name, std::size_t size);
  /// -1 if there is none.
  Id find(const std::string& name) const;
  std::span<const double> committed(Id id) const { return arrays_[id].committed; }
  std::span<const double> trial(Id id) const { return arrays_[id].trial; }
  std::span<double> trial(Id id) { return arrays_[id].trial; }

  /// Trial becomes committed. Called in one place: the stage runner.
  void commit();
  /// Committed becomes trial again.
  void revert();
  std::size_t bytes() const;
  std::vector<std::string> names() const;

 private:
  struct Array {
    std::string name;
    std::vector<double> committed, trial;
  };
  std::vector<Array> arrays_;
};

}  // namespace ashlar::fields
