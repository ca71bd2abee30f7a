#include "contact/normal_laws/linear/linear.hpp"

namespace ashlar::contact {

double Linear::tensile_strength(const Variables& committed) const {
  const bool broken = committed[0] != 0;
  return broken ? 0 : tensile_strength_;
}

void Linear::part(Variables& trial) const {
  if (tensile_strength_ > 0) trial[0] = 1;
}

std::vector<std::string> Linear::variables() const {
  if (tensile_strength_ > 0) return {"broken"};
  return {};
}

std::shared_ptr<const NormalLaw> make_linear(const core::Settings& settings, core::Mistakes& /*mistakes*/) {
  return std::make_shared<Linear>(settings.number("stiffness"), settings.number("tensile_strength", 0));
}

}  // namespace ashlar::contact
