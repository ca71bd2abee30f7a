#include "script/param.hpp"

#include <algorithm>

#include "core/hints.hpp"
#include "script/convert.hpp"
#include "script/quantity.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

core::Place place_of_setting(const std::string& name) {
  return {"--set " + name, 0, {}};
}

// What `--set` expressions may use: unit names, `u`, `units` and the functions of math.
void push_expression_names(lua_State* L) {
  lua_newtable(L);
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_getfield(L, -1, "math");
  for (const char* name :
       {"abs", "ceil", "cos", "exp", "floor", "huge", "log", "max", "min", "pi", "sin", "sqrt", "tan"}) {
    lua_getfield(L, -1, name);
    lua_setfield(L, -4, name);
  }
  lua_setfield(L, -3, "math");
  lua_getfield(L, -1, "units");
  for (const core::Unit& unit : core::unit_table()) {
    lua_getfield(L, -1, unit.name.c_str());
    // min is the smallest of numbers too; the unit stays at u.min
    if (unit.name != "min") lua_setfield(L, -4, unit.name.c_str());
    if (unit.name == "min") lua_pop(L, 1);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, -4, "u");
  lua_setfield(L, -3, "units");
  lua_pop(L, 1);
}

void push_text(lua_State* L, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
}

// Pushes what the text says: the value of an expression, or the text itself.
void push_setting(lua_State* L, const std::string& text) {
  const std::string code = "return " + text;
  if (luaL_loadbufferx(L, code.data(), code.size(), "=--set", "t") == LUA_OK) {
    push_expression_names(L);
    lua_setupvalue(L, -2, 1);
    if (lua_pcall(L, 0, 1, 0) == LUA_OK && !lua_isnil(L, -1)) return;
    if (Machine::of(L).stopped()) lua_error(L);
  }
  lua_pop(L, 1);
  push_text(L, text);
}

std::string shown(lua_State* L, int index) {
  if (const auto q = to_quantity(L, index)) return core::format_quantity(q->value, q->dimension);
  if (lua_type(L, index) == LUA_TSTRING) return '"' + std::string(lua_tostring(L, index)) + '"';
  if (lua_type(L, index) == LUA_TBOOLEAN) return lua_toboolean(L, index) ? "true" : "false";
  return std::string("a ") + luaL_typename(L, index);
}

struct Declared {
  int table, fallback;  // stack indices
  std::string name;
  core::Place place;
};

bool has_type_of_default(lua_State* L, const Declared& param, int value, core::Mistakes& mistakes) {
  const auto given = to_quantity(L, value), fallback = to_quantity(L, param.fallback);
  const bool same = given || fallback ? given && fallback : lua_type(L, value) == lua_type(L, param.fallback);
  const bool fits =
      !given || !fallback || given->bare || fallback->bare || given->dimension == fallback->dimension;
  if (same && fits) return true;
  const std::string product =
      lua_type(L, value) == LUA_TSTRING ? core::product_in_script(lua_tostring(L, value), "") : "";
  mistakes.add(place_of_setting(param.name),
               "must be of the kind of its default, " + shown(L, param.fallback) + "; got " + shown(L, value),
               (product.empty() ? "" : "units are multiplied: --set " + param.name + "=" + product + "; ") +
                   "'" + param.name + "' is declared at " + core::to_string(param.place));
  return false;
}

// Replaces the value on top by the outside's, with the default's dimension if it has none.
bool take_setting(lua_State* L, const Declared& param, const std::string& text, core::Mistakes& mistakes) {
  if (lua_type(L, param.fallback) == LUA_TSTRING) {
    const bool quoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
    push_text(L, quoted ? text.substr(1, text.size() - 2) : text);
  } else {
    push_setting(L, text);
  }
  if (!has_type_of_default(L, param, lua_gettop(L), mistakes)) {
    lua_pop(L, 1);
    return false;
  }
  const auto given = to_quantity(L, -1), fallback = to_quantity(L, param.fallback);
  if (given && given->bare && !fallback->bare) {
    lua_pop(L, 1);
    push_quantity(L, given->value, fallback->dimension);
  }
  lua_replace(L, param.fallback + 1);
  return true;
}

void check_limits(lua_State* L, const Declared& param, int value, const core::Place& place,
                  core::Mistakes& mistakes) {
  const auto number = to_quantity(L, value);
  for (const char* key : {"min", "max"}) {
    lua_getfield(L, param.table, key);
    const auto limit = to_quantity(L, -1);
    lua_pop(L, 1);
    if (!limit || !number) continue;
    const bool low = key[1] == 'i';
    if (low ? number->value < limit->value : number->value > limit->value)
      mistakes.add(place, "'" + param.name + "' must be " + (low ? "at least " : "at most ") +
                              core::format_quantity(limit->value, number->dimension) + ", got " +
                              shown(L, value));
  }
}

