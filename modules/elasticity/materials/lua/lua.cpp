#include "elasticity/materials/lua/lua.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace ashlar::elasticity {

using model::Plane;
using model::Voigt;

namespace {

// Steps of differences: the cube root of rounding balances it against curvature. Below `least` a strain
// counts as none.
constexpr double step = 6e-6, least = 1e-4;
// Differences carry about ten digits; a tangent that is unsymmetric on purpose differs by far more.
constexpr double unsymmetric = 1e-5;

std::mutex& one_call_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

double greatest(const auto& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double asymmetry(const model::Tangent& d) {
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) most = std::max(most, std::abs(d[4 * i + j] - d[4 * j + i]));
  return most / std::max(greatest(d), 1e-300);
}

/// Strains of the size that rock knows, in all directions.
constexpr std::array<Voigt, 5> trials = {{{0, 0, 0, 0},
                                          {1e-4, -3e-5, 5e-5, 0},
                                          {-2e-4, -1e-4, -7e-5, 0},
                                          {-4e-5, 9e-5, 2e-4, 0},
                                          {-1e-3, 4e-4, -6e-4, 0}}};

void try_out(const LuaLaw& law, const core::Settings& settings, core::Mistakes& mistakes) {
  const std::vector<double> committed(static_cast<std::size_t>(law.internal_variables()));
  std::vector<double> trial = committed;
  for (const Voigt& strain : trials) {
    const auto tangent = law.respond(strain, committed, trial).tangent;
    if (!law.symmetric() || asymmetry(tangent) <= unsymmetric) continue;
    mistakes.add(settings.place_of("stress"), "gives an unsymmetric tangent, but symmetry is promised",
                 "say symmetric = false, or derive the stress from an energy");
    return;
  }
  if (law.shear_modulus() > 0 && law.plane_modulus() > 0) return;
  mistakes.add(settings.place_of("stress"), "has no stiffness at no strain: nothing could hold the body",
               "its stress must grow with the strain from the start");
}

}  // namespace

LuaLaw::LuaLaw(LuaLawData data, Plane plane, Weight weight)
    : data_(std::move(data)), plane_(plane), weight_(weight) {
  const std::vector<double> committed(static_cast<std::size_t>(data_.variables));
  std::vector<double> trial = committed;
  const model::Tangent d = respond({}, committed, trial).tangent;
  shear_modulus_ = (d[10] + (d[0] - d[1] - d[4] + d[5]) / 4) / 2;
  plane_modulus_ = d[0] > 0 && d[5] > 0 ? (d[0] * d[5] - d[1] * d[4]) / std::sqrt(d[0] * d[5]) : 0;
}

Voigt LuaLaw::stress(const Voigt& strain, std::span<const double> committed, std::span<double> trial) const {
  static const std::vector<std::string> names = {"xx", "yy", "xy", "zz"};
  const double zz = plane_ == Plane::stress ? 0 : strain[3];
  const std::array<core::NumberTable, 3> arguments = {{{names, {strain[0], strain[1], strain[2], zz}},
                                                       {{}, {committed.begin(), committed.end()}},
                                                       data_.parameters}};
  std::array<core::NumberTable, 2> results = {
      {{names, std::vector<double>(4)}, {{}, {trial.begin(), trial.end()}}}};
  {
    const std::lock_guard lock(one_call_at_a_time());
    data_.stress->call_tables(arguments, results);
  }
  std::copy(results[1].values.begin(), results[1].values.end(), trial.begin());
  const std::vector<double>& s = results[0].values;
  return {s[0], s[1], s[2], plane_ == Plane::stress ? 0 : s[3]};
}

model::Response LuaLaw::respond(const Voigt& strain, std::span<const double> committed,
                                std::span<double> trial) const {
  model::Response response;
  response.stress = stress(strain, committed, trial);
  std::vector<double> unused(trial.size());
  const double h = step * std::max(greatest(strain), least);
  for (int j = 0; j < (plane_ == Plane::stress ? 3 : 4); ++j) {
    Voigt right = strain, left = strain;
    right[j] += h;
    left[j] -= h;
    const Voigt more = stress(right, committed, unused), less = stress(left, committed, unused);
    for (int i = 0; i < 4; ++i) response.tangent[4 * i + j] = (more[i] - less[i]) / (right[j] - left[j]);
  }
  // What differs by rounding only is made the same, so that the solver may rely on it.
  if (!data_.symmetric) return response;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) {
      double &a = response.tangent[4 * i + j], &b = response.tangent[4 * j + i];
      if (std::abs(a - b) <= unsymmetric * greatest(response.tangent)) a = b = (a + b) / 2;
    }
  return response;
}

std::shared_ptr<const model::Material> make_lua_law(const core::Settings& settings, Plane plane,
                                                    core::Mistakes& mistakes) {
  // What is wrong with these was told when they were read.
  if (!settings.has("variables") || !settings.has("symmetric")) return nullptr;
  const std::size_t before = mistakes.list().size();
  LuaLawData data{settings.value("stress").function(), settings.integer("variables"),
                  settings.flag("symmetric"), core::read_numbers(settings, "parameters", mistakes)};
  if (!data.stress || mistakes.list().size() > before) return nullptr;
  try {
    auto law = std::make_shared<LuaLaw>(std::move(data), plane, read_weight(settings));
    try_out(*law, settings, mistakes);
    if (mistakes.list().size() == before) return law;
  } catch (const core::InputError& error) {
    mistakes.add(error);
  }
  return nullptr;
}

}  // namespace ashlar::elasticity
