#pragma once
// What the tests of `ashlar drive` share.

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "program.hpp"

namespace ashlar::test {

inline std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream text(line);
  for (std::string part; std::getline(text, part, ',');) parts.push_back(part);
  return parts;
}

inline void expect_refused(const std::string& text, const std::vector<std::string>& messages) {
  const ScratchFolder folder;
  write(folder / "law.lua", text);
  const Ended ended = call("drive law.lua", folder / "");
  EXPECT_EQ(ended.code, 2) << ended.err;
  for (const std::string& message : messages)
    EXPECT_NE(ended.err.find(message), std::string::npos) << message << "\nwas expected, got\n" << ended.err;
  EXPECT_FALSE(fs::exists(folder / "law_drive"));
}

}  // namespace ashlar::test
