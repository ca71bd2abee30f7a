#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// p = k_ni c/(1 − c/V_m), c = −o the closure. Pulls: p = −k_ni o up to no strength at all.
class BartonBandisClosure final : public NormalLaw {
 public:
  /// Both above 0: [Pa/m] at no pressure, [m].
  BartonBandisClosure(double stiffness, double greatest_closure)
      : stiffness_(stiffness), greatest_closure_(greatest_closure) {}
  Form form() const override { return Form::compliant; }
  Opening opening(double pressure) const override;

 private:
  double stiffness_, greatest_closure_;
};

/// The maker of kind "normal_law", name "barton_bandis".
MakeNormalLaw make_barton_bandis_closure;

}  // namespace ashlar::contact
