#pragma once

#include "contact/joint_law.hpp"
#include "contact/lua_function.hpp"

namespace ashlar::contact {

/// A friction law written in the scenario: f(p, γ) and perhaps D(p, γ), asked for p ≥ 0 and γ ≥ 0 only.
class LuaFriction final : public Friction {
 public:
  struct Data {
    LuaFunction strength;
    LuaFunction dilation;  ///< may be none
    double stiffness = std::numeric_limits<double>::infinity();
  };
  explicit LuaFriction(Data data) : data_(std::move(data)) {}
  double stiffness() const override { return data_.stiffness; }
  /// These throw InputError with the function's place if it fails or returns no number.
  Strength strength(double pressure, double path) const override;
  contact::Dilation dilation(double pressure, double from, double to) const override;

 private:
  Data data_;
};

/// The maker of kind "friction", name "lua". Tries the law on a few pressures and slips.
MakeFriction make_lua_friction;

}  // namespace ashlar::contact
