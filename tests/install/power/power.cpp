// f = A (p/1 MPa)^b/(1 + γ/γ½),  γ the slip travelled

#include <algorithm>
#include <cmath>

#include "contact/joint_law.hpp"
#include "core/registry.hpp"

namespace ashlar::power {
namespace {

class Power final : public contact::Friction {
 public:
  Power(double a, double b, double half) : a_(a), b_(b), half_(half) {}

  contact::Strength strength(double pressure, double path) const override {
    if (pressure <= 0) return {};
    const double worn = 1 + std::max(path, 0.0) / half_;
    const double f = a_ * std::pow(pressure / 1e6, b_) / worn;
    return {f, b_ * f / pressure, path < 0 ? 0 : -f / (worn * half_)};
  }

 private:
  double a_, b_, half_;
};

std::shared_ptr<const contact::Friction> make(const core::Settings& settings, core::Mistakes&) {
  return std::make_shared<Power>(settings.number("A"), settings.number("b"), settings.number("wear"));
}

}  // namespace
}  // namespace ashlar::power

ASHLAR_MODULE(registry) {
  using namespace ashlar;
  registry.add_make("friction", "power", std::function<contact::MakeFriction>(power::make));
}
