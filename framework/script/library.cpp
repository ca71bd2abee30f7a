#include "script/library.hpp"

#include <algorithm>
#include <cstring>

#include "core/log.hpp"
#include "script/machine.hpp"
#include "script/quantity.hpp"
#include "script/sandbox.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

constexpr lua_Integer most_moved = 100'000'000;
constexpr std::size_t longest_text = std::size_t{1} << 28;

// Lua's own tostring shows addresses, which differ from run to run.
void push_shown(lua_State* L, int index) {
  const int type = lua_type(L, index);
  const bool has_address = type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA;
  if (has_address && luaL_getmetafield(L, index, "__tostring") == LUA_TNIL)
    lua_pushstring(L, luaL_typename(L, index));
  else
    luaL_tolstring(L, index, nullptr);
}

int print(lua_State* L) {
  const int count = lua_gettop(L);
  std::string line;
  for (int i = 1; i <= count; ++i) {
    push_shown(L, i);
    line += (i > 1 ? "\t" : "") + std::string(lua_tostring(L, -1));
  }
  core::log().info(line);
  return 0;
}

int to_text(lua_State* L) {
  luaL_checkany(L, 1);
  push_shown(L, 1);
  return 1;
}

int continue_pcall(lua_State* L, int status, lua_KContext) {
  if (status != LUA_OK && status != LUA_YIELD && Machine::of(L).stopped()) return lua_error(L);
  lua_pushboolean(L, status == LUA_OK || status == LUA_YIELD);
  lua_replace(L, 1);
  return lua_gettop(L);
}

// As Lua's pcall, but a limit that was hit cannot be caught.
int protected_call(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushnil(L);
  lua_insert(L, 1);
  return continue_pcall(L, lua_pcall(L, lua_gettop(L) - 2, LUA_MULTRET, 0), 0);
}

int set_metatable(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  if (!lua_isnil(L, 2)) {
    luaL_checktype(L, 2, LUA_TTABLE);
    // Finalizers run outside the limits; lengths drive loops inside Lua.
    for (const char* event : {"__gc", "__len", "__mode"}) {
      lua_pushstring(L, event);
      lua_rawget(L, 2);
      if (!lua_isnil(L, -1)) return luaL_error(L, "'%s' is not available to scripts", event);
      lua_pop(L, 1);
    }
  }
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL)
    return luaL_error(L, "cannot change a protected metatable");
  lua_settop(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

struct Key {
  bool is_number;
  double number;
  lua_Integer whole;  // LUA_MININTEGER if the number is not whole
  std::string text;
  bool operator<(const Key& other) const {
    if (is_number != other.is_number) return is_number;
    return is_number ? number < other.number : text < other.text;
  }
};

bool is_plain_key(lua_State* L, int index) {
  return lua_type(L, index) == LUA_TNUMBER || lua_type(L, index) == LUA_TSTRING;
}

Key plain_key(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER)
    return {
        true, lua_tonumber(L, index), lua_isinteger(L, index) ? lua_tointeger(L, index) : LUA_MININTEGER, {}};
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {false, 0, 0, std::string(text, size)};
}

// Pushes a list of the table's keys: numbers, then names, both sorted, then the rest. Lua's own order of
// names differs from run to run.
void push_sorted_keys(lua_State* L, int table) {
  std::vector<Key> plain;
  lua_newtable(L);
  const int list = lua_gettop(L);
  lua_newtable(L);
  lua_Integer others = 0;
  for (lua_pushnil(L); lua_next(L, table); lua_pop(L, 1)) {
    if (is_plain_key(L, -2)) {
      plain.push_back(plain_key(L, -2));
    } else {
      lua_pushvalue(L, -2);
      lua_rawseti(L, list + 1, ++others);
    }
  }
  std::sort(plain.begin(), plain.end());
  lua_Integer count = 0;
  for (const Key& key : plain) {
    if (!key.is_number)
      lua_pushlstring(L, key.text.data(), key.text.size());
    else if (key.whole != LUA_MININTEGER)
      lua_pushinteger(L, key.whole);
    else
      lua_pushnumber(L, key.number);
    lua_rawseti(L, list, ++count);
  }
  for (lua_Integer i = 1; i <= others; ++i) {
    lua_rawgeti(L, list + 1, i);
    lua_rawseti(L, list, ++count);
  }
  lua_settop(L, list);
}

// upvalues: table, sorted keys, position
int next_pair(lua_State* L) {
  for (;;) {
    const lua_Integer at = lua_tointeger(L, lua_upvalueindex(3)) + 1;
    lua_pushinteger(L, at);
    lua_replace(L, lua_upvalueindex(3));
    if (lua_rawgeti(L, lua_upvalueindex(2), at) == LUA_TNIL) return 1;
    lua_pushvalue(L, -1);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 2;
    lua_pop(L, 2);  // removed while looping
  }
}

