#pragma once

#include "contact/joint_law.hpp"
#include "contact/lua_function.hpp"

namespace ashlar::contact {

/// A normal law written in the scenario: p(o), or p(o, state) and the next state. Its derivative is a central
/// difference.
class LuaNormal final : public NormalLaw {
 public:
  /// `variables`: numbers that a point remembers, 0 … 3.
  explicit LuaNormal(LuaFunction pressure, int variables = 0)
      : pressure_(std::move(pressure)), variables_(variables) {}
  Form form() const override { return Form::traction; }
  /// Throws InputError with the function's place if it fails or returns what is no pressure.
  Pressure pressure(double opening, const Variables& committed, Variables& trial) const override;
  std::vector<std::string> variables() const override;

 private:
  double asked(double opening, const Variables& committed, Variables& trial) const;

  LuaFunction pressure_;
  int variables_ = 0;
};

/// The maker of kind "normal_law", name "lua". Tries the law on a few openings.
MakeNormalLaw make_lua_normal;

}  // namespace ashlar::contact
