#include "contact/normal_laws/cohesive/cohesive.hpp"

#include <algorithm>

namespace ashlar::contact {

// t(o) = k₀ o up to o₀, then T (o_f − o)/(o_f − o₀), and nothing beyond o_f
double Cohesive::envelope(double opening) const {
  if (opening <= start()) return data_.stiffness * opening;
  return std::max(0.0, data_.tensile_strength * (end() - opening) / (end() - start()));
}

// κ: greatest opening so far.  o ≥ κ: p = −t(o);  0 ≤ o < κ: p = −o t(κ)/κ;  o < 0: p = −k₀ o
Pressure Cohesive::pressure(double opening, const Variables& committed, Variables& trial) const {
  const double greatest = committed[0];
  trial[0] = std::max(greatest, opening);
  if (opening <= 0 || std::max(greatest, opening) <= start())
    return {-data_.stiffness * opening, -data_.stiffness};
  if (opening < greatest) {
    const double secant = envelope(greatest) / greatest;
    return {-secant * opening, -secant};
  }
  if (opening >= end()) return {0, 0};
  return {-envelope(opening), data_.tensile_strength / (end() - start())};
}

double Cohesive::tensile_strength(const Variables& committed) const {
  return committed[0] <= start() ? data_.tensile_strength : envelope(committed[0]);
}

std::shared_ptr<const NormalLaw> make_cohesive(const core::Settings& settings, core::Mistakes& mistakes) {
  const Cohesive::Data data{settings.number("stiffness"), settings.number("tensile_strength"),
                            settings.number("fracture_energy")};
  const double least = data.tensile_strength * data.tensile_strength / (2 * data.stiffness);
  if (data.fracture_energy > least) return std::make_shared<Cohesive>(data);
  const auto quantity = [](double value, const char* unit) {
    return core::format_quantity(value, core::parse_dimension(unit));
  };
  mistakes.add(
      settings.place_of("fracture_energy"),
      "must exceed tensile_strength^2/(2 stiffness) = " + quantity(least, "N/m") +
          ", which the joint stores before it begins to tear, got " + quantity(data.fracture_energy, "N/m"),
      "more energy, or a stiffness above " +
          quantity(data.tensile_strength * data.tensile_strength / (2 * data.fracture_energy), "Pa/m"));
  return nullptr;
}

}  // namespace ashlar::contact
