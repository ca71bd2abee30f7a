#include "fixture.hpp"

namespace ashlar::script {
namespace {

const std::string gravity = R"(return {
  name = "gravity", doc = "Self-weight.",
  provides = {
    { kind = "load", name = "weight", constructor = "load.weight", doc = "weight", parameters = {
      { key = "g", forms = { "number", "function" }, dimension = "m/s^2", range = { above = 0, to = 100 }, default = 9.81 },
      { key = "on", forms = { "list" }, required = true, each = { forms = { "text" }, refers = "region" } },
      { key = "law", forms = { "object" }, kind = "friction", default = "none", numerical = true },
      { key = "how", forms = { "text" }, choices = { "a", "b" }, usual = { from = 1 } } },
      alternatives = { { "g", "how" }, { "g", "law", "how", least = 0, most = 2 } } } },
  extends = { stage = { { key = "gravity", forms = { "boolean" } } } },
  effects = { { name = "gravity", called_by = { "stage.gravity" }, doc = "d", left_out = "l" } },
})";

TEST_F(Scripts, manifests_fill_the_registry) {
  write("modules/gravity/module.lua", gravity);
  write("modules/no_module/readme.txt", "");
  read_module_manifests({folder / "modules", folder / "nowhere"}, registry);
  const core::Registry::Entry* entry = registry.find("load", "weight");
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->module, "gravity");
  const core::Parameter& g = entry->schema.parameters[0];
  EXPECT_EQ(g.forms, core::Form::number | core::Form::function);
  EXPECT_EQ(g.dimension, core::parse_dimension("m/s^2"));
  EXPECT_TRUE(g.range.low_open);
  EXPECT_FALSE(g.range.high_open);
  EXPECT_EQ(g.range.high, 100);
  EXPECT_EQ(g.fallback->quantity()->value, 9.81);
  EXPECT_EQ(entry->schema.parameters[1].each->refers, "region");
  EXPECT_TRUE(entry->schema.parameters[1].required);
  EXPECT_EQ(entry->schema.parameters[2].kind, "friction");
  EXPECT_EQ(entry->schema.parameters[3].choices, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(entry->schema.alternatives.size(), 2u);
  EXPECT_EQ(to_string(entry->schema.alternatives[0]), "exactly one of g and how");
  EXPECT_EQ(to_string(entry->schema.alternatives[1]), "at most 2 of g, law and how");
  ASSERT_EQ(registry.modules().size(), 2u);
  EXPECT_EQ(registry.modules()[1].library, (folder / "modules/gravity/ashlar_gravity.so").string());
  ASSERT_EQ(registry.effects().size(), 1u);
  EXPECT_EQ(registry.effects()[0].called_by, std::vector<std::string>{"stage.gravity"});
  add("stage", "stage", "Stage");
  EXPECT_TRUE(registry.find("stage", "stage")->schema.find("gravity"));
  EXPECT_TRUE(registry.open_modules().empty());
}

TEST_F(Scripts, wrong_manifests_are_all_reported) {
  write("modules/a/module.lua", "return { name = 'a',\n provides = { { kind = 'x', nam = 'y' } } }");
  write("modules/b/module.lua",
        "return { name = 'b', provides = { { kind = 'x', name = 'y', parameters = {\n"
        " { key = 'k', forms = { 'numbre' }, dimension = 'Pascal' } } } } }");
  write("modules/c/module.lua", "return = 1");
  write("modules/d/module.lua", "return { name = 'd', provides = { { kind = 'mesh', name = 'voronoi' } } }");
  write("modules/e/module.lua",
        "return { name = 'e', provides = { { kind = 'x', name = 'z', parameters = { { key = 'k', forms = { "
        "'text' } } },\n"
        " alternatives = { { 'k', 'n' } } } } }");
  try {
    read_module_manifests({folder / "modules"}, registry);
    FAIL();
  } catch (const core::InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("a/module.lua:2: provides[1].nam: unknown key 'nam'\n    did you mean 'name'?"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("provides[1].name: is missing"), std::string::npos) << text;
    EXPECT_NE(
        text.find("b/module.lua:2: provides[1].parameters[1].forms[1]: 'numbre' is none of the choices"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("e/module.lua:2: provides[1].alternatives[1][2]: there is no parameter 'n' here"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("c/module.lua:1: unexpected symbol"), std::string::npos) << text;
    EXPECT_NE(text.find("which the framework provides already"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace ashlar::script
