#pragma once
// The value of a name that does not exist: it absorbs calls, indexing and arithmetic. Internal to script/.

#include <lua.h>

namespace ashlar::script {

void make_undefined(lua_State* L);
void push_undefined(lua_State* L);
bool is_undefined(lua_State* L, int index);

/// Appears in Lua's messages about it; such a message only follows from a mistake reported already.
inline constexpr const char* undefined_type_name = "undefined value";

}  // namespace ashlar::script
