#pragma once

#include "contact/joint_law.hpp"

namespace ashlar::contact {

/// Bilinear: pulls grow to T at o₀ = T/k₀, fall to nothing at o_f = 2 G_f/T, and unload to the origin.
class Cohesive final : public NormalLaw {
 public:
  struct Data {
    double stiffness = 0;         ///< k₀ [Pa/m]
    double tensile_strength = 0;  ///< T [Pa]
    double fracture_energy = 0;   ///< G_f [J/m²] above T²/(2 k₀)
  };
  explicit Cohesive(const Data& data) : data_(data) {}
  Form form() const override { return Form::traction; }
  Pressure pressure(double opening, const Variables& committed, Variables& trial) const override;
  double tensile_strength(const Variables& committed) const override;
  std::vector<std::string> variables() const override { return {"greatest_opening"}; }

 private:
  double start() const { return data_.tensile_strength / data_.stiffness; }          ///< o₀
  double end() const { return 2 * data_.fracture_energy / data_.tensile_strength; }  ///< o_f
  double envelope(double opening) const;

  Data data_;
};

/// The maker of kind "normal_law", name "cohesive".
MakeNormalLaw make_cohesive;

}  // namespace ashlar::contact
