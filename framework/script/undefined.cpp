#include "script/undefined.hpp"

#include <lauxlib.h>

#include <initializer_list>

namespace ashlar::script {

namespace {

const char undefined_key = 0;

int absorb(lua_State* L) {
  push_undefined(L);
  return 1;
}

int be_false(lua_State* L) {
  lua_pushboolean(L, 0);
  return 1;
}

int be_zero(lua_State* L) {
  lua_pushinteger(L, 0);
  return 1;
}

int ignore(lua_State*) {
  return 0;
}

int be_text(lua_State* L) {
  lua_pushliteral(L, "undefined");
  return 1;
}

int no_pairs(lua_State* L) {
  lua_pushcfunction(L, ignore);
  return 1;
}

}  // namespace

void make_undefined(lua_State* L) {
  lua_newuserdatauv(L, 1, 0);
  lua_newtable(L);
  for (const char* event :
       {"__index", "__call", "__add", "__sub", "__mul", "__div", "__mod", "__pow", "__unm", "__idiv",
        "__concat", "__band", "__bor", "__bxor", "__shl", "__shr", "__bnot"}) {
    lua_pushcfunction(L, absorb);
    lua_setfield(L, -2, event);
  }
  for (const char* event : {"__lt", "__le"}) {
    lua_pushcfunction(L, be_false);
    lua_setfield(L, -2, event);
  }
  const luaL_Reg rest[] = {{"__len", be_zero},
                           {"__newindex", ignore},
                           {"__tostring", be_text},
                           {"__pairs", no_pairs},
                           {nullptr, nullptr}};
  luaL_setfuncs(L, rest, 0);
  lua_pushstring(L, undefined_type_name);
  lua_setfield(L, -2, "__name");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &undefined_key);
}

void push_undefined(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &undefined_key);
}

bool is_undefined(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TUSERDATA) return false;
  index = lua_absindex(L, index);
  push_undefined(L);
  const bool same = lua_rawequal(L, index, -1);
  lua_pop(L, 1);
  return same;
}

}  // namespace ashlar::script