int ordered_pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 3);
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  lua_pushvalue(L, 1);
  push_sorted_keys(L, 1);
  lua_pushinteger(L, 0);
  lua_pushcclosure(L, guarded<next_pair>, 3);
  return 1;
}

int ordered_next(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  push_sorted_keys(L, 1);
  lua_Integer at = 1;
  if (!lua_isnil(L, 2)) {
    for (bool found = false; !found; ++at) {
      if (lua_rawgeti(L, 3, at) == LUA_TNIL) return luaL_error(L, "'next' was given a key that is not there");
      found = lua_compare(L, 2, -1, LUA_OPEQ);
      lua_pop(L, 1);
    }
  }
  if (lua_rawgeti(L, 3, at) == LUA_TNIL) return 1;
  lua_pushvalue(L, -1);
  lua_rawget(L, 1);
  return 2;
}

// Lua's own loops n times even over nothing.
int repeat_text(lua_State* L) {
  std::size_t size = 0, gap = 0;
  const char* text = luaL_checklstring(L, 1, &size);
  const lua_Integer count = luaL_checkinteger(L, 2);
  const char* separator = luaL_optlstring(L, 3, "", &gap);
  if (count <= 0 || size + gap == 0) return lua_pushliteral(L, ""), 1;
  if (static_cast<std::size_t>(count) > longest_text / (size + gap))
    return luaL_error(L, "the text would be longer than %d MiB", static_cast<int>(longest_text >> 20));
  luaL_Buffer buffer;
  luaL_buffinit(L, &buffer);
  for (lua_Integer i = 0; i < count; ++i) {
    if (i > 0) luaL_addlstring(&buffer, separator, gap);
    luaL_addlstring(&buffer, text, size);
  }
  luaL_pushresult(&buffer);
  return 1;
}

// upvalue: Lua's own, which would loop over any range inside C
int move_items(lua_State* L) {
  const lua_Integer first = luaL_checkinteger(L, 2), last = luaL_checkinteger(L, 3);
  if (last >= first && static_cast<lua_Unsigned>(last) - static_cast<lua_Unsigned>(first) > most_moved)
    return luaL_error(L, "too many items to move");
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

void add_base(lua_State* L) {
  luaL_requiref(L, "_G", luaopen_base, 0);
  for (const char* name : {"assert", "error", "getmetatable", "ipairs", "rawequal", "rawget", "rawlen",
                           "select", "tonumber", "type"}) {
    lua_getfield(L, -1, name);
    lua_setfield(L, -3, name);
  }
  lua_pop(L, 1);
  const luaL_Reg ours[] = {{"print", guarded<print>},
                           {"tostring", guarded<to_text>},
                           {"pcall", protected_call},
                           {"setmetatable", guarded<set_metatable>},
                           {"pairs", guarded<ordered_pairs>},
                           {"next", guarded<ordered_next>},
                           {nullptr, nullptr}};
  luaL_setfuncs(L, ours, 0);
}

void add_math(lua_State* L) {
  luaL_requiref(L, "math", luaopen_math, 0);
  extend_math(L);
  lua_getfield(L, -1, "randomseed");
  lua_pushinteger(L, 1);
  lua_pushinteger(L, 0);
  lua_call(L, 2, 0);
  seal(L, "math");
  lua_setfield(L, -2, "math");
}

void add_string(lua_State* L) {
  luaL_requiref(L, "string", luaopen_string, 0);
  lua_pushnil(L);
  lua_setfield(L, -2, "dump");
  lua_pushcfunction(L, guarded<repeat_text>);
  lua_setfield(L, -2, "rep");
  seal(L, "string");
  lua_setfield(L, -2, "string");
  // Hide the metatable that all texts share.
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 2);
}

void add_table(lua_State* L) {
  luaL_requiref(L, "table", luaopen_table, 0);
  lua_getfield(L, -1, "move");
  lua_pushcclosure(L, guarded<move_items>, 1);
  lua_setfield(L, -2, "move");
  seal(L, "table");
  lua_setfield(L, -2, "table");
}

}  // namespace

void add_library(lua_State* L, bool trust) {
  add_base(L);
  add_math(L);
  add_string(L);
  add_table(L);
  luaL_requiref(L, "utf8", luaopen_utf8, 0);
  seal(L, "utf8");
  lua_setfield(L, -2, "utf8");
  if (!trust) return;
  luaL_requiref(L, "io", luaopen_io, 0);
  lua_setfield(L, -2, "io");
  luaL_requiref(L, "os", luaopen_os, 0);
  lua_setfield(L, -2, "os");
}

}  // namespace ashlar::script
