// σ = λ tr(ε) 1 + 2 μ ε in plane strain.

#include "core/registry.hpp"
#include "model/material.hpp"

namespace ashlar::lame {
namespace {

class Lame final : public model::Material {
 public:
  Lame(double lambda, double mu) : lambda_(lambda), mu_(mu) {}
  bool linear() const override { return true; }
  model::Response respond(const model::Voigt& strain, std::span<const double>,
                          std::span<double>) const override {
    const double axial = lambda_ + 2 * mu_;
    const double trace = lambda_ * (strain[0] + strain[1] + strain[3]);
    return {
        {trace + 2 * mu_ * strain[0], trace + 2 * mu_ * strain[1], mu_ * strain[2],
         trace + 2 * mu_ * strain[3]},
        {axial, lambda_, 0, lambda_, lambda_, axial, 0, lambda_, 0, 0, mu_, 0, lambda_, lambda_, 0, axial}};
  }
  double unit_weight(double) const override { return -1; }
  double shear_modulus() const override { return mu_; }
  double plane_modulus() const override { return 4 * mu_ * (lambda_ + mu_) / (lambda_ + 2 * mu_); }

 private:
  double lambda_;
  double mu_;
};

std::shared_ptr<const model::Material> make(const core::Settings& settings, model::Plane plane,
                                            core::Mistakes& mistakes) {
  if (plane == model::Plane::stress) {
    mistakes.add(settings.place, "this law is for plane strain");
    return nullptr;
  }
  return std::make_shared<Lame>(settings.number("lambda"), settings.number("mu"));
}

}  // namespace
}  // namespace ashlar::lame

ASHLAR_MODULE(registry) {
  using namespace ashlar;
  registry.add_make("material", "lame", std::function<model::MakeMaterial>(lame::make));
}
