#include "core/schema.hpp"

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "core/registry.hpp"

namespace ashlar::core {
namespace {

Parameter parameter(const std::string& key, unsigned forms, const std::string& dimension = {}) {
  Parameter p;
  p.key = key;
  p.forms = forms;
  p.dimension = parse_dimension(dimension);
  return p;
}

unsigned only(Form form) {
  return static_cast<unsigned>(form);
}

std::shared_ptr<const Parameter> each(Parameter p) {
  return std::make_shared<const Parameter>(std::move(p));
}

/// Tables as a script would give them: paths and lines included.
class Builder {
 public:
  Builder& set(const std::string& key, Value value) {
    value.place = {"s.lua", ++line_, key};
    table_.entries.emplace_back(key, std::move(value));
    return *this;
  }
  Builder& item(Value value) {
    value.place = {"s.lua", ++line_, "[" + std::to_string(table_.items.size() + 1) + "]"};
    table_.items.push_back(std::move(value));
    return *this;
  }
  Value make(const std::string& constructor = {}) {
    table_.constructor = constructor;
    return make_value(table_, {"s.lua", 1, {}});
  }

 private:
  Table table_;
  int line_ = 1;
};

Value quantity(double value, const std::string& dimension) {
  return {{}, Quantity{value, parse_dimension(dimension), false}};
}

class Checks : public ::testing::Test {
 protected:
  Checks() {
    log().clear();
    Parameter E = parameter("E", only(Form::number), "Pa");
    E.required = true;
    E.range = {0, 1e13, true, false};
    E.usual = {1e6, 1e12, false, false};
    E.doc = "Young's modulus";
    Parameter nu = parameter("nu", only(Form::number));
    nu.fallback = make_value(0.25);
    registry.add_schema({"material", "elastic", "material.elastic", "Linear elasticity.", {E, nu}});
    Parameter k = parameter("k", only(Form::number), "Pa/m");
    k.fallback = make_value(5.0);
    registry.add_schema({"law", "spring", "law.spring", "", {k}});
    registry.add_schema({"law", "none", "law.none", "", {}});
  }

  Settings check_one(Parameter p, Value value) {
    mistakes = {};
    p.key = "p";
    const Schema schema{"thing", "thing", "Thing", "", {std::move(p)}};
    return check(Builder().set("p", std::move(value)).make(), schema, registry, mistakes);
  }
  std::string said() const {
    std::string text;
    for (const Mistake& m : mistakes.list()) text += to_string(m) + "\n";
    return text;
  }

