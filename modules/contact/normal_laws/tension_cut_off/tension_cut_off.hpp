#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// Rigid lips that hang together until they are pulled apart, once.
class TensionCutOff final : public NormalLaw {
 public:
  /// Above 0 [Pa].
  explicit TensionCutOff(double tensile_strength) : tensile_strength_(tensile_strength) {}
  Form form() const override { return Form::rigid; }
  double tensile_strength(const Variables& committed) const override;
  void part(Variables& trial) const override;
  std::vector<std::string> variables() const override { return {"broken"}; }

 private:
  double tensile_strength_;
};

/// The maker of kind "normal_law", name "tension_cut_off".
MakeNormalLaw make_tension_cut_off;

}  // namespace ashlar::contact
