#include "testing/law_battery.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>

namespace ashlar::testing {

using model::Material;
using model::Response;
using model::Voigt;

namespace {

// On a smooth piece derivatives from the left and from the right differ by the step times the curvature, and
// those of two central steps by its square. More than these shares of the tangent: there is a kink within the
// steps.
constexpr double one_sided_share = 1e-3, two_steps_share = 2e-7;

double greatest(const auto& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// From −1 to 1, the same on every machine.
double uniform(std::mt19937& random) {
  return 2 * (random() + 0.5) / 4294967296.0 - 1;
}

Voigt random_strain(std::mt19937& random, double size) {
  const double length = size * std::pow(10, 1.5 * (uniform(random) - 1));
  Voigt strain{};
  for (double& component : strain) component = length * uniform(random);
  return strain;
}

Voigt plus(Voigt a, const Voigt& b) {
  for (int i = 0; i < 4; ++i) a[i] += b[i];
  return a;
}

Response respond(const Material& law, const LawState& state) {
  std::vector<double> trial(state.committed.size());
  return law.respond(state.strain, state.committed, trial);
}

Voigt stress_near(const Material& law, LawState state, int component, double by) {
  state.strain[component] += by;
  return respond(law, state).stress;
}

std::string text_of(const LawState& state) {
  std::ostringstream text;
  text.precision(17);
  text << "strain";
  for (const double value : state.strain) text << ' ' << value;
  text << ", committed";
  for (const double value : state.committed) text << ' ' << value;
  return text.str();
}

bool finite(const Response& response, const std::vector<double>& variables) {
  const auto sound = [](double value) { return std::isfinite(value); };
  return std::all_of(response.stress.begin(), response.stress.end(), sound) &&
         std::all_of(response.tangent.begin(), response.tangent.end(), sound) &&
         std::all_of(variables.begin(), variables.end(), sound);
}

bool same_bits(const Response& a, const Response& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::equal(a.stress.begin(), a.stress.end(), b.stress.begin(), same) &&
         std::equal(a.tangent.begin(), a.tangent.end(), b.tangent.begin(), same);
}

double asymmetry(const model::Tangent& tangent) {
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) most = std::max(most, std::abs(tangent[4 * i + j] - tangent[4 * j + i]));
  return most / std::max(greatest(tangent), 1e-300);
}

}  // namespace

std::vector<LawState> random_states(const Material& law, int count, double size, unsigned seed,
                                    const Voigt& centre) {
  std::mt19937 random(seed);
  const auto variables = static_cast<std::size_t>(law.internal_variables());
  std::vector<LawState> states;
  for (int i = 0; i < count; ++i) {
    LawState state{plus(centre, random_strain(random, size)), std::vector<double>(variables)};
    if (i % 2 == 1) {
      const Voigt before = plus(centre, random_strain(random, size));
      std::vector<double> trial(variables);
      law.respond(before, state.committed, trial);
      state.committed = trial;
      state.strain = plus(before, random_strain(random, size));
    }
    states.push_back(std::move(state));
  }
  return states;
}

TangentCheck check_tangent(const Material& law, const LawState& state, double step) {
  const model::Tangent tangent = respond(law, state).tangent;
  const double scale = std::max(greatest(tangent), law.shear_modulus());
  const double h = step * greatest(state.strain);
  const Voigt here = respond(law, state).stress;
  TangentCheck check;
  for (int j = 0; j < 4; ++j) {
    const Voigt right = stress_near(law, state, j, h), left = stress_near(law, state, j, -h);
    const Voigt right2 = stress_near(law, state, j, 2 * h), left2 = stress_near(law, state, j, -2 * h);
    for (int i = 0; i < 4; ++i) {
      const double forward = (right[i] - here[i]) / h, backward = (here[i] - left[i]) / h;
      const double near = (right[i] - left[i]) / (2 * h), far = (right2[i] - left2[i]) / (4 * h);
      const double central = (4 * near - far) / 3;
      check.kink = check.kink || std::abs(forward - backward) > one_sided_share * scale ||
                   std::abs(near - far) > two_steps_share * scale;
      check.error = std::max(check.error, std::abs(central - tangent[4 * i + j]) / scale);
    }
  }
  return check;
}

Battery run_battery(const Material& law, const std::vector<LawState>& states, const Label& label) {
  Battery battery;
  for (const LawState& state : states) {
    ++battery.states;
    std::vector<double> trial(state.committed.size());
    const Response first = law.respond(state.strain, state.committed, trial);
    battery.impure += same_bits(first, respond(law, state)) ? 0 : 1;
    battery.not_finite += finite(first, trial) ? 0 : 1;
    if (law.symmetric()) battery.worst_symmetry = std::max(battery.worst_symmetry, asymmetry(first.tangent));
    const TangentCheck check = check_tangent(law, state);
    if (check.kink) {
      ++battery.kinks;
      continue;
    }
    if (label) ++battery.regions[label(state)];
    if (check.error > battery.worst_tangent) {
      battery.worst_tangent = check.error;
      battery.worst_state = text_of(state);
    }
  }
  return battery;
}

Voigt turned_stress(const Voigt& stress, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * stress[0] + s * s * stress[1] - 2 * c * s * stress[2],
          s * s * stress[0] + c * c * stress[1] + 2 * c * s * stress[2],
          c * s * (stress[0] - stress[1]) + (c * c - s * s) * stress[2], stress[3]};
}

Voigt turned_strain(const Voigt& strain, double angle) {
  Voigt tensor = strain;
  tensor[2] /= 2;
  tensor = turned_stress(tensor, angle);
  tensor[2] *= 2;
  return tensor;
}

double objectivity_error(const Material& law, const LawState& state, double angle) {
  LawState other = state;
  other.strain = turned_strain(state.strain, angle);
  if (state.committed.size() >= 4) {
    const Voigt inner{state.committed[0], state.committed[1], state.committed[2], state.committed[3]};
    const Voigt moved = turned_strain(inner, angle);
    std::copy(moved.begin(), moved.end(), other.committed.begin());
  }
  const Voigt expected = turned_stress(respond(law, state).stress, angle), got = respond(law, other).stress;
  double difference = 0;
  for (int i = 0; i < 4; ++i) difference = std::max(difference, std::abs(expected[i] - got[i]));
  return difference;
}

}  // namespace ashlar::testing