  Registry registry;
  Mistakes mistakes;
};

TEST_F(Checks, defaults_are_filled_in_and_marked) {
  const Schema& schema = registry.find("material", "elastic")->schema;
  const Settings settings =
      check(Builder().set("E", quantity(1e10, "Pa")).make("material.elastic"), schema, registry, mistakes);
  EXPECT_EQ(said(), "");
  EXPECT_EQ(settings.number("E"), 1e10);
  EXPECT_TRUE(settings.said("E"));
  EXPECT_EQ(settings.number("nu"), 0.25);
  EXPECT_FALSE(settings.said("nu"));
  EXPECT_TRUE(settings.has("nu"));
  EXPECT_EQ(settings.kind, "material");
  EXPECT_EQ(settings.name, "elastic");
  EXPECT_EQ(to_string(settings.place_of("E")), "s.lua:2: E");
}

TEST_F(Checks, every_mistake_is_reported_at_once) {
  const Schema& schema = registry.find("material", "elastic")->schema;
  check(Builder()
            .set("e", make_value(1.0))
            .set("nu", make_value(std::string("high")))
            .item(make_value(3.0))
            .make(),
        schema, registry, mistakes);
  EXPECT_EQ(said(),
            "s.lua:2: e: unknown key 'e'\n    did you mean 'E'? valid: E, nu\n"
            "s.lua:4: [1]: an item without a key: 3\n    valid: E, nu\n"
            "s.lua:1: E: is missing: a number (Pa), Young's modulus\n"
            "s.lua:3: nu: must be a number, got the text \"high\"\n");
}

TEST_F(Checks, a_wrong_dimension_names_the_right_one) {
  check_one(parameter("", only(Form::number), "Pa"), quantity(3, "m"));
  EXPECT_EQ(said(), "s.lua:2: p: must be in Pa, got 3 m\n    for example 2*units.Pa\n");
  check_one(parameter("", only(Form::number), "N/m^3"), quantity(3, "m"));
  EXPECT_EQ(said(), "s.lua:2: p: must be in N/m^3, got 3 m\n    for example 2*units.N/units.m^3\n");
  check_one(parameter("", only(Form::number)), quantity(3, "m"));
  EXPECT_EQ(said(), "s.lua:2: p: must be a pure number, got 3 m\n    for example 0.3, a pure number\n");
  EXPECT_EQ(check_one(parameter("", only(Form::number), "Pa"), make_value(3.0)).number("p"), 3);
  EXPECT_EQ(said(), "");
}

TEST_F(Checks, ranges_are_reported_with_units) {
  Parameter p = parameter("", only(Form::number), "Pa");
  p.range = {0, 1e9, true, false};
  check_one(p, make_value(0.0));
  EXPECT_EQ(said(), "s.lua:2: p: must be above 0 Pa and at most 1 GPa, got 0 Pa\n");
  EXPECT_FALSE(check_one(p, quantity(2e9, "Pa")).has("p"));
  EXPECT_TRUE(check_one(p, quantity(1e9, "Pa")).has("p"));
  check_one(p, make_value(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_NE(said().find("must be a finite number"), std::string::npos);
}

TEST_F(Checks, unusual_values_are_warned_of) {
  const Schema& schema = registry.find("material", "elastic")->schema;
  const Settings settings = check(Builder().set("E", make_value(10.0)).make(), schema, registry, mistakes);
  EXPECT_EQ(said(), "");
  EXPECT_EQ(settings.number("E"), 10);
  ASSERT_EQ(log().lines().size(), 1u);
  EXPECT_EQ(log().lines()[0].second,
            "s.lua:2: E: 10 Pa is unusual (usually at least 1 MPa and at most 1000 GPa); is the unit right?");
}

TEST_F(Checks, whole_numbers) {
  const Parameter p = parameter("", only(Form::integer));
  EXPECT_EQ(check_one(p, make_value(7.0)).integer("p"), 7);
  check_one(p, make_value(7.5));
  EXPECT_EQ(said(), "s.lua:2: p: must be a whole number within ±2147483647, got 7.5\n");
  check_one(p, make_value(1e12));
  EXPECT_FALSE(mistakes.empty());
}

TEST_F(Checks, choices_are_listed) {
  Parameter p = parameter("", only(Form::text));
  p.choices = {"strain", "stress"};
  EXPECT_EQ(check_one(p, make_value(std::string("stress"))).text("p"), "stress");
  check_one(p, make_value(std::string("stres")));
  EXPECT_EQ(said(),
            "s.lua:2: p: 'stres' is none of the choices\n    did you mean 'stress'? valid: strain, stress\n");
}

TEST_F(Checks, unions_take_each_of_their_forms) {
  const Parameter p = parameter("", Form::boolean | Form::number | Form::point, "m");
  EXPECT_TRUE(check_one(p, make_value(true)).flag("p"));
  EXPECT_EQ(check_one(p, make_value(2.0)).number("p"), 2);
  const Value point = Builder().item(make_value(1.0)).item(quantity(2, "m")).make();
  EXPECT_EQ(check_one(p, point).point("p"), std::pair(1.0, 2.0));
  check_one(p, make_value(std::string("x")));
  EXPECT_EQ(said(),
            "s.lua:2: p: must be true or false or a number (m) or a point {x, y} (m), got the text \"x\"\n");
}

TEST_F(Checks, a_point_may_say_what_its_two_numbers_are) {
  Parameter count = parameter("", only(Form::integer));
  count.range = {1, 100, false, false};
  Parameter p = parameter("", only(Form::point));
  p.each = each(count);
  const auto two = [](double a, double b) {
    return Builder().item(make_value(a)).item(make_value(b)).make();
  };
  EXPECT_EQ(check_one(p, two(3, 4)).point("p"), std::pair(3.0, 4.0));
  EXPECT_EQ(said(), "");
  check_one(p, two(3.5, 0));
  const std::string text = said();
  EXPECT_NE(text.find("must be a whole number"), std::string::npos) << text;
  EXPECT_NE(text.find("must be at least 1 and at most 100, got 0"), std::string::npos) << text;
  check_one(p, Builder().item(make_value(3.0)).make());
  EXPECT_EQ(said(), "s.lua:2: p: must be two of: a whole number, got a table\n");
}

TEST_F(Checks, objects_come_as_words_or_constructors) {
  Parameter p = parameter("", only(Form::object));
  p.kind = "law";
  Settings settings = check_one(p, make_value(std::string("spring")));
  EXPECT_EQ(said(), "");
  EXPECT_EQ(settings.object("p").name, "spring");
  EXPECT_EQ(settings.object("p").number("k"), 5);
  settings = check_one(p, Builder().set("k", make_value(7.0)).make("law.spring"));
  EXPECT_EQ(settings.object("p").number("k"), 7);
  check_one(p, make_value(std::string("sprung")));
  EXPECT_EQ(said(), "s.lua:2: p: there is no law 'sprung'\n    did you mean 'spring'? valid: none, spring\n");
  check_one(p, Builder().make("material.elastic"));
  EXPECT_EQ(
      said(),
      "s.lua:2: p: must be a law, got material.elastic { … }\n    valid: law.none { … }, law.spring { … }\n");
  check_one(p, Builder().make("law.sprnig"));
  EXPECT_EQ(said(),
            "s.lua:2: p: there is no law 'law.sprnig'\n    did you mean 'law.spring'? valid: law.none, "
            "law.spring\n");
  p.kind = "absent";
  check_one(p, make_value(std::string("x")));
  EXPECT_NE(said().find("no module provides the kind 'absent'"), std::string::npos);
  p.kind = "material";  // one entry only: the constructor may be left out
  EXPECT_EQ(check_one(p, Builder().set("E", make_value(1e9)).make()).object("p").number("E"), 1e9);
}

TEST_F(Checks, objects_inside_lists_and_maps) {
  Parameter p = parameter("", Form::list | Form::map);
  p.kind = "law";
  const Value inner = Builder().set("k", make_value(std::string("x"))).make("law.spring");
  Settings settings = check_one(p, Builder().item(make_value(std::string("none"))).item(inner).make());
  ASSERT_EQ(settings.objects("p").size(), 2u);
  EXPECT_EQ(settings.objects("p")[0].second.name, "none");
  EXPECT_EQ(said(), "s.lua:2: k: must be a number (N/m^3), got the text \"x\"\n");
  settings = check_one(p, Builder().set("left", make_value(std::string("spring"))).make());
  EXPECT_EQ(settings.objects("p")[0].first, "left");
  p.forms = only(Form::list);
  check_one(p, Builder().set("left", make_value(std::string("spring"))).make());
  EXPECT_EQ(said(), "s.lua:2: left: a list takes no keys, got 'left'\n");
  p.forms = only(Form::map);
  check_one(p, Builder().item(make_value(std::string("spring"))).make());
  EXPECT_EQ(said(), "s.lua:2: [1]: every entry needs a name: name = …, got the text \"spring\"\n");
}

TEST_F(Checks, items_of_lists_are_checked_one_by_one) {
  Parameter p = parameter("", only(Form::list));
  p.each = each(parameter("", only(Form::number), "m"));
  const Settings settings =
      check_one(p, Builder().item(make_value(1.0)).item(make_value(true)).item(quantity(1, "s")).make());
  EXPECT_EQ(mistakes.list().size(), 2u);
  EXPECT_EQ(settings.value("p").table()->items.size(), 3u);
  EXPECT_TRUE(settings.value("p").table()->items[1].is_nothing());
}

TEST_F(Checks, positional_items_have_a_parameter_without_key) {
  Parameter name = parameter("", only(Form::text));
  name.required = true;
  const Schema schema{"stage", "stage", "Stage", "", {name, parameter("gravity", only(Form::boolean))}};
  const Settings settings =
      check(Builder().item(make_value(std::string("first"))).make("Stage"), schema, registry, mistakes);
  EXPECT_EQ(said(), "");
  ASSERT_EQ(settings.items.size(), 1u);
  EXPECT_EQ(*settings.items[0].text(), "first");
  EXPECT_FALSE(settings.has("gravity"));
  check(Builder().make("Stage"), schema, registry, mistakes);
  EXPECT_EQ(said(), "s.lua:1: needs a text without a key\n");
}

TEST_F(Checks, undefined_values_are_no_second_mistake) {
  const Schema& schema = registry.find("material", "elastic")->schema;
  check(Builder().set("E", Value{}).make(), schema, registry, mistakes);
  EXPECT_EQ(said(), "");
}

TEST_F(Checks, the_wrong_constructor_at_the_top) {
  const Schema& schema = registry.find("material", "elastic")->schema;
  const Settings settings = check(Builder().make("law.none"), schema, registry, mistakes);
  EXPECT_EQ(said(), "s.lua:1: must be material.elastic { … }, got law.none { … }\n");
  EXPECT_FALSE(settings.has("E"));
}

TEST_F(Checks, a_default_that_contains_itself_ends) {
  Parameter p = parameter("again", only(Form::object));
  p.kind = "loop";
  p.fallback = make_value(std::string("loop"));
  registry.add_schema({"loop", "loop", "loop.loop", "", {p}});
  check(make_value(Table{}, {}), registry.find("loop", "loop")->schema, registry, mistakes);
  EXPECT_NE(said().find("nested deeper"), std::string::npos);
}

TEST_F(Checks, a_schema_describes_itself) {
  EXPECT_EQ(describe(registry.find("material", "elastic")->schema),
            "material.elastic    in scripts: material.elastic { … }\n"
            "Linear elasticity.\n"
            "  E: a number (Pa), required\n"
            "      Young's modulus\n"
            "      must be above 0 Pa and at most 10000 GPa\n"
            "      usually at least 1 MPa and at most 1000 GPa\n"
            "  nu: a number, default 0.25\n");
}

TEST(registry, extensions_reach_schemas_before_and_after) {
  Registry registry;
  registry.add_schema({"stage", "stage", "Stage", "", {}});
  registry.extend("stage", "", {parameter("gravity", only(Form::boolean))}, "gravity");
  registry.extend("joint", "joint", {parameter("friction", only(Form::text))}, "contact");
  registry.add_schema({"joint", "joint", "Joint", "", {}});
  EXPECT_TRUE(registry.find("stage", "stage")->schema.find("gravity"));
  EXPECT_TRUE(registry.find("joint", "joint")->schema.find("friction"));
  EXPECT_THROW(registry.extend("stage", "", {parameter("gravity", only(Form::number))}, "other"), InputError);
  EXPECT_THROW(registry.add_schema({"stage", "stage", "", "", {}}), InputError);
}

TEST(registry, makers_arrive_when_the_module_is_opened) {
  Registry registry;
  registry.add_module({"m", "", "m.so", false});
  registry.add_schema({"law", "spring", "law.spring", "", {}}, "m");
  registry.add_schema({"law", "forgotten", "law.forgotten", "", {}}, "m");
  int opened = 0;
  registry.set_opener([&](Registry& r, const Registry::Module& module) {
    EXPECT_EQ(module.library, "m.so");
    ++opened;
    r.add_make("law", "spring", std::function<int(int)>([](int x) { return 2 * x; }));
  });
  EXPECT_TRUE(registry.open_modules().empty());
  EXPECT_EQ(registry.make<int(int)>("law", "spring")(21), 42);
  EXPECT_EQ(registry.make<int(int)>("law", "spring")(1), 2);
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(registry.open_modules(), std::vector<std::string>{"m"});
  EXPECT_THROW(registry.make<int(int)>("law", "forgotten"), InputError);
  EXPECT_THROW(registry.make<int(int)>("law", "sprung"), InputError);
  EXPECT_THROW(registry.make<int(int)>("lw", "spring"), InputError);
  EXPECT_THROW(registry.add_make("law", "unknown", std::function<int(int)>()), InputError);
}

TEST_F(Checks, alternatives_are_counted) {
  const auto said_of = [&](Alternative alternative, const std::vector<std::string>& keys) {
    mistakes = {};
    const Schema schema{"thing",
                        "thing",
                        "Thing",
                        "",
                        {parameter("a", only(Form::number)), parameter("b", only(Form::number)),
                         parameter("c", only(Form::number))},
                        {std::move(alternative)}};
    Builder table;
    for (const std::string& key : keys) table.set(key, make_value(1.0));
    check(table.make(), schema, registry, mistakes);
    return said();
  };
  const Alternative one{{"a", "b"}};
  EXPECT_EQ(said_of(one, {"b"}), "");
  EXPECT_EQ(said_of(one, {}),
            "s.lua:1: needs exactly one of a and b, got none of them\n"
            "    `ashlar describe Thing` tells what each means\n");
  EXPECT_EQ(said_of(one, {"b", "a"}), "s.lua:3: a: a and b are both said\n    say exactly one of a and b\n");
  EXPECT_EQ(said_of({{"a", "b", "c"}, 0, 1}, {}), "");
  EXPECT_EQ(said_of({{"a", "b", "c"}, 0, 2}, {"a", "b", "c"}),
            "s.lua:4: c: a and b and c are all said\n    say at most 2 of a, b and c\n");
  EXPECT_EQ(said_of({{"a", "b"}, 1, 2}, {"a", "b"}), "");
  EXPECT_EQ(said_of({{"a", "b"}, 1, 2}, {}).find("needs at least one of a and b"), 9u);
  // A misspelt key is the one mistake, not two.
  EXPECT_EQ(said_of(one, {"d"}).find("s.lua:2: d: unknown key 'd'"), 0u);
  EXPECT_EQ(said().find("needs"), std::string::npos);
  EXPECT_NE(describe({"thing", "thing", "", "", {}, {one}}).find("say exactly one of a and b"),
            std::string::npos);
}

TEST_F(Checks, a_wrong_value_keeps_its_place) {
  Parameter map = parameter("p", only(Form::map));
  map.each = each(parameter("", only(Form::number), "m"));
  const Settings settings = check_one(map, Builder().set("x", quantity(1, "Pa")).make());
  EXPECT_EQ(said(), "s.lua:2: x: must be in m, got 1 Pa\n    for example 2*units.m\n");
  const Value& item = settings.value("p").table()->entries[0].second;
  EXPECT_TRUE(item.is_nothing());
  EXPECT_EQ(to_string(item.place), "s.lua:2: x");
}

TEST_F(Checks, the_commonest_slips_are_answered) {
  check_one(parameter("p", only(Form::number), "Pa"), make_value(std::string("3.5 kN/m^2")));
  EXPECT_NE(said().find("units are multiplied: 3.5*units.kN/units.m^2"), std::string::npos) << said();
  check_one(parameter("p", only(Form::number)), make_value(std::string("3 apples")));
  EXPECT_EQ(said().find("multiplied"), std::string::npos) << said();
  Parameter list = parameter("p", only(Form::list));
  list.each = each(parameter("", only(Form::text)));
  check_one(list, make_value(std::string("top")));
  EXPECT_NE(said().find("put it into braces: { \"top\" }"), std::string::npos) << said();
  Parameter law = parameter("p", only(Form::list));
  law.kind = "law";
  check_one(law, Builder().make("law.spring"));
  EXPECT_NE(said().find("put it into braces: { law.spring { … } }"), std::string::npos) << said();
  registry.add_schema({"stage", "stage", "Stage", "", {parameter("", only(Form::text))}});
  law.kind = "stage";
  check_one(law, Builder().set("gravity", make_value(true)).make());
  EXPECT_NE(said().find("each item is Stage { … }"), std::string::npos) << said();
  Parameter stage = parameter("p", only(Form::object));
  stage.kind = "stage";
  check_one(stage, make_value(std::string("w")));
  EXPECT_NE(said().find("must be a stage, got the text \"w\"\n    valid: Stage { … }"), std::string::npos)
      << said();
  // One entry may stand where a list of them could: its keys tell.
  law.forms = Form::object | Form::list;
  EXPECT_TRUE(check_one(law, Builder().set("x", make_value(1.0)).make()).entry("p").object);
}

}  // namespace
}  // namespace ashlar::core
