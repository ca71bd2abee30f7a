// Linear solves that go wrong: refined, or refused with the reason.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "stability/hard_meshes.hpp"
#include "stability/patch_run.hpp"
#include "stability/scene_file.hpp"
#include "testing/meshes.hpp"

namespace ashlar::stability {

namespace {

/// Another solver's solutions, off by a share of themselves that changes from unknown to unknown.
class Careless final : public algebra::LinearSolver {
 public:
  Careless(std::unique_ptr<algebra::LinearSolver> sound, double share)
      : sound_(std::move(sound)), share_(share) {}
  void analyse(const algebra::SymmetricPattern& pattern, std::span<const Index> kept,
               std::span<const Index> node) override {
    sound_->analyse(pattern, kept, node);
  }
  algebra::FactorReport factor(const algebra::SymmetricMatrix& matrix) override {
    return sound_->factor(matrix);
  }
  void solve(std::span<const double> b, std::span<double> x) const override {
    sound_->solve(b, x);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= 1 + share_ * std::sin(static_cast<double>(i));
  }
  const Eigen::MatrixXd& schur() const override { return sound_->schur(); }
  Eigen::VectorXd condense(std::span<const double> b, std::vector<double>& work) const override {
    return sound_->condense(b, work);
  }
  void expand(const std::vector<double>& work, const Eigen::VectorXd& kept,
              std::span<double> x) const override {
    sound_->expand(work, kept, x);
  }
  std::size_t bytes() const override { return sound_->bytes(); }

 private:
  std::unique_ptr<algebra::LinearSolver> sound_;
  double share_;
};

solve::StepReport carelessly_solved(int order, double share, Fault fault, double& error) {
  const mesh::Mesh mesh = bare(testing::distorted_square(8));
  const double mu = 1e9, nu = 0.3;
  const auto law = std::make_shared<elasticity::Elastic>(2 * mu * (1 + nu), nu, model::Plane::strain);
  patch::Solid solid(mesh, law, with_fault(element_of(order), fault, mesh));
  const patch::Exact exact = patch::kolosov(order, mu, nu, model::Plane::strain);
  solid.hold_border(exact.displacement);
  solid.wrap = [share](auto sound) { return std::make_unique<Careless>(std::move(sound), share); };
  if (solid.solve().empty()) throw std::runtime_error(solid.failure);
  error = patch::errors(solid, exact).displacement;
  return solid.report;
}

Case refined_row() {
  Case row;
  row.group = "Solves";
  row.name = "a solver that is off by a thousandth";
  row.risk = "a poor solution passed on";
  row.bound = "refined to a backward error of 1e-14, and so to the patch test's bounds";
  row.plants = {Fault::mismatched_tangent};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order) {
      double error = 0;
      const solve::StepReport report = carelessly_solved(order, 1e-3, fault, error);
      if (!report.converged) outcome.missing.push_back(report.reason);
      outcome.worst("order " + std::to_string(order) + " backward", report.backward_error, 1e-14);
      outcome.worst("order " + std::to_string(order) + " u", error, patch_bound(order));
    }
    return outcome;
  };
  return row;
}

Case refused_row() {
  Case row;
  row.group = "Solves";
  row.name = "a solver that is off by half";
  row.risk = "a wrong solution passed on";
  row.bound =
      "refused: refinement gains less than a digit in three rounds, and the backward error stays above 1e-9";
  row.plants = {Fault::cured};
  row.run = [](Fault fault) {
    Outcome outcome;
    double error = 0;
    const solve::StepReport report =
        carelessly_solved(1, fault == Fault::cured ? 0 : 0.5, Fault::none, error);
    outcome.must_say(report.reason + "; " + report.advice,
                     {"badly conditioned", "backward error", "moduli that differ less"});
    if (report.converged) outcome.missing.push_back("passed on");
    return outcome;
  };
  return row;
}

MakeSolver careless(double share) {
  return [share] {
    return std::make_unique<Careless>(std::make_unique<suitesparse::Cholesky>(suitesparse::Method::automatic),
                                      share);
  };
}

test::ParameterValues associated(int order) {
  return {{"order", std::to_string(order)}, {"dilation", "0.5"}};
}

Case newton_refined_row() {
  Case row;
  row.group = "Solves";
  row.name = "a solver that is off by a thousandth, inside Newton's iteration";
  row.risk = "a poor correction hides as slow convergence";
  row.bound =
      "refined to a backward error of 1e-14: as many iterations as with a good solver, displacements within "
      "1e-9, "
      "as Newton ends at 1e-10";
  row.plants = {Fault::wrong_sign};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order) {
      const auto sound = run_scene("pushed_soil", associated(order), Fault::none);
      const auto poor = run_scene("pushed_soil", associated(order), fault, careless(1e-3));
      const std::string name = "order " + std::to_string(order);
      outcome.worst(name + " backward", worst_backward_error(poor.result), 1e-14);
      outcome.worst(name + " u",
                    relative_difference(values(poor.stage("push"), "displacement"),
                                        values(sound.stage("push"), "displacement")),
                    1e-9);
      if (poor.stage("push").iterations.size() != sound.stage("push").iterations.size())
        outcome.missing.push_back(name + ": another number of iterations");
    }
    return outcome;
  };
  return row;
}

Case newton_refused_row() {
  Case row;
  row.group = "Solves";
  row.name = "a solver that is off by half, inside Newton's iteration";
  row.risk = "a wrong correction passed on";
  row.bound = "refused, as in a linear stage, and the place is named";
  row.plants = {Fault::cured};
  row.run = [](Fault fault) {
    Outcome outcome;
    const std::string said =
        stopped_by("pushed_soil", associated(1), Fault::none, careless(fault == Fault::cured ? 0 : 0.5));
    outcome.must_say(said,
                     {"stage 'weight' did not converge", "badly conditioned", "moduli that differ less"});
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> solve_rows() {
  return {refined_row(), refused_row(), newton_refined_row(), newton_refused_row()};
}

}  // namespace ashlar::stability
