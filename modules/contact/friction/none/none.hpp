#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// Lips slide freely: no shear.
class Frictionless final : public Friction {
 public:
  bool frictionless() const override { return true; }
  Strength strength(double /*pressure*/, double /*path*/) const override { return {}; }
};

}  // namespace ashlar::contact
