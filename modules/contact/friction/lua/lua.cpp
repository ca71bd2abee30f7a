#include "contact/friction/lua/lua.hpp"

#include <algorithm>

#include "core/readings.hpp"

namespace ashlar::contact {

namespace {

// Below these pressures [Pa] and slips [m] count as none.
constexpr double least_pressure = 1, least_path = 1e-6;

/// Value and slopes of a function of pressure and path, both held at 0 or above.
struct Sample {
  double value = 0, by_pressure = 0, by_path = 0;
};

Neighbours held(Neighbours beside) {
  beside.left = std::max(beside.left, 0.0);
  return beside;
}

Sample sample(const LuaFunction& function, double pressure, double path) {
  const double p = std::max(pressure, 0.0), s = std::max(path, 0.0);
  Sample sample{function({p, s}), 0, 0};
  if (pressure >= 0) {
    const Neighbours by = held(neighbours(p, least_pressure));
    sample.by_pressure = by.slope(function({by.left, s}), function({by.right, s}));
  }
  if (path >= 0) {
    const Neighbours by = held(neighbours(s, least_path));
    sample.by_path = by.slope(function({p, by.left}), function({p, by.right}));
  }
  return sample;
}

std::string at_text(double pressure, double path) {
  return "at a pressure of " + core::format_quantity(pressure, core::parse_dimension("Pa")) +
         " and a slip of " + core::format_quantity(path, core::parse_dimension("m"));
}

// Work of a slip Δ: f Δ against p d; more of the second than of the first would come from nowhere.
void try_out(const LuaFriction::Data& data, const core::Settings& settings, core::Mistakes& mistakes) {
  constexpr double rounding = 1e-6;
  for (const double pressure : {0.0, 1e3, 1e6, 1e8})
    for (const double path : {0.0, 1e-3, 1e-1}) {
      const double strength = data.strength({pressure, path});
      if (strength < 0) {
        mistakes.add(settings.place_of("strength"), "must not be negative, but is " + at_text(pressure, path),
                     "math.max(0, …)");
        return;
      }
      if (!data.dilation) continue;
      const double gained = pressure * sample(data.dilation, pressure, path).by_path;
      if (gained <= strength * (1 + rounding)) continue;
      mistakes.add(settings.place_of("dilation"),
                   "opens the lips by more than the shear pays for " + at_text(pressure, path) +
                       ": sliding would give energy back",
                   "opening for slip must stay below strength/pressure");
      return;
    }
}

}  // namespace

Strength LuaFriction::strength(double pressure, double path) const {
  const Sample f = sample(data_.strength, pressure, path);
  if (f.value < 0) return {};
  return {f.value, f.by_pressure, f.by_path};
}

Dilation LuaFriction::dilation(double pressure, double from, double to) const {
  if (!data_.dilation) return {};
  const Sample before = sample(data_.dilation, pressure, from), after = sample(data_.dilation, pressure, to);
  return {after.value - before.value, after.by_pressure - before.by_pressure, after.by_path};
}

std::shared_ptr<const Friction> make_lua_friction(const core::Settings& settings, core::Mistakes& mistakes) {
  const std::size_t before = mistakes.list().size();
  const core::NumberTable parameters = core::read_numbers(settings, "parameters", mistakes);
  LuaFriction::Data data{{settings.value("strength").function(), parameters},
                         {settings.value("dilation").function(), parameters}};
  data.stiffness = settings.number("stiffness", data.stiffness);
  if (!data.strength || mistakes.list().size() > before) return nullptr;
  try {
    try_out(data, settings, mistakes);
    if (mistakes.list().size() == before) return std::make_shared<LuaFriction>(std::move(data));
  } catch (const core::InputError& error) {
    mistakes.add(error);
  }
  return nullptr;
}

}  // namespace ashlar::contact
