#include "contact/friction/none/none.hpp"

namespace ashlar::contact {

Shear Frictionless::shear(double /*slip*/, double /*pressure*/) const {
  return {};
}

}  // namespace ashlar::contact
