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

double LuaNormal::asked(double opening, const Variables& committed, Variables& trial) const {
  if (variables_ == 0) return pressure_({opening});
  const auto count = static_cast<std::size_t>(variables_);
  return pressure_({opening}, std::span(committed).first(count), std::span(trial).first(count));
}

Pressure LuaNormal::pressure(double opening, const Variables& committed, Variables& trial) const {
  const Neighbours beside = neighbours(opening, least);
  Variables unused{};
  const double left = asked(beside.left, committed, unused), right = asked(beside.right, committed, unused);
  return {asked(opening, committed, trial), beside.slope(left, right)};
}

std::vector<std::string> LuaNormal::variables() const {
  std::vector<std::string> names;
  for (int i = 1; i <= variables_; ++i) names.push_back("state " + std::to_string(i));
  return names;
}

std::shared_ptr<const NormalLaw> make_lua_normal(const core::Settings& settings, core::Mistakes& mistakes) {
  const std::size_t before = mistakes.list().size();
  const core::NumberTable parameters = core::read_numbers(settings, "parameters", mistakes);
  const auto function = settings.value("pressure").function();
  if (!function || !settings.has("variables") || mistakes.list().size() > before) return nullptr;
  try {
    auto law = std::make_shared<LuaNormal>(LuaFunction(function, parameters), settings.integer("variables"));
    try_out(*law, settings, mistakes);
    if (mistakes.list().size() == before) return law;
  } catch (const core::InputError& error) {
    mistakes.add(error);
  }
  return nullptr;
}

}  // namespace ashlar::contact
