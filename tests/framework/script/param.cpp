#include "fixture.hpp"

namespace ashlar::script {
namespace {

const std::string dam = R"(local u = units
local level = param { "level", default = 15*u.m, doc = "reservoir level", min = 0, max = 20*u.m }
local cells = param { "cells", default = 500 }
local kind = param { "kind", default = "voronoi", choices = { "voronoi", "gmsh" } }
local drained = param { "drained", default = false }
return Scene { level = level, cells = cells, kind = kind, drained = drained }
)";

TEST_F(Scripts, parameters_have_defaults) {
  const ScriptResult result = read(dam);
  EXPECT_EQ(said(), "");
  ASSERT_EQ(result.params.size(), 4u);
  EXPECT_EQ(result.params[0].name, "level");
  EXPECT_EQ(result.params[0].doc, "reservoir level");
  EXPECT_EQ(result.params[0].place.line, 2);
  EXPECT_EQ(result.params[0].value.quantity()->value, 15);
  EXPECT_FALSE(result.params[0].said);
  EXPECT_EQ(number(result.scene, "level"), 15);
}

TEST_F(Scripts, parameters_are_set_from_outside) {
  for (const std::string level : {"12", "12*u.m", "12*m", "12000*mm", "10*m + 2", "12.0", "max(1, 12)*m"}) {
    options.set = {{"level", level}, {"cells", "2e3"}, {"kind", "gmsh"}, {"drained", "true"}};
    const ScriptResult result = read(dam);
    EXPECT_EQ(said(), "") << level;
    EXPECT_EQ(number(result.scene, "level"), 12) << level;
    EXPECT_EQ(at(result.scene, "level").quantity()->dimension, core::parse_dimension("m"));
    EXPECT_EQ(number(result.scene, "cells"), 2000);
    EXPECT_EQ(*at(result.scene, "kind").text(), "gmsh");
    EXPECT_TRUE(*at(result.scene, "drained").boolean());
    EXPECT_TRUE(result.params[0].said);
    EXPECT_EQ(result.params[0].fallback.quantity()->value, 15);
  }
  options.set = {{"kind", "\"gmsh\""}};
  EXPECT_EQ(*at(read(dam).scene, "kind").text(), "gmsh");
}

TEST_F(Scripts, wrong_settings_are_mistakes_that_say_what_is_valid) {
  auto with = [&](const std::string& name, const std::string& text) {
    options.set = {{name, text}};
    read(dam);
    return said();
  };
  EXPECT_EQ(with("levle", "3"), "--set levle: the script has no parameter 'levle'\n");
  EXPECT_EQ(advice(), "did you mean 'level'? valid: level, cells, kind, drained");
  EXPECT_EQ(with("level", "high"), "--set level: must be of the kind of its default, 15 m; got \"high\"\n");
  EXPECT_EQ(with("level", "3*s"), "--set level: must be of the kind of its default, 15 m; got 3 s\n");
  EXPECT_EQ(with("level", "25"), "--set level: 'level' must be at most 20 m, got 25 m\n");
  EXPECT_EQ(with("level", "-1"), "--set level: 'level' must be at least 0 m, got -1 m\n");
  EXPECT_EQ(with("kind", "gmhs"), "--set kind: 'kind' cannot be \"gmhs\"\n");
  EXPECT_EQ(with("drained", "1"), "--set drained: must be of the kind of its default, false; got 1\n");
  EXPECT_EQ(with("cells", "os.exit()"),
            "--set cells: must be of the kind of its default, 500; got \"os.exit()\"\n");
  options.seconds = 0.05;
  EXPECT_NE(with("cells", "(function() while true do end end)()").find("did not end"), std::string::npos);
}

TEST_F(Scripts, wrong_declarations_are_mistakes) {
  read(
      "local a = param { default = 1 }\nlocal b = param { 'b' }\nlocal c = param 'c'\n"
      "local d = param { 'd', default = 1, defualt = 2 }\nlocal e = param { 'd', default = 2 }\n"
      "return Scene { a = a }");
  EXPECT_EQ(said(),
            "scene.lua:1: param needs a name as its first item\n"
            "scene.lua:2: param 'b' needs a default\n"
            "scene.lua:3: param takes one table: param { \"name\", default = …, doc = … }\n"
            "scene.lua:4: param has no key 'defualt'\n"
            "scene.lua:5: param 'd' is declared at scene.lua:4 already\n");
}

}  // namespace
}  // namespace ashlar::script
