#include "script/sandbox.hpp"

#include <algorithm>
#include <array>

#include "script/library.hpp"
#include "script/machine.hpp"
#include "script/quantity.hpp"
#include "script/require.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

// Addresses of these are keys in Lua's own registry: what exists, and the constructors' functions.
const char globals_key = 0, constructors_key = 0;

std::vector<std::string> text_keys(lua_State* L, int index) {
  std::vector<std::string> keys;
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) keys.emplace_back(lua_tostring(L, -2));
  std::sort(keys.begin(), keys.end());
  return keys;
}

// upvalues: the table, its name
int unknown_field(lua_State* L) {
  const std::string name = lua_tostring(L, lua_upvalueindex(2));
  const std::string key = luaL_tolstring(L, 2, nullptr);
  return Machine::of(L).report(L, "there is no '" + name + "." + key + "'",
                               core::did_you_mean(key, text_keys(L, lua_upvalueindex(1))));
}

int refuse_field(lua_State* L) {
  const std::string name = lua_tostring(L, lua_upvalueindex(2));
  const std::string key = luaL_tolstring(L, 2, nullptr);
  Machine::of(L).report(
      L, "'" + name + "." + key + "' cannot be assigned: '" + name + "' belongs to the program");
  return 0;
}

std::vector<std::string> constructor_words(lua_State* L) {
  std::vector<std::string> words;
  lua_rawgetp(L, LUA_REGISTRYINDEX, &constructors_key);
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) words.emplace_back(lua_tostring(L, -1));
  lua_pop(L, 1);
  std::sort(words.begin(), words.end());
  return words;
}

std::string module_names(const core::Registry* registry) {
  std::string text;
  if (registry)
    for (const core::Registry::Module& module : registry->modules())
      text += (text.empty() ? "" : ", ") + module.name;
  return text.empty() ? "none" : text;
}

bool is_known_lua(const std::string& name) {
  static const std::array<const char*, 15> names = {
      "load",           "loadstring", "dofile", "loadfile", "io", "os",      "debug",  "package",
      "collectgarbage", "coroutine",  "xpcall", "rawset",   "_G", "getfenv", "setfenv"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "m" was meant as units.m, "penalty" as contact.penalty; empty if neither is so.
std::string full_name(const std::string& name, const std::vector<std::string>& words) {
  for (const core::Unit& unit : core::unit_table())
    if (unit.name == name) return "units." + name;
  for (const std::string& word : words)
    if (word.ends_with("." + name)) return word;
  return {};
}

int undefined_global(lua_State* L) {
  const std::string name = luaL_tolstring(L, 2, nullptr);
  if (is_known_lua(name)) {
    const bool trustable = name == "io" || name == "os";
    return Machine::of(L).report(L, "'" + name + "' is not available to scripts",
                                 trustable ? "only --trust gives a script access to files and programs" : "");
  }
  lua_rawgetp(L, LUA_REGISTRYINDEX, &globals_key);
  const std::string guess = core::nearest(name, text_keys(L, -1));
  const std::vector<std::string> words = constructor_words(L);
  if (const std::string full = full_name(name, words); !full.empty())
    return Machine::of(L).report(L, "'" + name + "' is not defined", "did you mean '" + full + "'?");
  std::string advice = guess.empty() ? core::did_you_mean(name, words) : "did you mean '" + guess + "'?";
  if (guess.empty() && !words.empty())
    advice += "\n    modules found: " + std::string(lua_tostring(L, lua_upvalueindex(1))) +
              "; a missing module's words are missing too";
  return Machine::of(L).report(L, "'" + name + "' is not defined", advice);
}

int refuse_global(lua_State* L) {
  const std::string name = luaL_tolstring(L, 2, nullptr);
  lua_pop(L, 1);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &globals_key);
  lua_pushvalue(L, 2);
  const bool ours = lua_rawget(L, -2) != LUA_TNIL;
  lua_pop(L, 2);
  Machine::of(L).report(
      L,
      ours ? "'" + name + "' belongs to the program and cannot be assigned"
           : "'" + name + "' is assigned without being declared",
      ours ? "choose another name: local my_" + name + " = …" : "write: local " + name + " = …");
  lua_settop(L, 3);
  if (!ours) lua_rawset(L, 1);  // so that reading it is no second mistake
  return 0;
}

// upvalue: the word
int construct(lua_State* L) {
  Machine& machine = Machine::of(L);
  const std::string word = lua_tostring(L, lua_upvalueindex(1));
  if (lua_gettop(L) == 0) {
    lua_newtable(L);
    machine.mark_here(L, 1);
  }
  if (is_undefined(L, 1)) return push_undefined(L), 1;
  if (lua_gettop(L) != 1 || lua_type(L, 1) != LUA_TTABLE)
    return machine.report(
        L, word + " takes one table: " + word + " { … }",
        std::string("got ") + (lua_gettop(L) == 1 ? luaL_typename(L, 1) : "several values"));
  const std::string before = machine.word(L, 1);
  if (!before.empty() && before != word)
    return machine.report(L, "a table made by " + before + " cannot become a " + word + " as well");
  if (!machine.mark(L, 1)) machine.mark_here(L, 1);
  machine.set_word(L, 1, word);
  lua_settop(L, 1);
  return 1;
}

void push_constructor(lua_State* L, const std::string& word) {
  lua_pushlstring(L, word.data(), word.size());
  lua_pushcclosure(L, guarded<construct>, 1);
  lua_rawgetp(L, LUA_REGISTRYINDEX, &constructors_key);
  lua_pushvalue(L, -2);
  lua_pushlstring(L, word.data(), word.size());
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

// Adds "mesh.voronoi" or "Scene" to the table of globals on top of the stack.
void add_constructor(lua_State* L, const std::string& word) {
  const auto dot = word.find('.');
  if (dot == std::string::npos) {
    push_constructor(L, word);
    lua_setfield(L, -2, word.c_str());
    return;
  }
  const std::string group = word.substr(0, dot);
  if (lua_getfield(L, -1, group.c_str()) != LUA_TTABLE) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, group.c_str());
  }
  push_constructor(L, word);
  lua_setfield(L, -2, word.substr(dot + 1).c_str());
  lua_pop(L, 1);
}

