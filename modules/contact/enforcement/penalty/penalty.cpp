#include "contact/enforcement/penalty/penalty.hpp"

namespace ashlar::contact {

double Penalty::stiffness(const ContactPoint& point) const {
  return stiffness_ > 0 ? stiffness_ : factor_ * point.modulus / point.h;
}

Pressure Penalty::pressure(double gap, const ContactPoint& point) const {
  const double k = stiffness(point);
  return {-k * gap, -k};
}

}  // namespace ashlar::contact
