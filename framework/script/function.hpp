#pragma once
// Functions of a script that are called after it was read. Internal to script/.

#include <memory>

#include "script/machine.hpp"

namespace ashlar::script {

/// Holds the function at `index`; `place` is used where Lua knows none.
std::shared_ptr<const core::Function> make_function(const std::shared_ptr<Machine>& machine, lua_State* L,
                                                    int index, core::Place place);

}  // namespace ashlar::script
