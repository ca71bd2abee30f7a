#include "contact/normal_laws/unilateral/unilateral.hpp"

namespace ashlar::contact {

bool Unilateral::closed(double gap, double tolerance) const {
  return gap <= tolerance;
}

}  // namespace ashlar::contact
