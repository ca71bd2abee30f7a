// σ = K tr(ε) 1 + 2 G(κ) e,  G(κ) = G₀/(1 + κ/κ½),  κ the greatest γ = √(2 e:e) so far, e the deviator of ε.

#include <cmath>

#include "core/registry.hpp"
#include "model/effect.hpp"
#include "model/material.hpp"

namespace ashlar::degrading {
namespace {

using model::Voigt;

class Degrading final : public model::Material {
 public:
  Degrading(double k, double g, double half) : k_(k), g_(g), half_(half) {}

  bool linear() const override { return false; }
  int internal_variables() const override { return 1; }  // κ

  model::Response respond(const Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const override {
    const double volume = strain[0] + strain[1] + strain[3];
    const Voigt e{strain[0] - volume / 3, strain[1] - volume / 3, strain[2] / 2, strain[3] - volume / 3};
    const double gamma = std::sqrt(2 * (e[0] * e[0] + e[1] * e[1] + 2 * e[2] * e[2] + e[3] * e[3]));
    const bool loading = gamma > committed[0];
    trial[0] = loading ? gamma : committed[0];
    const double g = g_ / (1 + trial[0] / half_);

    model::Response response;
    // ∂G/∂ε_j = −G₀/κ½ (1 + κ/κ½)⁻² 2 e_j/κ while loading
    const double softening = loading ? -4 * g * g / (g_ * half_ * gamma) : 0;
    for (std::size_t i = 0; i < 4; ++i) {
      response.stress[i] = 2 * g * e[i] + (i == 2 ? 0 : k_ * volume);
      for (std::size_t j = 0; j < 4; ++j) {
        const double direct = i == 2 || j == 2 ? (i == j ? g : 0) : k_ - 2 * g / 3 + (i == j ? 2 * g : 0);
        response.tangent[4 * i + j] = direct + softening * e[i] * e[j];
      }
    }
    return response;
  }

  double unit_weight(double) const override { return -1; }
  double shear_modulus() const override { return g_; }
  double plane_modulus() const override { return 4 * g_ * (k_ + g_ / 3) / (k_ + 4 * g_ / 3); }

 private:
  double k_, g_, half_;
};

std::shared_ptr<const model::Material> make(const core::Settings& settings, model::Plane plane,
                                            core::Mistakes& mistakes) {
  if (plane == model::Plane::stress) {
    mistakes.add(settings.place, "this law is for plane strain");
    return nullptr;
  }
  return std::make_shared<Degrading>(settings.number("K"), settings.number("G"), settings.number("half"));
}

/// Named in the plan; the forces are those of elasticity.
class Degradation final : public model::Effect {
 public:
  void contribute(const model::StageContext&, model::Terms&) override {}
};

}  // namespace
}  // namespace ashlar::degrading

ASHLAR_MODULE(registry) {
  using namespace ashlar;
  registry.add_make("material", "degrading", std::function<model::MakeMaterial>(degrading::make));
  registry.add_make("effect", "degradation", std::function<model::MakeEffect>([](core::Registry&) {
                      return std::make_unique<degrading::Degradation>();
                    }));
}
