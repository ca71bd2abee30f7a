#include "contact/friction/barton_bandis/barton_bandis.hpp"

#include <cmath>
#include <numbers>

#include "core/readings.hpp"

namespace ashlar::contact {

namespace {

constexpr double degree = std::numbers::pi / 180;
// Without a bound the angle would pass 90° as the pressure goes to nothing.
constexpr double greatest_angle = 70 * degree;

double squared_secant(double angle) {
  const double tangent = std::tan(angle);
  return 1 + tangent * tangent;
}

}  // namespace

// i = JRC log₁₀(JCS/p) in degrees, from 0 (at p = JCS) to 70° − φ_r;  p di/dp = −JRC/ln 10
BartonBandis::Roughness BartonBandis::roughness(double pressure) const {
  const double most = greatest_angle - data_.residual_angle;
  if (pressure <= 0) return {most, 0};
  const double angle = data_.jrc * degree * std::log10(data_.jcs / pressure);
  if (angle >= most) return {most, 0};
  if (angle <= 0) return {0, 0};
  return {angle, -data_.jrc * degree / std::numbers::ln10};
}

// f = p tan α,  df/dp = tan α + (1 + tan²α) p dα/dp,  α = φ_r + i
Strength BartonBandis::strength(double pressure, double /*path*/) const {
  if (pressure < 0) return {};
  const Roughness i = roughness(pressure);
  const double angle = data_.residual_angle + i.angle;
  return {pressure * std::tan(angle), std::tan(angle) + squared_secant(angle) * i.by_pressure, 0};
}

// d = tan(i/2) (to − from)
Dilation BartonBandis::dilation(double pressure, double from, double to) const {
  if (!data_.dilation) return {};
  const Roughness i = roughness(pressure);
  const double tangent = std::tan(i.angle / 2), length = to - from;
  const double by_pressure =
      pressure > 0 ? squared_secant(i.angle / 2) * i.by_pressure / (2 * pressure) * length : 0;
  return {tangent * length, by_pressure, tangent};
}

std::shared_ptr<const Friction> make_barton_bandis(const core::Settings& settings, core::Mistakes& mistakes) {
  const auto angle =
      core::read_angle(settings, "residual_angle", {0, greatest_angle / degree, true}, mistakes);
  if (!angle) return nullptr;
  BartonBandis::Data data;
  data.jrc = settings.number("JRC");
  data.jcs = settings.number("JCS");
  data.residual_angle = *angle;
  data.dilation = settings.flag("dilation");
  data.stiffness = settings.number("stiffness", data.stiffness);
  return std::make_shared<BartonBandis>(data);
}

}  // namespace ashlar::contact
