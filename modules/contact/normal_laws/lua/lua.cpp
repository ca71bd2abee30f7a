#include "contact/normal_laws/lua/lua.hpp"

#include "core/readings.hpp"

namespace ashlar::contact {

namespace {

// Openings below this count as none [m].
constexpr double least = 1e-6;

void try_out(const LuaNormal& law, const core::Settings& settings, core::Mistakes& mistakes) {
  Variables none{};
  const auto pressure = [&](double opening) { return law.pressure(opening, {}, none).value; };
  const double closed = pressure(-1e-4), touching = pressure(0), open = pressure(1e-4);
  if (closed > touching && touching >= open) return;
  mistakes.add(settings.place_of("pressure"),
               "must press more the further the lips close, and never more as they open",
               "closure is a negative opening, as in function(opening, p) return -p.k*opening end");
}

}  // namespace

Pressure LuaNormal::pressure(double opening, const Variables& /*committed*/, Variables& /*trial*/) const {
  const Neighbours beside = neighbours(opening, least);
  return {pressure_({opening}), beside.slope(pressure_({beside.left}), pressure_({beside.right}))};
}

std::shared_ptr<const NormalLaw> make_lua_normal(const core::Settings& settings, core::Mistakes& mistakes) {
  const std::size_t before = mistakes.list().size();
  const core::NumberTable parameters = core::read_numbers(settings, "parameters", mistakes);
  const auto function = settings.value("pressure").function();
  if (!function || mistakes.list().size() > before) return nullptr;
  try {
    auto law = std::make_shared<LuaNormal>(LuaFunction(function, parameters));
    try_out(*law, settings, mistakes);
    if (mistakes.list().size() == before) return law;
  } catch (const core::InputError& error) {
    mistakes.add(error);
  }
  return nullptr;
}

}  // namespace ashlar::contact
