#pragma once
// What a run says while it works: one line that renews itself on a terminal, plain lines elsewhere.

#include <chrono>
#include <string>

#include "solve/march.hpp"

namespace ashlar::app {

class Progress : public solve::Observer {
 public:
  explicit Progress(bool quiet);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A step that is no stage: "meshing", "writing". Throws Interrupted after Ctrl-C, as all of these do.
  void begin(const std::string& what);
  void stage_begins(const std::string& name, int number, int of) override;
  void iterated(const model::Iteration& iteration) override;
  void stage_ends(const model::StageResult& result) override;

 private:
  void show(const std::string& text, bool every_time);
  std::string remaining() const;

  bool quiet_, terminal_;
  std::string stage_;
  int number_ = 0, of_ = 0;
  std::chrono::steady_clock::time_point march_began_;
};

/// Sends the log to the terminal: warnings always, information unless quiet.
void show_log(bool quiet);

}  // namespace ashlar::app
