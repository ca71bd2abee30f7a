#include "contact/enforcement/lagrange/lagrange.hpp"

namespace ashlar::contact {

Hold Lagrange::hold(const ContactPoint& /*point*/, const Eigen::Vector2d& /*base*/, double /*growth*/) const {
  return {};
}

}  // namespace ashlar::contact
