#include "contact/friction/coulomb/coulomb.hpp"

#include <algorithm>
#include <cmath>

#include "core/readings.hpp"

namespace ashlar::contact {

namespace {

/// How far the strength has fallen, 0 to 1, and its derivative.
struct Softening {
  double share = 0, by_path = 0;
};

Softening softening(double path, double over) {
  if (path < 0) return {0, 0};
  if (path >= over) return {over > 0 || path > 0 ? 1.0 : 0.0, 0};
  return {path / over, 1 / over};
}

}  // namespace

// f = c + μ p,  (c, μ) = peak + w (residual − peak),  w = path/softening_slip up to 1
Strength Coulomb::strength(double pressure, double path) const {
  const Softening w = softening(path, data_.softening_slip);
  const double fall_c = data_.residual_cohesion - data_.cohesion;
  const double fall_mu = data_.residual_friction - data_.friction;
  const double mu = data_.friction + w.share * fall_mu;
  const double f = data_.cohesion + w.share * fall_c + mu * pressure;
  if (f < 0) return {};
  return {f, mu, w.by_path * (fall_c + fall_mu * pressure)};
}

// D(γ) = tan ψ γ_c (1 − e^(−γ/γ_c)), d = D(to) − D(from)
Dilation Coulomb::dilation(double /*pressure*/, double from, double to) const {
  const double slip = data_.dilation_slip;
  if (std::isinf(slip)) return {data_.dilation * (to - from), 0, data_.dilation};
  const double before = std::exp(-from / slip), after = std::exp(-to / slip);
  return {data_.dilation * slip * (before - after), 0, data_.dilation * after};
}

namespace {

/// The residual value: as the peak if it is not said; above it, a mistake.
double residual(const core::Settings& settings, const char* key, double said, double peak,
                core::Mistakes& mistakes) {
  if (said > peak)
    mistakes.add(settings.place_of(key), "must not exceed the peak value",
                 "slip can only weaken the joint; leave it out to keep the peak");
  return std::min(said, peak);
}

void check_slips(const core::Settings& settings, core::Mistakes& mistakes) {
  const bool falls = settings.said("residual_friction_angle") || settings.said("residual_cohesion");
  if (falls && !settings.said("softening_slip"))
    mistakes.add(settings.place, "does not say the slip over which the strength falls to its residual value",
                 "softening_slip = 5*units.mm, or 0: at once");
  if (!falls && settings.said("softening_slip"))
    mistakes.add(settings.place_of("softening_slip"),
                 "there is no residual value for the strength to fall to",
                 "say residual_friction_angle or residual_cohesion too");
  if (settings.said("dilation_slip") && !settings.said("dilation_angle"))
    mistakes.add(settings.place_of("dilation_slip"), "there is no dilation to decay",
                 "say dilation_angle too");
}

// Sliding costs energy at any pressure as long as D′(γ) ≤ tan φ(γ). D′ is convex and tan φ a straight line,
// so the ends of the softening tell.
void check_dilation(const Coulomb::Data& data, const core::Settings& settings, core::Mistakes& mistakes) {
  const double left = data.dilation * std::exp(-data.softening_slip / data.dilation_slip);
  if (data.dilation > data.friction)
    mistakes.add(settings.place_of("dilation_angle"),
                 "must not exceed friction_angle: sliding would give energy back",
                 "dilation_angle = friction_angle is the most, 0 slides without opening");
  else if (left > data.residual_friction)
    mistakes.add(settings.place_of("dilation_angle"),
                 "is still above residual_friction_angle once the friction has fallen to it: sliding would "
                 "give energy back",
                 "a smaller dilation_angle, or a dilation_slip that lets it decay sooner");
}

/// An angle of the law, or `otherwise` if it is not said; nothing, and a mistake, if it is out of range.
std::optional<double> angle(const core::Settings& settings, const char* key, double otherwise,
                            core::Mistakes& mistakes) {
  if (!settings.said(key)) return otherwise;
  return core::read_angle(settings, key, {0, 90, true}, mistakes);
}

}  // namespace

std::shared_ptr<const Friction> make_coulomb(const core::Settings& settings, core::Mistakes& mistakes) {
  const std::size_t before = mistakes.list().size();
  const auto phi = angle(settings, "friction_angle", 0, mistakes);
  const auto phi_r = angle(settings, "residual_friction_angle", phi.value_or(0), mistakes);
  const auto psi = angle(settings, "dilation_angle", 0, mistakes);
  if (!phi || !phi_r || !psi) return nullptr;
  Coulomb::Data data;
  data.friction = std::tan(*phi);
  data.residual_friction = std::tan(residual(settings, "residual_friction_angle", *phi_r, *phi, mistakes));
  data.cohesion = settings.number("cohesion");
  data.residual_cohesion =
      residual(settings, "residual_cohesion", settings.number("residual_cohesion", data.cohesion),
               data.cohesion, mistakes);
  data.softening_slip = settings.number("softening_slip", 0);
  data.dilation = std::tan(*psi);
  data.dilation_slip = settings.number("dilation_slip", data.dilation_slip);
  data.stiffness = settings.number("stiffness", data.stiffness);
  check_slips(settings, mistakes);
  check_dilation(data, settings, mistakes);
  if (mistakes.list().size() > before) return nullptr;
  return std::make_shared<Coulomb>(data);
}

}  // namespace ashlar::contact
