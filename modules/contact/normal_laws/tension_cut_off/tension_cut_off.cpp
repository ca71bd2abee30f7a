#include "contact/normal_laws/tension_cut_off/tension_cut_off.hpp"

namespace ashlar::contact {

double TensionCutOff::tensile_strength(const Variables& committed) const {
  const bool broken = committed[0] != 0;
  return broken ? 0 : tensile_strength_;
}

void TensionCutOff::part(Variables& trial) const {
  trial[0] = 1;
}

std::shared_ptr<const NormalLaw> make_tension_cut_off(const core::Settings& settings,
                                                      core::Mistakes& /*mistakes*/) {
  return std::make_shared<TensionCutOff>(settings.number("tensile_strength"));
}

}  // namespace ashlar::contact
