#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// p = −k g, k = factor E'/h or a given stiffness; the same against slip while lips stick.
class Penalty final : public Enforcement {
 public:
  /// `stiffness` [Pa/m] rules if it is above 0.
  Penalty(double factor, double stiffness) : factor_(factor), stiffness_(stiffness) {}
  /// k [Pa/m].
  double stiffness(const ContactPoint& point) const;
  Hold hold(const ContactPoint& point, const Eigen::Vector2d& base, double growth) const override;

 private:
  double factor_, stiffness_;
};

}  // namespace ashlar::contact
