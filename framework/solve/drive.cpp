#include "solve/drive.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ashlar::solve {

using model::Leg;
using model::Voigt;

namespace {

// Steps are halved this often before they are given up.
constexpr int deepest_cut = 8;
constexpr int most_iterations = 40;
// Of the stresses and of what the strains would give elastically: well above rounding, far below any plot.
constexpr double tolerance = 1e-10;
// Directions in which a yielding law has no stiffness are left alone.
constexpr double no_stiffness = 1e-9;

double greatest(const Voigt& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// What one step asks for: a value per component, and which of them are stresses.
struct Target {
  Voigt value{};
  std::vector<int> stresses;
};

class Driver {
 public:
  explicit Driver(const model::Drive& drive) : law_(*drive.material) {
    const auto count = static_cast<std::size_t>(law_.internal_variables());
    at_.variables.resize(count);
    trial_.resize(count);
    at_.stress = law_.respond(at_.strain, at_.variables, trial_).stress;
  }

  const DrivePoint& at() const { return at_; }

  /// Goes to the target in one step, or in halves where that fails. False leaves the last good point.
  bool go(const Target& target, int cut = 0) {
    if (meet(target)) return true;
    if (cut == deepest_cut) return false;
    Target half = target;
    for (int i = 0; i < 4; ++i) half.value[i] = (here(target, i) + target.value[i]) / 2;
    return go(half, cut + 1) && go(target, cut + 1);
  }

  void name(int leg, int step) {
    at_.leg = leg, at_.step = step;
    at_.iterations = iterations_;
    iterations_ = 0;
  }

 private:
  double here(const Target& target, int component) const {
    const bool stress =
        std::find(target.stresses.begin(), target.stresses.end(), component) != target.stresses.end();
    return stress ? at_.stress[component] : at_.strain[component];
  }

  Eigen::VectorXd residual(const Target& target, const model::Response& response) const {
    Eigen::VectorXd r(target.stresses.size());
    for (Eigen::Index i = 0; i < r.size(); ++i)
      r[i] = response.stress[target.stresses[i]] - target.value[target.stresses[i]];
    return r;
  }

  Eigen::VectorXd correction(const Target& target, const model::Response& response,
                             const Eigen::VectorXd& r) const {
    Eigen::MatrixXd k(r.size(), r.size());
    for (Eigen::Index i = 0; i < r.size(); ++i)
      for (Eigen::Index j = 0; j < r.size(); ++j)
        k(i, j) = response.tangent[4 * target.stresses[i] + target.stresses[j]];
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(no_stiffness);
    return solver.compute(k).solve(-r);
  }

  bool meet(const Target& target) {
    Voigt strain = target.value;
    for (const int i : target.stresses) strain[i] = at_.strain[i];
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      ++iterations_;
      const model::Response response = law_.respond(strain, at_.variables, trial_);
      const Eigen::VectorXd r = residual(target, response);
      if (!r.allFinite()) return false;
      const double scale = std::max(greatest(response.stress), law_.shear_modulus() * greatest(strain));
      if (r.size() == 0 || r.cwiseAbs().maxCoeff() <= tolerance * scale) {
        at_.strain = strain;
        at_.stress = response.stress;
        at_.variables = trial_;
        return true;
      }
      const Eigen::VectorXd step = correction(target, response, r);
      for (Eigen::Index i = 0; i < r.size(); ++i) strain[target.stresses[i]] += step[i];
    }
    return false;
  }

  const model::Material& law_;
  DrivePoint at_;
  std::vector<double> trial_;
  int iterations_ = 0;
};

Target target_of(const Leg& leg, const DrivePoint& from, double share) {
  Target target;
  for (int i = 0; i < 4; ++i) {
    const bool stress = leg.stress[i].has_value();
    const double start = stress ? from.stress[i] : from.strain[i];
    const double end = stress ? *leg.stress[i] : leg.strain[i].value_or(start);
    target.value[i] = share == 1 ? end : start + share * (end - start);
    if (stress) target.stresses.push_back(i);
  }
  return target;
}

Target target_of(const model::Drive& drive, double t) {
  const double arguments[] = {t};
  const std::vector<double> values = drive.path->call(arguments);
  if (values.size() != 3 && values.size() != 4)
    throw core::InputError(
        core::Mistake{drive.path_place,
                      "the path's function must return the strains xx, yy, xy and perhaps zz; it "
                      "returns " +
                          std::to_string(values.size()) + " values",
                      "return xx, yy, xy"});
  Target target;
  std::copy(values.begin(), values.end(), target.value.begin());
  return target;
}

}  // namespace

DriveResult drive(const model::Drive& drive) {
  Driver driver(drive);
  DriveResult result;
  result.points.push_back(driver.at());
  const int legs = drive.path ? 1 : static_cast<int>(drive.legs.size());
  for (int leg = 1; leg <= legs; ++leg) {
    const DrivePoint from = driver.at();
    for (int step = 1; step <= drive.steps; ++step) {
      const double share = static_cast<double>(step) / drive.steps;
      const Target target =
          drive.path ? target_of(drive, share) : target_of(drive.legs[leg - 1], from, share);
      result.converged = driver.go(target);
      if (!result.converged) {
        result.reason = "leg " + std::to_string(leg) + ", step " + std::to_string(step) + " of " +
                        std::to_string(drive.steps) + ": the law finds no strain for the stress asked for";
        return result;
      }
      driver.name(leg, step);
      result.points.push_back(driver.at());
    }
  }
  return result;
}

}  // namespace ashlar::solve