void add_constructors(lua_State* L, const core::Registry& registry) {
  std::vector<std::string> groups;
  for (const std::string& kind : registry.kinds())
    for (const std::string& name : registry.names(kind)) {
      const std::string& word = registry.find(kind, name)->schema.constructor;
      if (word.empty()) continue;
      add_constructor(L, word);
      if (const auto dot = word.find('.'); dot != std::string::npos) groups.push_back(word.substr(0, dot));
    }
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  for (const std::string& group : groups) {
    lua_getfield(L, -1, group.c_str());
    seal(L, group);
    lua_setfield(L, -2, group.c_str());
  }
}

}  // namespace

void seal(lua_State* L, const std::string& name) {
  lua_newtable(L);  // the empty stand-in that the script holds
  lua_newtable(L);  // its metatable
  auto add_event = [&](const char* event, lua_CFunction function) {
    lua_pushvalue(L, -3);
    lua_pushlstring(L, name.data(), name.size());
    lua_pushcclosure(L, function, 2);
    lua_setfield(L, -2, event);
  };
  add_event("__newindex", guarded<refuse_field>);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  // What the table itself lacks is a mistake.
  lua_newtable(L);
  lua_pushvalue(L, -4);
  lua_pushlstring(L, name.data(), name.size());
  lua_pushcclosure(L, guarded<unknown_field>, 2);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -4);
  lua_setmetatable(L, -2);
  lua_remove(L, -2);
}

void add_global(lua_State* L, const char* name, lua_CFunction function) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &globals_key);
  lua_pushcfunction(L, function);
  lua_setfield(L, -2, name);
  lua_pop(L, 1);
}

std::string constructor_word(lua_State* L, int index) {
  if (!lua_iscfunction(L, index)) return {};
  return text_of(L, &constructors_key, index);
}

void make_sandbox(lua_State* L, const Surroundings& surroundings) {
  lua_newtable(L);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &constructors_key);
  make_quantities(L);
  lua_newtable(L);  // all that exists
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &globals_key);
  add_library(L, surroundings.trust);
  push_units(L);
  lua_setfield(L, -2, "units");
  if (surroundings.registry) add_constructors(L, *surroundings.registry);
  lua_pushcfunction(L, guarded<require>);
  lua_setfield(L, -2, "require");

  lua_newtable(L);  // what the script sees as its globals: empty, so that every assignment is noticed
  lua_newtable(L);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<refuse_global>);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);

  lua_newtable(L);
  lua_pushstring(L,
                 module_names(surroundings.registry).c_str());  // the registry may be gone when functions run
  lua_pushcclosure(L, guarded<undefined_global>, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

}  // namespace ashlar::script
