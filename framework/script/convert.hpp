#pragma once
// Lua values → core::Value. Internal to script/.

#include <memory>

#include "script/machine.hpp"

namespace ashlar::script {

/// Converts the value at `index`; its place is `place` unless it was written elsewhere. Mistakes (bad keys,
/// holes, cycles, values that are no data) go to `mistakes`. Functions keep `machine` alive.
core::Value convert(const std::shared_ptr<Machine>& machine, lua_State* L, int index, core::Place place,
                    core::Mistakes& mistakes);

}  // namespace ashlar::script
