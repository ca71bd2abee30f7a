// Laws written in a scenario: what they give, and how their mistakes are told.

#include <gtest/gtest.h>

#include "program.hpp"

namespace ashlar::test {
namespace {

/// A law that softens once |yy| exceeds p.limit; `body` is its function's, lines 2 to 5.
std::string script(const std::string& body, const std::string& more) {
  return "local function law(strain, state, p)\n" + body +
         "\nend\nreturn Drive { title = \"A law\", plane = \"strain\", steps = 4, path = { { yy = -3e-4 } "
         "},\n"
         "  material = material.lua { stress = law, parameters = { E = 1e10, limit = 1e-4 }" +
         more + " } }\n";
}

const std::string softening =
    "  local worst = math.max(state[1], math.abs(strain.yy))\n"
    "  local left = worst > p.limit and p.limit/worst or 1\n"
    "  return { xx = left*p.E*strain.xx, yy = left*p.E*strain.yy, xy = left*p.E/2*strain.xy,\n"
    "           zz = left*p.E*strain.zz }, { worst }";
const std::string remembers = ", variables = 1, symmetric = false";

void expect_refused(const std::string& text, const std::string& message) {
  const ScratchFolder folder;
  write(folder / "law.lua", text);
  const Ended ended = call("drive law.lua", folder / "");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_NE(ended.err.find(message), std::string::npos) << message << "\nwas expected, got\n" << ended.err;
}

std::string with(const std::string& wrong, const std::string& right) {
  return std::string(softening).replace(softening.find(right), right.size(), wrong);
}

TEST(lua_law, a_law_with_memory_softens) {
  const ScratchFolder folder;
  write(folder / "law.lua", script(softening, remembers));
  const Ended ended = call("drive law.lua", folder / "");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string csv = read(folder / "law_drive/drive.csv");
  // At yy = -3e-4 the stress is what the limit left, and the state is the greatest strain.
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  EXPECT_TRUE(last.starts_with("1,4,0,-3e-04,")) << last;
  EXPECT_NE(last.find("-1e+06"), std::string::npos) << last;
  EXPECT_TRUE(last.ends_with(",3e-04\n")) << last;
}

TEST(lua_law, mistakes_name_the_line_of_the_function) {
  expect_refused(script(with("p.limt and", "p.limit and"), remembers),
                 "law.lua:3: material.stress: the function of law.lua:1, called with (0, 0, 0, 0), fails");
  expect_refused(
      script(with("z = left", "zz = left"), remembers),
      "law.lua:1: material.stress: the function, called with (0, 0, 0, 0), must return a finite number at "
      ".zz, but returns a nil");
  expect_refused(script(with("{ 0/0 }", "{ worst }"), remembers), "must return a finite number at [1]");
  expect_refused(script(with("", ", { worst }"), remembers), "must return tables, but returns nothing");
  expect_refused(script("return 3", ""), "must return tables, but returns a number");
  expect_refused(script(softening, ", variables = 1"),
                 "gives an unsymmetric tangent, but symmetry is promised");
  expect_refused(script("return { xx = 0, yy = 0, xy = 0, zz = 0 }", ""), "has no stiffness at no strain");
  expect_refused(script(softening, ", variables = -1"), "variables: must be at least 0");
}

}  // namespace
}  // namespace ashlar::test
