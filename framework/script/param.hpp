#pragma once
// `param { "name", default = … }` and `--set name=value`. Internal to script/.

#include <map>

#include "script/machine.hpp"

namespace ashlar::script {

struct Params {
  std::map<std::string, std::string> set;  ///< what was given from outside, as text
  std::vector<ParamUse> uses;              ///< in the order of the script
};

/// The script's function `param`.
int param(lua_State* L);

/// Reports what was set but asked for by no `param`.
void check_all_used(const Params& params, core::Mistakes& mistakes);

}  // namespace ashlar::script
