#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// Lagrange multipliers: tractions are unknowns, and what is held is held exactly.
class Lagrange final : public Enforcement {
 public:
  Hold hold(const ContactPoint& point, const Eigen::Vector2d& base, double growth) const override;
};

}  // namespace ashlar::contact
