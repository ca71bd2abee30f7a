#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// H(−g): closed for g ≤ 0.
class Unilateral final : public NormalLaw {
 public:
  bool closed(double gap, double tolerance) const override;
};

}  // namespace ashlar::contact
