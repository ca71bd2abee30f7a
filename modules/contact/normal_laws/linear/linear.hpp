#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// p = −k o; pulls up to the tensile strength, once.
class Linear final : public NormalLaw {
 public:
  /// Stiffness [Pa/m] above 0, tensile strength [Pa] from 0.
  Linear(double stiffness, double tensile_strength)
      : stiffness_(stiffness), tensile_strength_(tensile_strength) {}
  Form form() const override { return Form::compliant; }
  Opening opening(double pressure) const override { return {-pressure / stiffness_, -1 / stiffness_}; }
  double tensile_strength(const Variables& committed) const override;
  void part(Variables& trial) const override;
  std::vector<std::string> variables() const override;

 private:
  double stiffness_, tensile_strength_;
};

/// The maker of kind "normal_law", name "linear".
MakeNormalLaw make_linear;

}  // namespace ashlar::contact
