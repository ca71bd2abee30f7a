#include "contact/enforcement/penalty/penalty.hpp"

namespace ashlar::contact {

double Penalty::stiffness(const ContactPoint& point) const {
  return stiffness_ > 0 ? stiffness_ : factor_ * point.modulus / point.h;
}

Hold Penalty::hold(const ContactPoint& point, const Eigen::Vector2d& /*base*/, double /*growth*/) const {
  const double compliance = 1 / stiffness(point);
  return {compliance, compliance, 0, 0};
}

}  // namespace ashlar::contact
