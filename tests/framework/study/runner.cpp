// The runner with a stand-in for the program: a shell script that answers as told.

#include "study/runner.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace ashlar::study {
namespace {

namespace fs = std::filesystem;

// Called as: run SCENE --set KEY=VALUE … --json FILE …
const char* const stand_in = R"(#!/bin/sh
case "$4" in
  size=big)
    if [ ! -e "$(dirname "$0")/tried" ]; then
      touch "$(dirname "$0")/tried"; sleep 0.3
      echo "warning: something" >&2; echo "The machine has not enough memory for this." >&2; exit 1
    fi ;;
  size=bad) echo "scene.lua:3: it is wrong" >&2; exit 2 ;;
  size=slow) sleep 30 ;;
esac
while [ "$1" != --json ]; do shift; done
echo '{}' > "$2"
)";

class Runs : public ::testing::Test {
 protected:
  Runs() : folder(fs::temp_directory_path() / ("ashlar_runs_" + std::to_string(getpid()))) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::ofstream(folder / "program") << stand_in;
    fs::permissions(folder / "program", fs::perms::owner_all);
    options.program = (folder / "program").string();
    options.say = [this](const std::string& text) { said += text + "\n"; };
    options.stopped = [this] { return stop && said.find(*stop) != std::string::npos; };
    study.scene = "scene.lua";
  }
  ~Runs() override { fs::remove_all(folder); }

  static Job job(const std::string& size) { return {size, "size = " + size, "same", {"size=" + size}}; }

  fs::path folder;
  Study study;
  RunnerOptions options;
  std::optional<std::string> stop;
  std::string said;
};

TEST_F(Runs, keep_what_ended_and_why) {
  State state(folder / "out");
  study.repeats = 2;
  EXPECT_TRUE(run_jobs(study, {job("small"), job("bad")}, options, state));
  const CaseRecord& good = state.record("small", "same");
  ASSERT_EQ(good.runs.size(), 2u);
  EXPECT_EQ(good.runs[0].code, 0);
  EXPECT_GT(good.runs[0].wall, 0);
  EXPECT_GT(good.runs[0].memory, 100'000);
  const CaseRecord& bad = state.record("bad", "same");
  ASSERT_EQ(bad.runs.size(), 1u);
  EXPECT_EQ(bad.runs[0].code, 2);
  EXPECT_EQ(bad.runs[0].reason, "scene.lua:3: it is wrong");
}

TEST_F(Runs, that_lack_memory_beside_others_are_done_again_alone) {
  State state(folder / "out");
  options.jobs = 2;
  study.repeats = 1;
  EXPECT_TRUE(run_jobs(study, {job("big"), job("small")}, options, state));
  EXPECT_NE(said.find("run again alone"), std::string::npos) << said;
  ASSERT_EQ(state.record("big", "same").runs.size(), 1u);
  EXPECT_EQ(state.record("big", "same").runs[0].code, 0);
}

TEST_F(Runs, that_lack_memory_by_themselves_have_failed) {
  State state(folder / "out");
  EXPECT_TRUE(run_jobs(study, {job("big"), job("small")}, options, state));
  const CaseRecord& big = state.record("big", "same");
  ASSERT_EQ(big.runs.size(), 1u);
  EXPECT_EQ(big.runs[0].reason, "The machine has not enough memory for this.");
}

TEST_F(Runs, end_when_they_are_stopped_and_go_on_later) {
  stop = "2 of 2";
  {
    State state(folder / "out");
    EXPECT_FALSE(run_jobs(study, {job("small"), job("slow")}, options, state));
  }
  State state(folder / "out");
  EXPECT_EQ(state.record("small", "same").runs.size(), 1u);
  EXPECT_TRUE(state.record("slow", "same").runs.empty()) << "a run that was stopped is no failure";
  EXPECT_TRUE(state.record("small", "changed").runs.empty()) << "other inputs, other runs";
}

TEST_F(Runs, have_the_folder_for_themselves) {
  const State state(folder / "out");
  EXPECT_THROW(State(folder / "out"), core::InputError);
}

}  // namespace
}  // namespace ashlar::study
