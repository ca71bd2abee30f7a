#pragma once
// What a study has done so far: one file in its folder, written whole after every run.

#include <filesystem>
#include <map>
#include <string>

#include "study/outcome.hpp"

namespace ashlar::study {

class State {
 public:
  /// Takes the folder for itself as long as it lives, and reads what an earlier start left there; a file that
  /// cannot be read counts as none. Throws InputError if another study works there, or it cannot be written.
  explicit State(std::filesystem::path folder);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// The record of a case; emptied if its inputs have changed.
  CaseRecord& record(const std::string& name, const std::string& inputs);
  void forget(const std::string& name) { records_.erase(name); }
  void save() const;

 private:
  std::filesystem::path folder_;
  std::map<std::string, CaseRecord> records_;
  int lock_ = -1;
};

}  // namespace ashlar::study
