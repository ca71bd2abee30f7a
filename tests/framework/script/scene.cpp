#include "fixture.hpp"

namespace ashlar::script {
namespace {

TEST_F(Scripts, a_scene_becomes_tagged_tables) {
  const ScriptResult result = read(R"(
    local u = units
    local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
    return Scene {
      title = "Dam",
      geometry = { rock = Polygon { {0, 0, "bottom"}, {25*u.m, 0}, material = rock } },
      mesh = mesh.voronoi { size = 0.5 }, gravity = true,
    })");
  EXPECT_EQ(said(), "");
  EXPECT_EQ(result.scene.table()->constructor, "Scene");
  EXPECT_EQ(*at(result.scene, "title").text(), "Dam");
  EXPECT_TRUE(*at(result.scene, "gravity").boolean());
  EXPECT_EQ(at(result.scene, "geometry.rock").table()->constructor, "Polygon");
  EXPECT_EQ(at(result.scene, "mesh").table()->constructor, "mesh.voronoi");
  EXPECT_EQ(*at(result.scene, "geometry.rock.1.3").text(), "bottom");
  const core::Quantity& E = *at(result.scene, "geometry.rock.material.E").quantity();
  EXPECT_DOUBLE_EQ(E.value, 1e10);
  EXPECT_EQ(E.dimension, core::parse_dimension("Pa"));
  EXPECT_FALSE(E.bare);
  EXPECT_TRUE(at(result.scene, "geometry.rock.material.nu").quantity()->bare);
  EXPECT_EQ(at(result.scene, "geometry.rock.material.unit_weight").quantity()->dimension,
            core::parse_dimension("N/m^3"));
  EXPECT_EQ(at(result.scene, "geometry.rock.material.E").place.path, "geometry.rock.material.E");
  EXPECT_EQ(at(result.scene, "geometry.rock.2.1").place.path, "geometry.rock[2][1]");
  ASSERT_EQ(result.sources.size(), 1u);
  EXPECT_EQ(result.sources[0].first, "scene.lua");
  EXPECT_NE(result.sources[0].second.find("material.elastic"), std::string::npos);
}

TEST_F(Scripts, every_entry_knows_its_line) {
  const ScriptResult result = read(
      "local shared = {\n"                                              // 1
      "  x = 1,\n"                                                      // 2
      "}\n"                                                             // 3
      "--[[ a { comment }\n"                                            // 4
      "{{{ ]] local text = 'brace } { \\' {'\n"                         // 5
      "local long = [==[ { ]] {\n"                                      // 6
      "} ]==]\n"                                                        // 7
      "return Scene {\n"                                                // 8
      "  a = 1, b = { 1,\n"                                             // 9
      "    2, -- a, comma {\n"                                          // 10
      "    { deep = 'x, {',\n"                                          // 11
      "      other = 1 }, },\n"                                         // 12
      "  f = function(p, q)\n"                                          // 13
      "    local t = { p, q }; if p then return t, 1 end\n"             // 14
      "    for i = 1, 2 do local g = function() return 1, 2 end end\n"  // 15
      "    repeat local x = 1, 2 until true\n"                          // 16
      "    return 0\n"                                                  // 17
      "  end,\n"                                                        // 18
      "  after = (1 + (2)), ['quoted key'] = math.max(1, 2,\n"          // 19
      "    3), last = text, shared = shared,\n"                         // 20
      "  [ 'spaced' ] = 1e-3; semi = 0x1p-4,\n"                         // 21
      "  eq = 1 == 2,\n"                                                // 22
      "}\n");
  EXPECT_EQ(said(), "");
  auto line = [&](const std::string& path) { return at(result.scene, path).place.line; };
  EXPECT_EQ(line(""), 8);
  EXPECT_EQ(line("a"), 9);
  EXPECT_EQ(line("b.1"), 9);
  EXPECT_EQ(line("b.2"), 10);
  EXPECT_EQ(line("b.3.deep"), 11);
  EXPECT_EQ(line("b.3.other"), 12);
  EXPECT_EQ(line("f"), 13);
  EXPECT_EQ(line("after"), 19);
  EXPECT_EQ(line("quoted key"), 19);
  EXPECT_EQ(line("last"), 20);
  EXPECT_EQ(line("shared"), 1);
  EXPECT_EQ(line("shared.x"), 2);
  EXPECT_EQ(line("spaced"), 21);
  EXPECT_EQ(line("semi"), 21);
  EXPECT_EQ(line("eq"), 22);
}

TEST_F(Scripts, commas_of_calls_and_functions_are_no_fields) {
  const ScriptResult result = read(
      "return Scene {\n"          // 1
      "  math.max(1,\n"           // 2
      "    2, 3),\n"              // 3
      "  function(a,\n"           // 4
      "    b) local c, d = 1,\n"  // 5
      "    2 end,\n"              // 6
      "  9 }\n");                 // 7
  EXPECT_EQ(said(), "");
  EXPECT_EQ(at(result.scene, "1").place.line, 2);
  EXPECT_EQ(at(result.scene, "2").place.line, 4);
  EXPECT_EQ(at(result.scene, "3").place.line, 7);
}

TEST_F(Scripts, other_line_ends_count_as_in_lua) {
  const ScriptResult result =
      read("#!/usr/bin/ashlar\r\nlocal a = 1\r\nreturn Scene {\r\n  x = 1,\r\n  y = 2 }");
  EXPECT_EQ(said(), "");
  EXPECT_EQ(at(result.scene, "y").place.line, 5);
}

TEST_F(Scripts, entries_come_by_line_then_by_name) {
  const ScriptResult result = read(
      "local t = { zeta = 1,\n alpha = 2, beta = 3,\n gamma = 4 }\n"
      "t.b_later = 1; t.a_later = 2; return Scene { t = t }");
  std::string order;
  for (const auto& [key, value] : at(result.scene, "t").table()->entries) order += key + " ";
  EXPECT_EQ(order, "zeta alpha beta gamma a_later b_later ");
  EXPECT_EQ(at(result.scene, "t.a_later").place.line, 1);
}

TEST_F(Scripts, call_syntax_and_methods_survive_the_marks) {
  const ScriptResult result = read(R"(
    local function first(t) return t[1] end
    local object = { twice = function(self, t) return 2 * t[1] end }
    local n = 0
    for _, v in ipairs{ 1, 2, 3 } do n = n + v end
    local function both() return 1, 2 end
    return Scene { a = first{ 7 }, b = object:twice{ 4 }, n = n, count = #{ 1, 2, 3 }, all = { both() },
                   s = ("x{%d}"):format(3), nested = first{ { first{ { 5 } } } } }
  )");
  EXPECT_EQ(said(), "");
  EXPECT_EQ(number(result.scene, "a"), 7);
  EXPECT_EQ(number(result.scene, "b"), 8);
  EXPECT_EQ(number(result.scene, "n"), 6);
  EXPECT_EQ(number(result.scene, "count"), 3);
  EXPECT_EQ(number(result.scene, "all.2"), 2);
  EXPECT_EQ(*at(result.scene, "s").text(), "x{3}");
  EXPECT_EQ(number(result.scene, "nested.1.1"), 5);
}

TEST_F(Scripts, tables_that_are_no_data_are_mistakes) {
  read("local t = {}\nt.self = t\nreturn Scene { t = t }");
  EXPECT_EQ(said(), "scene.lua:1: t.self: the table contains itself\n");
  read("return Scene { t = { [2.5] = 1, [true] = 2 } }");
  EXPECT_NE(said().find("scene.lua:1: t: keys must be names or 1, 2, 3, …; got the key 2.5"),
            std::string::npos);
  EXPECT_NE(said().find("got a boolean as a key"), std::string::npos);
  read("return Scene { t = { 1, nil, 3 } }");
  EXPECT_EQ(said(), "scene.lua:1: t: item 2 is nil, but item 3 is there\n");
  read("return Scene { a = 1,\n b = 2,\n a = 3 }");
  EXPECT_EQ(said(), "scene.lua:3: a: is given twice, first in line 1\n");
  read("return Scene { mesh = mesh.voronoi }");
  EXPECT_EQ(said(), "scene.lua:1: mesh: mesh.voronoi needs a table\n");
  read("local t = {} for i = 1, 200 do t = { t } end return Scene { t = t }");
  EXPECT_NE(said().find("nested deeper than"), std::string::npos);
  options.seconds = 0.2;
  read("local t = { 1 } for i = 1, 50 do t = { t, t } end return Scene { t = t }");
  EXPECT_FALSE(mistakes.empty());
}

TEST_F(Scripts, what_is_no_scene_is_a_mistake) {
  read("local x = 1");
  EXPECT_EQ(said(), "scene.lua: the script returns nothing\n");
  read("return { a = 1 }");
  EXPECT_EQ(said(), "scene.lua:1: the script must return Scene { … }, but returns a table\n");
  read("return Polygon {}");
  EXPECT_EQ(said(), "scene.lua:1: the script must return Scene { … }, but returns Polygon { … }\n");
  read("return 5");
  EXPECT_EQ(said(), "scene.lua: the script must return Scene { … }, but returns a number\n");
  read("");
  EXPECT_EQ(said(), "scene.lua: the script returns nothing\n");
  read_scene(folder / "nowhere.lua", registry, options, mistakes = {});
  EXPECT_NE(said().find("nowhere.lua: cannot be read: there is no such file"), std::string::npos);
}

TEST_F(Scripts, a_folder_stands_for_its_scene) {
  write("scene.lua", "return Scene { a = 1 }");
  const ScriptResult result = read_scene(folder, registry, options, mistakes);
  EXPECT_EQ(said(), "");
  EXPECT_EQ(result.sources[0].first, folder / "scene.lua");
}

TEST_F(Scripts, errors_of_lua_have_their_place) {
  read("local a = 1\nlocal b = = 2");
  EXPECT_EQ(said(), "scene.lua:2: unexpected symbol near '='\n");
  read("return Scene {\n a = { 1, 2,\n b = 3 }");
  EXPECT_EQ(said(), "scene.lua:3: '}' expected (to close '{' at line 1) near <eof>\n");
  read("return Scene { a = 1 b = 2 }");
  EXPECT_EQ(said(), "scene.lua:1: '}' expected near 'b'\n");
  read("local t = {}\n\nlocal x = t.a.b");
  EXPECT_EQ(said(), "scene.lua:3: attempt to index a nil value (field 'a')\n");
  read("local function f()\n error('too steep')\nend\nf()");
  EXPECT_EQ(said(), "scene.lua:2: too steep\n");
  read("\nerror('plain', 0)");
  EXPECT_EQ(said(), "scene.lua:2: plain\n");
  read("\nerror { code = 1 }");
  EXPECT_EQ(said(), "scene.lua:2: the script raised an error with a table instead of a text\n");
  read("\nassert(1 == 2, 'sizes differ')");
  EXPECT_EQ(said(), "scene.lua:2: sizes differ\n");
}

TEST_F(Scripts, long_names_of_files_are_not_cut) {
  const std::string name = std::string(100, 'd') + "/scene.lua";
  const auto file = write(name, "\n\nerror('here')");
  read_scene(file, registry, options, mistakes);
  EXPECT_EQ(said(), file.string() + ":3: here\n");
}

TEST_F(Scripts, require_reads_from_the_scene_and_the_library_only) {
  write("parts/dam.lua", "return { height = 103,\n wrong = undefined_thing }");
  write("lib/profiles.lua", "return { base = 70 }");
  write("outside.lua", "return { secret = 1 }");
  options.library = {folder / "lib"};
  const ScriptResult result = read(
      "local dam = require 'parts.dam'\nlocal p = require('profiles')\n"
      "return Scene { h = dam, p = p, same = dam == require 'parts/dam' }");
  EXPECT_EQ(said(), "parts/dam.lua:2: 'undefined_thing' is not defined\n");
  EXPECT_EQ(number(result.scene, "h.height"), 103);
  EXPECT_EQ(at(result.scene, "h.height").place.file, "parts/dam.lua");
  EXPECT_EQ(number(result.scene, "p.base"), 70);
  EXPECT_TRUE(*at(result.scene, "same").boolean());
  EXPECT_EQ(result.sources.size(), 3u);
}

TEST_F(Scripts, require_leaves_no_other_way) {
  for (const std::string name :
       {"../outside", "/etc/passwd", "..outside", "a/../b", "", "a//b", "x\\0y", ".hidden"}) {
    read("local x = require '" + name + "' return Scene {}");
    EXPECT_NE(said().find("is not allowed"), std::string::npos) << name << ": " << said();
  }
  read("local x = require 'nowhere'\nlocal y = x.a + 1\nreturn Scene {}");
  EXPECT_EQ(said(), "scene.lua:1: require \"nowhere\" finds no such file\n");
  write("circle.lua", "return require 'circle'");
  read("local x = require 'circle' return Scene {}");
  EXPECT_EQ(said(), "circle.lua:1: require \"circle\" requires itself\n");
  write("broken.lua", "local x = = 1");
  read("local x = require 'broken'\nlocal y = nonsense\nreturn Scene {}");
  EXPECT_EQ(said(), "broken.lua:1: unexpected symbol near '='\nscene.lua:2: 'nonsense' is not defined\n");
}

TEST_F(Scripts, data_files_are_plain_tables) {
  const auto file = write("expected.lua", "return { crest = { uy = -1.5*units.mm, tolerance = 1e-3 } }");
  const core::Value value = read_data(file);
  EXPECT_DOUBLE_EQ(number(value, "crest.uy"), -1.5e-3);
  EXPECT_THROW(read_data(write("bad.lua", "return { a = b }")), core::InputError);
  EXPECT_THROW(read_data(write("none.lua", "return 1")), core::InputError);
  EXPECT_THROW(read_data(folder / "missing.lua"), core::InputError);
}

}  // namespace
}  // namespace ashlar::script
