// The kinds "study" and "measure" as schemas.

#include "model/parameters.hpp"
#include "study/study.hpp"

namespace ashlar::study {

namespace {

using core::Form;
using core::make_value;
using model::each;
using model::of_kind;
using model::otherwise;
using model::parameter;
using model::required;
using model::within;
// clang-tidy 14 does not see that operators are used.
using model::operator|;  // NOLINT(misc-unused-using-decls)

core::Schema measure() {
  const auto text = [](const char* key, const char* doc) { return parameter(key, Form::text, doc); };
  return {
      "measure",
      "measure",
      "",
      "One number of every run, and what it is compared with.",
      {text("title", "what it is, in words: \"settlement of the crest\"; the measure's name by default"),
       text("stage", "the stage it is read in; the last one by default"),
       text("probe", "a probe of the scene"),
       text("minus", "a probe that is taken off: the jump between two lips"),
       text("joint", "a joint of the scene"),
       text("quantity",
            "of a probe ux, uy, u (length of the displacement) or a stress; of a joint normal_force, "
            "max_slip, max_opening, max_penetration, penetration_over_h or max_pressure"),
       text("cost",
            "what it costs instead: iterations (of the stage, or of all), or cpu or wall, the time of the "
            "run or of one effect in it [s], the best of the repeats; not compared with anything unless "
            "a reference is said") |
           model::one_of({"iterations", "cpu", "wall"}),
       text("effect", "whose time that is: \"contact\""),
       text("at", "any number of the results for machines: \"stages.full.balance.load.x\""),
       parameter(
           "reference", Form::number | Form::text | Form::function,
           "what is right: a number, a function of the case's parameters, \"finest\" (the run with most "
           "unknowns), \"richardson\" (the limit that refined runs tend to, with its uncertainty), or "
           "\"none\"") |
           otherwise(make_value(std::string("richardson"))) |
           model::one_of({"richardson", "finest", "none"})},
      {{{"probe", "joint", "at", "cost"}},
       {{"joint", "minus", "at", "cost"}, 0, 1},
       {{"stage", "at", "effect"}, 0, 1},
       {{"at", "quantity", "cost"}, 1, 1}}};
}

core::Schema study() {
  const auto words = [](const char* key, const char* doc) {
    return parameter(key, Form::list, doc) | each(parameter("", Form::text, ""));
  };
  return {
      "study",
      "study",
      "Study",
      "Many runs of one scene and what they cost: what a script for `ashlar study` returns.",
      {parameter("title", Form::text, "one line that says what is asked") | required(),
       parameter("scene", Form::text, "the scene's file, from the study's folder") |
           otherwise(make_value(std::string("scene.lua"))),
       parameter("vary", Form::map,
                 "values of the scene's parameters, each a list: all combinations are run") |
           each(parameter("", Form::table, "the values of one parameter")),
       parameter("cases", Form::list, "single cases, each a table of parameters") |
           each(parameter("", Form::table, "the parameters of one case")),
       parameter("measure", Form::map, "what is read in every run, by name") | required() |
           each(parameter("", Form::object, "") | of_kind("measure")),
       parameter("refine", Form::text | Form::boolean,
                 "the parameter that makes runs finer, or false for none; by default the only number that "
                 "is varied"),
       words("problem",
             "parameters that change what is asked and not how well it is answered: each of their values "
             "has its own reference"),
       parameter("without", Form::map,
                 "what effects cost: by name, the parameters that leave each out of the last case; the page "
                 "shows how much less time it takes then") |
           each(parameter("", Form::table, "the parameters that leave one effect out")),
       parameter("repeats", Form::integer, "runs of each case; costs are the best of them") |
           otherwise(make_value(1.0)) | within({1, 100, false, false}),
       parameter("threads", Form::integer, "threads of each run") | otherwise(make_value(1.0)) |
           within({1, 1024, false, false}),
       parameter("files", Form::boolean,
                 "let the runs write pictures, tables and fields, and count that as a cost") |
           otherwise(make_value(false))},
      {{{"vary", "cases"}, 1, 2}}};
}

}  // namespace

void register_study_kinds(core::Registry& registry) {
  registry.add_schema(study());
  registry.add_schema(measure());
}

}  // namespace ashlar::study
