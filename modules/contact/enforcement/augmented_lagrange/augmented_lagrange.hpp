#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// p = λ − k g with k = factor E'/h; λ takes over p until penetration/h falls below a tolerance, and is kept
/// from step to step. Where that is slow, k grows tenfold, up to a cap.
class AugmentedLagrange final : public Enforcement {
 public:
  AugmentedLagrange(double factor, double cap, double tolerance)
      : factor_(factor), cap_(cap), tolerance_(tolerance) {}
  Hold hold(const ContactPoint& point, const Eigen::Vector2d& base, double growth) const override;
  Augment augment(double penetration, double before, double growth) const override;

 private:
  double factor_, cap_, tolerance_;
};

}  // namespace ashlar::contact
