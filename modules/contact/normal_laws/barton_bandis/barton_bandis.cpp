#include "contact/normal_laws/barton_bandis/barton_bandis.hpp"

namespace ashlar::contact {

// c = p V/(k V + p),  dc/dp = k V²/(k V + p)²,  both smooth into the line c = p/k at p = 0
Opening BartonBandisClosure::opening(double pressure) const {
  const double k = stiffness_, v = greatest_closure_;
  if (pressure <= 0) return {-pressure / k, -1 / k};
  const double sum = k * v + pressure;
  return {-pressure * v / sum, -k * v * v / (sum * sum)};
}

std::shared_ptr<const NormalLaw> make_barton_bandis_closure(const core::Settings& settings,
                                                            core::Mistakes& /*mistakes*/) {
  return std::make_shared<BartonBandisClosure>(settings.number("stiffness"),
                                               settings.number("greatest_closure"));
}

}  // namespace ashlar::contact
