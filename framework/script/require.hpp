#pragma once
// `require` of scripts: reads NAME.lua from the scene's folder or a library folder, never from elsewhere.

#include <lua.h>

namespace ashlar::script {

int require(lua_State* L);

}  // namespace ashlar::script