void check_choices(lua_State* L, const Declared& param, int value, const core::Place& place,
                   core::Mistakes& mistakes) {
  if (lua_getfield(L, param.table, "choices") == LUA_TTABLE) {
    std::vector<std::string> choices;
    bool found = false;
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
      choices.push_back(lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : shown(L, -1));
      found = found || lua_compare(L, -1, value, LUA_OPEQ);
    }
    lua_pop(L, 1);
    if (!found) {
      const std::string word = lua_type(L, value) == LUA_TSTRING ? lua_tostring(L, value) : shown(L, value);
      mistakes.add(place, "'" + param.name + "' cannot be " + shown(L, value),
                   core::did_you_mean(word, choices));
    }
  }
  lua_pop(L, 1);
}

void check_keys(lua_State* L, Machine& machine, const core::Place& place) {
  static const std::vector<std::string> valid = param_schema().keys();
  for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) continue;
    const std::string key = lua_tostring(L, -2);
    if (std::find(valid.begin(), valid.end(), key) != valid.end()) continue;
    machine.mistakes->add(place, "param has no key '" + key + "'", core::did_you_mean(key, valid));
  }
}

}  // namespace

const core::Schema& param_schema() {
  const auto made = [](const char* key, unsigned forms, bool required, const char* doc) {
    core::Parameter parameter;
    parameter.key = key;
    parameter.forms = forms;
    parameter.required = required;
    parameter.doc = doc;
    return parameter;
  };
  using core::Form;
  constexpr auto text = static_cast<unsigned>(Form::text), number = static_cast<unsigned>(Form::number);
  static const core::Schema schema{
      "param",
      "param",
      "param",
      "A value of the script that `--set name=value` changes without an edit: local level = param { "
      "\"level\", "
      "default = 15*units.m }. A bare number takes the default's unit; --set level=12*m or =1200*cm says its "
      "own.",
      {made("", text, true, "the name for --set"),
       made("default", Form::boolean | Form::number | Form::text, true, "the value if nothing is set"),
       made("doc", text, false, "what it is, for `ashlar check`"),
       made("min", number, false, "the least that is allowed"),
       made("max", number, false, "the greatest that is allowed"),
       made("choices", static_cast<unsigned>(Form::list), false, "the values that are allowed")}};
  return schema;
}

int param(lua_State* L) {
  Machine& machine = Machine::of(L);
  const char* usage = "param { \"name\", default = …, doc = … }";
  if (!machine.mistakes) return luaL_error(L, "param works only while the scene is read");
  lua_settop(L, 1);
  if (is_undefined(L, 1)) return 1;
  if (lua_type(L, 1) != LUA_TTABLE) return machine.report(L, std::string("param takes one table: ") + usage);
  core::Mistakes& mistakes = *machine.mistakes;
  const auto mark = machine.mark(L, 1);
  Declared declared{1, 2, {}, mark ? machine.place_of_mark(*mark) : machine.here(L)};
  if (lua_rawgeti(L, 1, 1) != LUA_TSTRING)
    return machine.report_at(L, declared.place, "param needs a name as its first item", usage);
  declared.name = lua_tostring(L, -1);
  lua_settop(L, 1);
  check_keys(L, machine, declared.place);
  if (lua_getfield(L, 1, "default") == LUA_TNIL)
    return machine.report_at(L, declared.place, "param '" + declared.name + "' needs a default", usage);
  if (is_undefined(L, 2)) return 1;
  for (const ParamUse& use : machine.params->uses)
    if (use.name == declared.name && core::to_string(use.place) != core::to_string(declared.place))
      return machine.report_at(
          L, declared.place,
          "param '" + declared.name + "' is declared at " + core::to_string(use.place) + " already");
  lua_pushvalue(L, 2);
  ParamUse use;
  use.name = declared.name;
  use.place = declared.place;
  use.fallback = convert(machine.shared_from_this(), L, 2, declared.place, mistakes);
  core::Place place = declared.place;
  if (const auto set = machine.params->set.find(declared.name); set != machine.params->set.end()) {
    use.said = true;
    place = place_of_setting(declared.name);
    take_setting(L, declared, set->second, mistakes);
  }
  check_limits(L, declared, 3, place, mistakes);
  check_choices(L, declared, 3, place, mistakes);
  use.value = convert(machine.shared_from_this(), L, 3, place, mistakes);
  if (lua_getfield(L, 1, "doc") == LUA_TSTRING) use.doc = lua_tostring(L, -1);
  lua_settop(L, 3);
  auto& uses = machine.params->uses;
  const bool again =
      std::any_of(uses.begin(), uses.end(), [&](const ParamUse& u) { return u.name == use.name; });
  if (!again) uses.push_back(std::move(use));
  return 1;
}

void check_all_used(const Params& params, core::Mistakes& mistakes) {
  std::vector<std::string> names;
  for (const ParamUse& use : params.uses) names.push_back(use.name);
  for (const auto& [name, text] : params.set)
    if (std::find(names.begin(), names.end(), name) == names.end())
      mistakes.add(place_of_setting(name), "the script has no parameter '" + name + "'",
                   names.empty() ? "it has no parameters at all" : core::did_you_mean(name, names));
}

}  // namespace ashlar::script
