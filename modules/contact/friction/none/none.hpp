#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

class Frictionless final : public Friction {
 public:
  Shear shear(double slip, double pressure) const override;
};

}  // namespace ashlar::contact
