// Every example gives the numbers of its expected.lua:
//   return { { set = { distortion = 1 },
//              numbers = { { at = "stages.moment.probes.tip.uy", value = 0.1, tolerance = 1e-9, why = "…" } }
//              } }
// `at` is a path into the program's JSON; stages are found by name. `tolerance` is absolute.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output/files.hpp"
#include "program.hpp"
#include "script/script.hpp"

namespace ashlar::test {
namespace {

using nlohmann::json;

std::vector<std::string> names_of_examples() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_folder / "examples"))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The value at a path such as "stages.reservoir.probes.crest.ux"; null if there is none.
json find(const json& root, const std::string& path) {
  json here = root;
  std::istringstream words(path);
  for (std::string word; std::getline(words, word, '.');) {
    json next;
    if (here.is_array())
      for (const json& item : here)
        if (item.value("name", "") == word) next = item;
    if (here.is_object() && here.contains(word)) next = here.at(word);
    here = next;
  }
  return here;
}

std::string settings_of(const core::Table& run) {
  std::string text;
  const core::Value* set = run.find("set");
  if (!set || !set->table()) return text;
  for (const auto& [key, value] : set->table()->entries)
    text += " --set " + key + "=" +
            (value.text()      ? "'\"" + *value.text() + "\"'"
             : value.boolean() ? std::string(*value.boolean() ? "true" : "false")
                               : output::shortest(value.quantity()->value));
  return text;
}

void check_number(const json& results, const core::Table& expected) {
  const std::string path = *expected.find("at")->text();
  ASSERT_TRUE(expected.find("why") && expected.find("why")->text())
      << path << ": no tolerance without a reason";
  const json found = find(results, path);
  ASSERT_TRUE(found.is_number()) << path << " is not in the results";
  EXPECT_NEAR(found.get<double>(), expected.find("value")->quantity()->value,
              expected.find("tolerance")->quantity()->value)
      << path << ": " << *expected.find("why")->text();
}

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, gives_its_expected_numbers) {
  const fs::path folder = source_folder / "examples" / GetParam();
  EXPECT_TRUE(fs::exists(folder / "README.md"));
  EXPECT_TRUE(fs::exists(folder / "picture.png"));
  const core::Value expected = script::read_data(folder / "expected.lua");
  ASSERT_TRUE(expected.table() && !expected.table()->items.empty());
  for (const core::Value& run : expected.table()->items) {
    const ScratchFolder scratch;
    const Ended ended = call("run " + quoted(folder) + " --quiet --out " + quoted(scratch / "results") +
                             " --json " + quoted(scratch / "results.json") + settings_of(*run.table()));
    ASSERT_EQ(ended.code, 0) << ended.err;
    const json results = json::parse(read(scratch / "results.json"));
    for (const core::Value& number : run.table()->find("numbers")->table()->items)
      check_number(results, *number.table());
    // Round-off, unless the run says why it may be more.
    const core::Value* balance = run.table()->find("balance");
    const double bound = balance ? balance->quantity()->value : 1e-10;
    for (const json& stage : results.at("stages"))
      EXPECT_LT(stage.at("balance").at("relative_error").get<double>(), bound)
          << "loads and reactions of stage " << stage.at("name");
  }
}

INSTANTIATE_TEST_SUITE_P(all, Example, testing::ValuesIn(names_of_examples()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace ashlar::test
