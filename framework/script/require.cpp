#include "script/require.hpp"

#include <cctype>

#include "script/machine.hpp"
#include "script/undefined.hpp"

namespace ashlar::script {

namespace {

const char loaded_key = 0;

// Dots and slashes part the names of folders; nothing leads upwards or to an absolute path.
bool is_valid(const std::string& name) {
  bool starts = true;
  for (const char c : name) {
    const bool part_end = c == '.' || c == '/';
    if (part_end && starts) return false;
    if (!part_end && !std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') return false;
    starts = part_end;
  }
  return !starts;
}

std::filesystem::path find_file(const Machine& machine, std::string name) {
  for (char& c : name)
    if (c == '.') c = '/';
  std::error_code error;
  for (const auto& folder : machine.require_from)
    for (const auto& file : {folder / (name + ".lua"), folder / name / "init.lua"})
      if (std::filesystem::is_regular_file(file, error)) return file;
  return {};
}

std::string searched(const Machine& machine) {
  std::string text;
  for (const auto& folder : machine.require_from)
    text += (text.empty() ? "searched in: " : ", ") + (folder.empty() ? "." : folder.string());
  return text;
}

void push_loaded(lua_State* L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &loaded_key) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &loaded_key);
}

}  // namespace

int require(lua_State* L) {
  Machine& machine = Machine::of(L);
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, 1, &size);
  const std::string name(text, size);
  if (!is_valid(name))
    return machine.report(
        L, "require \"" + name + "\" is not allowed",
        "a name like \"profiles\" or \"dams/koyna\" below the scene's folder or the library");
  const std::filesystem::path file = find_file(machine, name);
  if (file.empty())
    return machine.report(L, "require \"" + name + "\" finds no such file", searched(machine));
  lua_settop(L, 1);
  push_loaded(L);
  const int type = lua_getfield(L, 2, file.string().c_str());
  if (type == LUA_TLIGHTUSERDATA) return machine.report(L, "require \"" + name + "\" requires itself");
  if (type != LUA_TNIL) return 1;
  lua_pop(L, 1);
  lua_pushlightuserdata(L, &machine);
  lua_setfield(L, 2, file.string().c_str());
  if (machine.compile(L, file, file.string(), read_text(file)))
    machine.run_chunk(L);
  else
    push_undefined(L);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    lua_pushboolean(L, 1);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, 2, file.string().c_str());
  return 1;
}

}  // namespace ashlar::script
