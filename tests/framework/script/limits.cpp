#include <csignal>

#include "fixture.hpp"

namespace ashlar::script {
namespace {

TEST_F(Scripts, endless_loops_end) {
  options.seconds = 0.05;
  read("local n = 0\nwhile true do\n n = n + 1\nend");
  ASSERT_EQ(mistakes.list().size(), 1u);
  EXPECT_EQ(mistakes.list()[0].what, "the script did not end within 0.05 s");
  EXPECT_NEAR(mistakes.list()[0].place.line, 2.5, 1);
}

TEST_F(Scripts, the_limit_cannot_be_caught) {
  options.seconds = 0.05;
  read("while true do pcall(function() while true do end end) end");
  EXPECT_NE(said().find("did not end"), std::string::npos);
  read("setmetatable({}, { __index = function() while true do end end }).x()");
  EXPECT_NE(said().find("did not end"), std::string::npos);
  read("table.sort({ 1, 2, 3 }, function() while true do end end)");
  EXPECT_NE(said().find("did not end"), std::string::npos);
  read(
      "local x <close> = setmetatable({}, { __close = function() while true do end end }) while true do end");
  EXPECT_NE(said().find("did not end"), std::string::npos);
  read("error(setmetatable({}, { __tostring = function() while true do end end }))");
  EXPECT_FALSE(mistakes.empty());
}

TEST_F(Scripts, an_interrupt_ends_the_script) {
  const auto before = std::signal(SIGINT, [](int) { request_stop(); });
  std::raise(SIGINT);
  std::signal(SIGINT, before);
  read("while true do end");
  clear_stop();
  EXPECT_EQ(said(), "scene.lua:1: the script was interrupted\n");
}

TEST_F(Scripts, memory_has_a_cap) {
  options.memory = 8 << 20;
  read("local t = {}\nfor i = 1, 1e9 do t[i] = { i } end");
  EXPECT_NE(said().find("the script needs more than 8 MiB of memory"), std::string::npos);
  read("local s = 'x' while true do s = s .. s end");
  EXPECT_NE(said().find("the script needs more than 8 MiB of memory"), std::string::npos);
  read("local s = ('x'):rep(50000000)");
  EXPECT_NE(said().find("the script needs more than 8 MiB of memory"), std::string::npos);
  read("local s = ('x'):rep(1 << 62)");
  EXPECT_EQ(said(), "scene.lua:1: the text would be longer than 256 MiB\n");
  read("return Scene { a = #(''):rep(1 << 62) }");
  EXPECT_EQ(said(), "");
  read("table.move({}, 1, 1 << 62, 2)");
  EXPECT_EQ(said(), "scene.lua:1: too many items to move\n");
}

TEST_F(Scripts, recursion_has_a_floor) {
  read("local function f(n) return 1 + f(n + 1) end\nreturn f(1)");
  EXPECT_NE(said().find("scene.lua:1: stack overflow"), std::string::npos);
  read("local function f(s) return s:gsub('.', f) end\nreturn f('x')");
  EXPECT_NE(said().find("scene.lua:1: "), std::string::npos);
  read("return " + std::string(500, '(') + "1" + std::string(500, ')'));
  EXPECT_EQ(mistakes.list().size(), 1u);
  read("return " + std::string(120, '{') + std::string(120, '}'));
  EXPECT_EQ(mistakes.list().size(), 1u);
  const ScriptResult deep = read("return Scene { a = " + std::string(30, '{') + std::string(30, '}') + " }");
  EXPECT_EQ(said(), "");
}

TEST_F(Scripts, mistakes_without_end_end) {
  read("for i = 1, 1e6 do local x = _ENV['name' .. i] end");
  EXPECT_LT(mistakes.list().size(), 300u);
}

TEST_F(Scripts, functions_are_called_after_reading) {
  ScriptResult result = read(
      "local u = units\n"
      "local width = 2*u.m\n"
      "return Scene {\n"
      "  f = function(x, y) return x + 2*y end,\n"
      "  q = function(x) return x*u.m + width, 1 end,\n"
      "  bad = function(x)\n"
      "    return x.y\n"
      "  end,\n"
      "  text = function() return 'a' end,\n"
      "  none = function() end,\n"
      "  nan = function(x) return 0/x end,\n"
      "  global = function() return nonsense end,\n"
      "  endless = function() while true do end end,\n"
      "  sine = math.sin,\n"
      "}\n");
  EXPECT_EQ(said(), "");
  auto call = [&](const std::string& name, std::vector<double> arguments) {
    return at(result.scene, name).function()->call(arguments);
  };
  auto message = [&](const std::string& name, std::vector<double> arguments) -> std::string {
    try {
      call(name, arguments);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(call("f", {1, 2}), std::vector<double>{5});
  EXPECT_EQ(call("q", {3}), (std::vector<double>{5, 1}));
  EXPECT_EQ(call("sine", {0}), std::vector<double>{0});
  EXPECT_EQ(
      message("bad", {1.5}),
      "scene.lua:7: bad: the function of scene.lua:6, called with (1.5), fails: attempt to index a number "
      "value (local 'x')");
  EXPECT_EQ(message("text", {}),
            "scene.lua:9: text: the function, called with (), must return numbers, but returns a string");
  EXPECT_EQ(message("none", {1, 2}), "scene.lua:10: none: the function, called with (1, 2), returns nothing");
  EXPECT_NE(message("nan", {0}).find("scene.lua:11: nan: the function, called with (0), returns"),
            std::string::npos);
  EXPECT_NE(message("global", {}).find("'nonsense' is not defined"), std::string::npos);
  EXPECT_EQ(call("f", {1, 2}), std::vector<double>{5});
}

TEST_F(Scripts, functions_outlive_their_reading_and_keep_the_limits) {
  options.seconds = 0.05;
  std::shared_ptr<const core::Function> function;
  {
    const ScriptResult result = read(
        "local n = 0\nreturn Scene { f = function(x)\n if x > 0 then while true do end end return n end }");
    function = at(result.scene, "f").function();
  }
  EXPECT_EQ(function->call(std::vector<double>{-1}), std::vector<double>{0});
  EXPECT_THROW(function->call(std::vector<double>{1}), core::InputError);
  EXPECT_EQ(function->call(std::vector<double>{-1}), std::vector<double>{0});
}

}  // namespace
}  // namespace ashlar::script
