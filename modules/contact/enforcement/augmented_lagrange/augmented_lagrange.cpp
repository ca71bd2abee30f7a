#include "contact/enforcement/augmented_lagrange/augmented_lagrange.hpp"

#include <algorithm>

namespace ashlar::contact {

namespace {

// A pass that leaves more than this share of the penetration is slow.
constexpr double slow = 0.25;

}  // namespace

Hold AugmentedLagrange::hold(const ContactPoint& point, const Eigen::Vector2d& base, double growth) const {
  const double compliance = point.h / (std::min(factor_ * growth, cap_) * point.modulus);
  return {compliance, compliance, base[0], base[1]};
}

Enforcement::Augment AugmentedLagrange::augment(double penetration, double before, double growth) const {
  if (penetration <= tolerance_) return {false, growth};
  const bool stiffer = penetration > slow * before && factor_ * growth < cap_;
  return {true, stiffer ? 10 * growth : growth};
}

}  // namespace ashlar::contact
