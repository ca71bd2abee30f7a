#pragma once

#include "contact/joint_law.hpp"
#include "contact/lua_function.hpp"

namespace ashlar::contact {

/// A normal law written in the scenario: p(o). Its derivative is a central difference.
class LuaNormal final : public NormalLaw {
 public:
  explicit LuaNormal(LuaFunction pressure) : pressure_(std::move(pressure)) {}
  Form form() const override { return Form::traction; }
  /// Throws InputError with the function's place if it fails or returns what is no pressure.
  Pressure pressure(double opening, const Variables& committed, Variables& trial) const override;

 private:
  LuaFunction pressure_;
};

/// The maker of kind "normal_law", name "lua". Tries the law on a few openings.
MakeNormalLaw make_lua_normal;

}  // namespace ashlar::contact
