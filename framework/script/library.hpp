#pragma once
// Lua's own functions that scripts may use, made safe and repeatable. Internal to script/.

#include <lua.h>

namespace ashlar::script {

/// Adds them to the table of globals on top of the stack.
void add_library(lua_State* L, bool trust);

}  // namespace ashlar::script
