#include "crosscheck/hertz_profile.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace ashlar::test {

namespace {

constexpr double radius = 10, force = 200;                                  // [m], [N/m] on the whole disc
constexpr double soft = 1e3, hard = 1e6, nu = 0.3;                          // [Pa]
constexpr double star = 1 / ((1 - nu * nu) / soft + (1 - nu * nu) / hard);  // E* [Pa]

}  // namespace

double Profile::at(double place) const {
  const auto next = std::upper_bound(x.begin(), x.end(), place);
  if (next == x.begin()) return p.front();
  if (next == x.end()) return place == x.back() ? p.back() : 0;
  const auto i = static_cast<std::size_t>(next - x.begin());
  const double t = (place - x[i - 1]) / (x[i] - x[i - 1]);
  return (1 - t) * p[i - 1] + t * p[i];
}

double Profile::peak() const {
  return *std::max_element(p.begin(), p.end());
}

double Profile::force() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) sum += (x[i + 1] - x[i]) * (p[i] + p[i + 1]) / 2;
  return sum;
}

double hertz_half_width() {
  return std::sqrt(4 * force * radius / (std::numbers::pi * star));
}

double hertz_pressure(double x) {
  const double a = hertz_half_width();
  if (std::abs(x) >= a) return 0;
  return std::sqrt(force * star / (std::numbers::pi * radius)) * std::sqrt(1 - x * x / (a * a));
}

std::filesystem::path hertz_example() {
  return std::filesystem::path(ASHLAR_SOURCE_DIR) / "examples" / "hertz";
}

Profiles stored_reference() {
  const auto file = hertz_example() / "reference.csv";
  std::ifstream in(file);
  Profiles profiles;
  Profile &flat_top = profiles[Loading::flat_top], &pole = profiles[Loading::pole];
  for (std::string line; std::getline(in, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    double x = 0, first = 0, second = 0;
    if (!(words >> x >> first >> second)) continue;
    flat_top.x.push_back(x);
    flat_top.p.push_back(first);
    pole.x.push_back(x);
    pole.p.push_back(second);
  }
  if (flat_top.x.size() < 2) throw std::runtime_error("there is no profile in " + file.string());
  return profiles;
}

void write_reference(std::ostream& out, const Profiles& profiles, double spacing) {
  const Profile &flat_top = profiles.at(Loading::flat_top), &pole = profiles.at(Loading::pole);
  out << "# Contact pressure by CalculiX, CPE8 on rings " << 1000 * spacing
      << " mm apart. Made by: crosscheck hertz " << spacing << '\n'
      << "x [m],flat_top [Pa],pole [Pa]\n";
  for (std::size_t i = 0; i < flat_top.x.size(); ++i) {
    std::ostringstream row;
    row.precision(7);
    row << flat_top.x[i] << ',' << flat_top.p[i] << ',' << pole.p[i] << '\n';
    out << row.str();
  }
}

HertzRun run_hertz(Loading loading, int cells, int order) {
  const SceneRun run = run_scene(
      hertz_example(),
      {{"loading", name_of(loading)}, {"cells", std::to_string(cells)}, {"order", std::to_string(order)}});
  const model::JointResult& joint = run.stage("press").joints.front();
  HertzRun result{{}, joint.max_pressure, run.model.mesh.cell_count()};
  for (const model::JointResult::Row& row : joint.rows) {
    result.profile.x.push_back(row.at.x);
    result.profile.p.push_back(row.pressure);
  }
  return result;
}

Apart apart(const Profile& profile, const Profile& reference) {
  const auto greatest = [&](double from, double to) {
    double result = 0;
    for (std::size_t i = 0; i < profile.x.size(); ++i)
      if (profile.x[i] > from && profile.x[i] <= to)
        result = std::max(result, std::abs(profile.p[i] - reference.at(profile.x[i])));
    return result / reference.peak();
  };
  // A millimetre resolves both; the reference's last point lies beyond the contact.
  double difference = 0, norm = 0;
  for (double x = 0; x < reference.x.back(); x += 1e-3) {
    difference += std::pow(profile.at(x) - reference.at(x), 2);
    norm += std::pow(reference.at(x), 2);
  }
  const double inside = 0.9 * hertz_half_width();
  return {greatest(-1, 1.1), greatest(-1, inside), greatest(inside, INFINITY), std::sqrt(difference / norm)};
}

}  // namespace ashlar::test
