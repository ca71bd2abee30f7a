#include "elasticity/materials/drucker_prager/drucker_prager.hpp"

#include <Eigen/Core>
#include <cmath>

namespace ashlar::elasticity {

using Eigen::Matrix4d;
using Eigen::Vector4d;
using model::Voigt;

namespace {

/// Mean stress p, deviator s and √J2.
struct Invariants {
  double p, root_j2;
  Vector4d s;
};

Invariants invariants(const Voigt& stress) {
  const double p = (stress[0] + stress[1] + stress[3]) / 3;
  const Vector4d s(stress[0] - p, stress[1] - p, stress[2], stress[3] - p);
  const double j2 = (s[0] * s[0] + s[1] * s[1] + s[3] * s[3]) / 2 + s[2] * s[2];
  return {p, std::sqrt(j2), s};
}

/// What the return finds: Δγ on the cone, or the apex.
struct Flow {
  Invariants trial;
  double excess, multiplier;
  bool apex;
};

Flow flow_of(const Cone& cone, const Isotropic& moduli, const Voigt& trial_stress) {
  const Invariants trial = invariants(trial_stress);
  const double excess = trial.root_j2 + cone.eta * trial.p - cone.kappa;
  const double multiplier = excess / (moduli.mu + moduli.bulk * cone.eta * cone.eta_bar);
  return {trial, excess, multiplier, cone.eta > 0 && moduli.mu * multiplier >= trial.root_j2};
}

const Vector4d identity(1, 1, 0, 1);

model::Response response(const Vector4d& stress, const Matrix4d& tangent) {
  model::Response made;
  Vector4d::Map(made.stress.data()) = stress;
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(made.tangent.data()) = tangent;
  return made;
}

}  // namespace

Cone matched(const FrictionalStrength& strength, Match match) {
  const double sine = strength.sin_friction, cosine = strength.cos_friction;
  if (match == Match::plane_strain) {
    // 3 tan φ/√(9 + 12 tan²φ), written so that φ = 90° is no special case
    const auto eta = [](double s) { return 3 * s / std::sqrt(9 + 3 * s * s); };
    return {eta(sine), eta(strength.sin_dilation),
            3 * strength.cohesion * cosine / std::sqrt(9 + 3 * sine * sine)};
  }
  const double sign = match == Match::outer ? -1 : 1;
  const auto eta = [sign](double s) { return 6 * s / (std::sqrt(3.0) * (3 + sign * s)); };
  return {eta(sine), eta(strength.sin_dilation),
          6 * strength.cohesion * cosine / (std::sqrt(3.0) * (3 + sign * sine))};
}

double DruckerPrager::excess(const Voigt& stress) const {
  const Invariants at = invariants(stress);
  return at.root_j2 + cone_.eta * at.p - cone_.kappa;
}

double DruckerPrager::utilisation(const Voigt& stress) const {
  const Invariants at = invariants(stress);
  return share(at.root_j2, cone_.kappa - cone_.eta * at.p);
}

const char* DruckerPrager::region(const Voigt& strain, std::span<const double> committed) const {
  const Flow flow = flow_of(cone_, moduli(), trial_stress(strain, committed));
  if (flow.excess <= 0) return "elastic";
  return flow.apex ? "apex" : "cone";
}

std::optional<model::Response> DruckerPrager::returned(const Voigt& trial_stress) const {
  const double g = moduli().mu, k = moduli().bulk;
  const Flow flow = flow_of(cone_, moduli(), trial_stress);
  if (flow.excess <= 0) return {};
  if (flow.apex) return response(cone_.kappa / cone_.eta * identity, Matrix4d::Zero());

  // β = 1 − GΔγ/√J2: what is left of the deviator; n its direction, |n| = 1; A = 1/(G + Kηη̄)
  const double beta = std::max(0.0, 1 - g * flow.multiplier / flow.trial.root_j2);
  const Vector4d n = flow.trial.s / (std::sqrt(2.0) * flow.trial.root_j2);
  const double a = 1 / (g + k * cone_.eta * cone_.eta_bar);
  const Vector4d stress =
      beta * flow.trial.s + (flow.trial.p - k * cone_.eta_bar * flow.multiplier) * identity;

  // ds = 2Gβ de + 2G(1 − β) n (n:de) − √2 G n dΔγ,  dp = K dv − K η̄ dΔγ,  dΔγ = A (√2 G n:de + η K dv)
  Matrix4d deviator = Matrix4d::Zero();
  deviator.diagonal() = Vector4d(1, 1, 0.5, 1);
  deviator -= identity * identity.transpose() / 3;
  const Vector4d yield = std::sqrt(2.0) * g * n + cone_.eta * k * identity;
  const Vector4d plastic = std::sqrt(2.0) * g * n + cone_.eta_bar * k * identity;
  const Matrix4d tangent = 2 * g * beta * deviator + 2 * g * (1 - beta) * n * n.transpose() +
                           k * identity * identity.transpose() - a * plastic * yield.transpose();
  return response(stress, tangent);
}

std::shared_ptr<const model::Material> make_drucker_prager(const core::Settings& settings, model::Plane plane,
                                                           core::Mistakes& mistakes) {
  const auto moduli = read_plastic_moduli(settings, plane, mistakes);
  const auto strength = read_frictional_strength(settings, mistakes);
  // A wrong word was told when it was read.
  if (!moduli || !strength || !settings.has("match")) return nullptr;
  const std::string word = settings.text("match");
  const Match match = word == "outer" ? Match::outer : word == "inner" ? Match::inner : Match::plane_strain;
  return std::make_shared<DruckerPrager>(*moduli, matched(*strength, match), read_weight(settings));
}

}  // namespace ashlar::elasticity
