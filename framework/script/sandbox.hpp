#pragma once
// What a script sees: a whitelist of Lua, units, constructors, and nothing else. Internal to script/.

#include <lua.h>

#include <string>

#include "core/registry.hpp"

namespace ashlar::script {

struct Surroundings {
  const core::Registry* registry = nullptr;  ///< gives the constructors; null for plain data
  bool trust = false;
};

/// Makes the environment in which all chunks of the state run.
void make_sandbox(lua_State* L, const Surroundings& surroundings);

/// Turns the table on top of the stack into a read-only one: an unknown field is a mistake with did-you-mean,
/// an assignment too. `name` is how the script calls it.
void seal(lua_State* L, const std::string& name);

/// Adds one function to the environment.
void add_global(lua_State* L, const char* name, lua_CFunction function);

/// The word of a constructor function at `index`; "" for any other value.
std::string constructor_word(lua_State* L, int index);

}  // namespace ashlar::script
