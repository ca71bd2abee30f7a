#pragma once
// The laws that every test of this folder goes through, and small ways to make them.

#include <cmath>
#include <numbers>

#include "contact/friction/barton_bandis/barton_bandis.hpp"
#include "contact/friction/coulomb/coulomb.hpp"
#include "contact/friction/lua/lua.hpp"
#include "contact/friction/none/none.hpp"
#include "contact/normal_laws/barton_bandis/barton_bandis.hpp"
#include "contact/normal_laws/cohesive/cohesive.hpp"
#include "contact/normal_laws/linear/linear.hpp"
#include "contact/normal_laws/lua/lua.hpp"
#include "contact/normal_laws/tension_cut_off/tension_cut_off.hpp"
#include "contact/normal_laws/unilateral/unilateral.hpp"

namespace ashlar::test {

using namespace contact;

constexpr double degree = std::numbers::pi / 180;

/// Stands for a function of the script.
class NumberFunction final : public core::Function {
 public:
  using F = std::function<double(std::span<const double>)>;
  explicit NumberFunction(F f) : f_(std::move(f)) {}
  std::vector<double> call(std::span<const double>) const override { return {}; }
  void call_tables(std::span<const core::NumberTable> arguments,
                   std::span<core::NumberTable> results) const override {
    std::vector<double> numbers;
    for (const core::NumberTable& each : arguments.first(arguments.size() - 1))
      numbers.push_back(each.values.at(0));
    results[0].values[0] = f_(numbers);
  }

 private:
  F f_;
};
inline LuaFunction number_function(NumberFunction::F f) {
  return {std::make_shared<NumberFunction>(std::move(f)), {}};
}

inline JointLaw joint(std::shared_ptr<const NormalLaw> normal, std::shared_ptr<const Friction> friction) {
  return {std::move(normal), std::move(friction)};
}

inline Coulomb::Data coulomb_data(double mu, double cohesion = 0) {
  Coulomb::Data data;
  data.friction = data.residual_friction = mu;
  data.cohesion = data.residual_cohesion = cohesion;
  return data;
}
inline std::shared_ptr<const Friction> coulomb(double mu, double cohesion = 0) {
  return std::make_shared<Coulomb>(coulomb_data(mu, cohesion));
}
inline std::shared_ptr<const Friction> softening_coulomb(double stiffness) {
  Coulomb::Data data = coulomb_data(0.8, 3e5);
  data.residual_friction = 0.5;
  data.residual_cohesion = 1e5;
  data.softening_slip = 4e-3;
  data.dilation = std::tan(8 * degree);
  data.dilation_slip = 6e-3;
  data.stiffness = stiffness;
  return std::make_shared<Coulomb>(data);
}
inline BartonBandis::Data barton_data(bool dilation = false) {
  return {10, 100e6, 30 * degree, dilation, INFINITY};
}

struct Named {
  std::string name;
  JointLaw law;
};

/// Every normal law with every friction law.
inline std::vector<Named> all_laws() {
  const std::vector<std::pair<std::string, std::shared_ptr<const NormalLaw>>> normals = {
      {"rigid", std::make_shared<Unilateral>()},
      {"linear", std::make_shared<Linear>(20e9, 0)},
      {"linear with tension", std::make_shared<Linear>(20e9, 5e5)},
      {"tension_cut_off", std::make_shared<TensionCutOff>(5e5)},
      {"barton_bandis", std::make_shared<BartonBandisClosure>(10e9, 2e-4)},
      {"cohesive", std::make_shared<Cohesive>(Cohesive::Data{1e11, 1e6, 100})},
      {"lua", std::make_shared<LuaNormal>(number_function(
                  [](std::span<const double> a) { return a[0] < 0 ? 2e14 * std::pow(-a[0], 1.5) : 0; }))}};
  LuaFriction::Data power{
      number_function([](std::span<const double> a) {
        return 3e3 * std::pow(a[0], 0.7) * (1 + 0.2 * std::exp(-a[1] / 1e-3));
      }),
      number_function([](std::span<const double> a) { return 0.1 * a[1] / (1 + a[0] / 1e7); })};
  const std::vector<std::pair<std::string, std::shared_ptr<const Friction>>> frictions = {
      {"none", std::make_shared<Frictionless>()},
      {"coulomb", coulomb(0.6, 2e5)},
      {"softening", softening_coulomb(INFINITY)},
      {"softening with stiffness", softening_coulomb(30e9)},
      {"barton_bandis", std::make_shared<BartonBandis>(barton_data(true))},
      {"lua", std::make_shared<LuaFriction>(power)}};
  std::vector<Named> laws;
  for (const auto& [normal, n] : normals)
    for (const auto& [friction, f] : frictions) laws.push_back({normal + " with " + friction, {n, f}});
  return laws;
}

}  // namespace ashlar::test
