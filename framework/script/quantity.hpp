#pragma once
// Quantities in scripts: 15*u.m. Pure numbers are plain Lua numbers. Internal to script/.

#include <lua.h>

#include <optional>

#include "core/value.hpp"

namespace ashlar::script {

void make_quantities(lua_State* L);
/// A plain number if the dimension is none.
void push_quantity(lua_State* L, double value, core::Dimension dimension);
/// A quantity or a number (bare); nothing for anything else, text included.
std::optional<core::Quantity> to_quantity(lua_State* L, int index);

/// Pushes the read-only table `units`.
void push_units(lua_State* L);
/// Makes abs, max, min, floor, ceil, sqrt of the math table on top of the stack take quantities too.
void extend_math(lua_State* L);

}  // namespace ashlar::script
