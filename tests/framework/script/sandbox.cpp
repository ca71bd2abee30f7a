#include "fixture.hpp"

namespace ashlar::script {
namespace {

TEST_F(Scripts, undefined_names_are_collected_and_absorb_what_is_done_to_them) {
  const ScriptResult result = read(
      "local a = undefind + 1\n"
      "local b = (unknown_b.x.y:z(3) .. 'text') ^ 2\n"
      "for k, v in pairs(unknown_c) do error('no') end\n"
      "if unknown_d < 3 then error('no') end\n"
      "unknown_e.x = 5\n"
      "return Scene { a = a, b = b, c = 1, polygons = { Polygn { {0, 0} } } }\n");
  EXPECT_EQ(said(),
            "scene.lua:1: 'undefind' is not defined\n"
            "scene.lua:2: 'unknown_b' is not defined\n"
            "scene.lua:3: 'unknown_c' is not defined\n"
            "scene.lua:4: 'unknown_d' is not defined\n"
            "scene.lua:5: 'unknown_e' is not defined\n"
            "scene.lua:6: 'Polygn' is not defined\n");
  EXPECT_EQ(advice(5), "did you mean 'Polygon'?");
  EXPECT_TRUE(at(result.scene, "a").is_nothing());
  EXPECT_EQ(number(result.scene, "c"), 1);
}

TEST_F(Scripts, words_of_missing_modules_say_so) {
  read("local x = contact.penalty { factor = 1 }\nreturn Scene {}");
  EXPECT_EQ(said(), "scene.lua:1: 'contact' is not defined\n");
  EXPECT_NE(advice().find("modules found: meshing"), std::string::npos);
  EXPECT_NE(advice().find("mesh.voronoi"), std::string::npos);
}

TEST_F(Scripts, an_unknown_constructor_lists_the_known_ones) {
  read("\nreturn Scene { mesh = mesh.voronoy { size = 1 } }");
  EXPECT_EQ(said(), "scene.lua:2: there is no 'mesh.voronoy'\n");
  EXPECT_EQ(advice(), "did you mean 'voronoi'? valid: structured, voronoi");
}

TEST_F(Scripts, an_error_that_only_follows_from_an_undefined_name_is_not_repeated) {
  read("local x = math.sqrt(nonsense) return Scene {}");
  EXPECT_EQ(said(), "scene.lua:1: 'nonsense' is not defined\n");
}

TEST_F(Scripts, new_globals_ask_for_local) {
  const ScriptResult result = read("height = 5\nmesh = 3\nreturn Scene { h = height }");
  EXPECT_EQ(said(),
            "scene.lua:1: 'height' is assigned without being declared\n"
            "scene.lua:2: 'mesh' belongs to the program and cannot be assigned\n");
  EXPECT_EQ(advice(), "write: local height = …");
  EXPECT_EQ(number(result.scene, "h"), 5);
}

TEST_F(Scripts, constructors_take_one_table) {
  read(
      "local a = Polygon(3)\nlocal b = Polygon({}, {})\nlocal t = Polygon {}\nlocal c = mesh.voronoi(t)\n"
      "return Scene { d = mesh.voronoi() }");
  EXPECT_EQ(said(),
            "scene.lua:1: Polygon takes one table: Polygon { … }\n"
            "scene.lua:2: Polygon takes one table: Polygon { … }\n"
            "scene.lua:4: a table made by Polygon cannot become a mesh.voronoi as well\n");
}

TEST_F(Scripts, nothing_dangerous_is_within_reach) {
  for (const std::string name : {"load", "loadstring", "dofile", "loadfile", "io", "os", "debug", "package",
                                 "collectgarbage", "coroutine", "rawset", "_G", "xpcall"}) {
    read("local x = " + name + " return Scene {}");
    EXPECT_EQ(said(), "scene.lua:1: '" + name + "' is not available to scripts\n") << name;
  }
  read("local x = string.dump(function() end) return Scene {}");
  EXPECT_EQ(said(), "scene.lua:1: there is no 'string.dump'\n");
  read("local x = ('').dump return Scene {}");
  EXPECT_EQ(said(), "scene.lua:1: there is no 'string.dump'\n");
  read("string.format = nil; math.pi = 3; units.m = 2; mesh.voronoi = 1; return Scene { pi = math.pi }");
  EXPECT_EQ(mistakes.list().size(), 4u);
  for (const std::string protected_one : {"''", "units", "mesh", "string", "1*units.m", "nonsense", "_ENV"}) {
    read("assert(getmetatable(" + protected_one + ") == false) return Scene {}");
    EXPECT_TRUE(mistakes.empty() || protected_one == "nonsense") << said();
  }
  read("setmetatable(units, {})");
  EXPECT_EQ(said(), "scene.lua:1: cannot change a protected metatable\n");
  read("setmetatable({}, { __gc = function() while true do end end })");
  EXPECT_EQ(said(), "scene.lua:1: '__gc' is not available to scripts\n");
  read("_ENV.io = 1; local e = _ENV['os'] return Scene {}");
  EXPECT_EQ(mistakes.list().size(), 2u);
}

TEST_F(Scripts, trust_opens_files_and_programs) {
  options.trust = true;
  const ScriptResult result = read("return Scene { t = type(io.open), o = type(os.getenv) }");
  EXPECT_EQ(said(), "");
  EXPECT_EQ(*at(result.scene, "t").text(), "function");
}

TEST_F(Scripts, print_goes_to_the_log) {
  read("print('level', 15*units.m, {}, nil) return Scene {}");
  ASSERT_EQ(core::log().lines().size(), 1u);
  EXPECT_EQ(core::log().lines()[0].second, "level\t15 m\ttable\tnil");
}

TEST_F(Scripts, loops_and_random_numbers_repeat_from_run_to_run) {
  const std::string text = R"(
    local t = { 10, 20, z = 1, a = 2, m = 3, [2.5] = 9, [-1] = 8 }
    local order = {}
    for k in pairs(t) do order[#order + 1] = tostring(k); t[k] = nil end
    local again, k = { 3, x = 1, b = 2 }, nil
    repeat k = next(again, k); order[#order + 1] = tostring(k) until k == nil
    return Scene { order = table.concat(order, " "), r = math.random(), same = tostring({}) .. tostring(print) }
  )";
  const ScriptResult one = read(text), two = read(text);
  EXPECT_EQ(said(), "");
  EXPECT_EQ(*at(one.scene, "order").text(), "-1 1 2 2.5 a m z 1 b x nil");
  EXPECT_EQ(number(one.scene, "r"), number(two.scene, "r"));
  EXPECT_EQ(*at(one.scene, "same").text(), "tablefunction");
}

TEST_F(Scripts, quantities_calculate) {
  const ScriptResult result = read(R"(
    local u = units
    assert(2*u.m + 30*u.cm == 2.3*u.m and 1*u.km > 999*u.m and 5*u.m >= 5000*u.mm and u.m ~= u.mm)
    assert(tostring(10*u.GPa) == "10 GPa" and "x = " .. 2*u.m == "x = 2 m")
    assert(type(3*u.m / u.m) == "number" and math.abs(math.sin(30*u.deg) - 0.5) < 1e-15)
    assert(math.max(1*u.m, 3*u.m, 2*u.m) == 3*u.m and math.min(2, 1) == 1 and math.abs(-2*u.m) == 2*u.m)
    assert(math.sqrt(9*u.m^2) == 3*u.m and (4*u.m^2)^0.5 == 2*u.m and -u.m < 0*u.m)
    return Scene { area = 2*u.m * (3*u.m), mixed = 1*u.m + 2, speed = u.m/u.s^2, pure = 50*u.percent }
  )");
  EXPECT_EQ(said(), "");
  EXPECT_EQ(at(result.scene, "area").quantity()->dimension, core::parse_dimension("m^2"));
  EXPECT_EQ(number(result.scene, "mixed"), 3);
  EXPECT_FALSE(at(result.scene, "mixed").quantity()->bare);
  EXPECT_EQ(at(result.scene, "speed").quantity()->dimension, core::parse_dimension("m/s^2"));
  EXPECT_TRUE(at(result.scene, "pure").quantity()->bare);
}

TEST_F(Scripts, dimensions_that_differ_are_mistakes) {
  read(
      "local u = units\nlocal a = 1*u.m + 1*u.s\nlocal b = 1*u.m < 2*u.kg\nlocal c = u.lightyear\n"
      "local d = math.max(u.m, u.s)\nreturn Scene {}");
  EXPECT_EQ(said(),
            "scene.lua:2: cannot add 1 m and 1 s\n"
            "scene.lua:3: cannot compare 1 m and 2 kg\n"
            "scene.lua:4: there is no 'units.lightyear'\n"
            "scene.lua:5: cannot compare 1 m and 1 s\n");
  read("local x = units.m .. {}");
  EXPECT_EQ(said().find("scene.lua:1:"), std::string::npos);
  for (const std::string wrong :
       {"units.m ^ 0.5", "2 ^ units.m", "units.m + {}", "units.m.value", "units.km^40", "units.m ^ (0/0)"}) {
    read("\nlocal x = " + wrong + " return Scene {}");
    EXPECT_EQ(mistakes.list().size(), 1u) << wrong;
    EXPECT_EQ(said().find("scene.lua:2: "), 0u) << said();
  }
}

}  // namespace
}  // namespace ashlar::script
