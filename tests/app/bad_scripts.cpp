// Every file in tests/bad_scripts, and every study in tests/bad_studies, says in its first lines what the
// program must answer:
//   -- expect 12: must be above 0 Pa     a message that starts at line 12 and contains this
//   -- expect: did you mean 'rock'?      anywhere
//   -- options: --set level=3
//   -- found by check                   `ashlar check` must say all of it too

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "program.hpp"

namespace ashlar::test {
namespace {

std::vector<std::string> names_of_scripts(const std::string& folder = "tests/bad_scripts") {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_folder / folder))
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

struct Expected {
  std::vector<std::pair<int, std::string>> messages;
  std::string options;
  bool by_check = false;
};

Expected expected_of(const fs::path& script) {
  Expected expected;
  std::istringstream lines(read(script));
  const std::string expect = "-- expect", options = "-- options: ";
  for (std::string line; std::getline(lines, line) && line.starts_with("-- ");) {
    expected.by_check = expected.by_check || line == "-- found by check";
    if (line.starts_with(options)) expected.options = line.substr(options.size());
    if (!line.starts_with(expect)) continue;
    const auto colon = line.find(':');
    const std::string number = line.substr(expect.size(), colon - expect.size());
    expected.messages.emplace_back(number.empty() ? 0 : std::stoi(number), line.substr(colon + 2));
  }
  return expected;
}

bool says(const std::string& text, const std::string& file, const std::pair<int, std::string>& message) {
  if (message.first == 0) return text.find(message.second) != std::string::npos;
  const std::string place = file + ":" + std::to_string(message.first) + ":";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(place) && line.find(message.second) != std::string::npos) return true;
  return false;
}

void expect_messages(const Ended& ended, const std::string& file, const Expected& expected) {
  EXPECT_EQ(ended.code, 2) << ended.err;
  for (const auto& message : expected.messages)
    EXPECT_TRUE(says(ended.err, file, message))
        << "line " << message.first << ": " << message.second << "\nwas expected, got\n"
        << ended.err;
  EXPECT_EQ(ended.out, "");
}

class BadScript : public testing::TestWithParam<std::string> {};

TEST_P(BadScript, is_answered_and_writes_nothing) {
  const std::string file = GetParam() + ".lua";
  const fs::path folder = source_folder / "tests/bad_scripts";
  const Expected expected = expected_of(folder / file);
  ASSERT_FALSE(expected.messages.empty()) << "the script does not say what to expect";
  const ScratchFolder scratch;
  const Ended ended =
      call("run " + file + " --quiet --out " + quoted(scratch / "results") + " " + expected.options, folder);
  expect_messages(ended, file, expected);
  if (expected.by_check)
    expect_messages(call("check " + file + " " + expected.options, folder), file, expected);
  EXPECT_FALSE(fs::exists(scratch / "results"));
}

INSTANTIATE_TEST_SUITE_P(all, BadScript, testing::ValuesIn(names_of_scripts()),
                         [](const auto& info) { return "script_" + info.param; });

class BadStudy : public testing::TestWithParam<std::string> {};

TEST_P(BadStudy, is_answered_and_runs_nothing) {
  const std::string file = GetParam() + ".lua";
  const fs::path folder = source_folder / "tests/bad_studies";
  const Expected expected = expected_of(folder / file);
  ASSERT_FALSE(expected.messages.empty()) << "the study does not say what to expect";
  const ScratchFolder scratch;
  const Ended ended =
      call("study " + file + " --out " + quoted(scratch / "results") + " " + expected.options, folder);
  expect_messages(ended, file, expected);
  EXPECT_FALSE(fs::exists(scratch / "results"));
}

INSTANTIATE_TEST_SUITE_P(all, BadStudy, testing::ValuesIn(names_of_scripts("tests/bad_studies")),
                         [](const auto& info) { return "study_" + info.param; });

TEST(bad_scripts, there_are_enough_of_them) {
  EXPECT_GE(names_of_scripts().size(), 30u);
}

}  // namespace
}  // namespace ashlar::test
