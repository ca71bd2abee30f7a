#include "contact/joint_driver.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/laws.hpp"

namespace ashlar::contact {

using model::JointPoint;
using model::JointTarget;

namespace {

constexpr int most_iterations = 60, most_changes = 20;
// Of the unknowns and residuals; far above rounding, far below any plot.
constexpr double tolerance = 1e-9;
// Lips that the laws hold rigid yield by 0.1 nm for each MPa, so that a displacement can lead them too; what
// is reported leaves that out.
constexpr Hold hold{1e-16, 1e-16, 0, 0};

/// A direction across or along the joint: whether its residual is of tractions, and its scale.
struct Row {
  bool traction = false;
  double target = 0;
};

class PointDriver final : public model::JointDriver {
 public:
  PointDriver(JointLaw law, std::string words) : law_(std::move(law)), words_(std::move(words)) {
    report({memory_.status, begin_with(law_, memory_.status, memory_, {0, 0})}, {});
  }

  std::string law() const override { return words_; }
  std::vector<std::string> variables() const override { return law_.normal->variables(); }
  const JointPoint& at() const override { return at_; }

  // The status that it has is tried first: where two would do, it stays. Last from closed lips, as torn ones
  // have no slope to follow.
  bool go(const JointTarget& target) override {
    iterations_ = 0;
    const Eigen::Vector2d closed(memory_.dilation, jump_[1]);
    for (const auto& [status, from] : {std::pair{memory_.status, jump_},
                                       {Status::stick, jump_},
                                       {Status::open, jump_},
                                       {Status::stick, closed}})
      if (const auto found = settle(target, status, from)) {
        const PointResponse response = respond(law_, {}, memory_, found->status, found->unknowns);
        const PointMemory next = remember(law_, hold, memory_, found->status, found->unknowns);
        jump_ = response.jump;
        memory_ = next;
        report(*found, response);
        follow(target);
        return true;
      }
    return false;
  }

 private:
  struct Found {
    Status status;
    Unknowns unknowns;
  };

  void report(const Found& found, const PointResponse& response) {
    static constexpr std::array words = {"open", "stick", "slip", "slip"};
    at_.opening = response.jump[0];
    at_.slip = response.jump[1];
    at_.pressure = memory_.pressure;
    at_.shear = memory_.shear;
    at_.dilation = memory_.dilation;
    at_.status = words[static_cast<std::size_t>(found.status)];
    const auto count = static_cast<std::ptrdiff_t>(variables().size());
    at_.variables.assign(memory_.law.begin(), memory_.law.begin() + count);
    at_.iterations = iterations_;
  }

  /// What led it was met.
  void follow(const JointTarget& target) {
    (target.pressure ? at_.pressure : at_.opening) = target.normal;
    (target.shear ? at_.shear : at_.slip) = target.tangential;
  }

  // Newton inside a status, the status outside.
  std::optional<Found> settle(const JointTarget& target, Status status, const Eigen::Vector2d& from) {
    Unknowns y = begin_with(law_, status, memory_, from);
    for (int change = 0; change < most_changes; ++change) {
      if (!solve(target, status, y)) return {};
      const PointResponse response = respond(law_, hold, memory_, status, y);
      const Tolerance limits{tolerance * std::max(1.0, response.traction.cwiseAbs().maxCoeff()),
                             1e-3 * tolerance * response.jump.cwiseAbs().maxCoeff()};
      const Status next = next_status(law_, memory_, status, y, response, limits);
      if (next == status) return Found{status, y};
      PointMemory now = memory_;
      now.pressure = -response.traction[0];
      now.shear = response.traction[1];
      y = begin_with(law_, next, now, response.jump);
      status = next;
    }
    return {};
  }

  bool solve(const JointTarget& target, Status status, Unknowns& y) {
    const std::array<Row, 2> rows = {{{target.pressure, target.pressure ? -target.normal : target.normal},
                                      {target.shear, target.tangential}}};
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      ++iterations_;
      const PointResponse response = respond(law_, hold, memory_, status, y);
      Eigen::Vector2d r;
      Eigen::Matrix2d by;
      bool met = true;
      for (int i = 0; i < 2; ++i) {
        const Eigen::Vector2d& value = rows[i].traction ? response.traction : response.jump;
        r[i] = value[i] - rows[i].target;
        by.row(i) = rows[i].traction ? response.traction_by.row(i) : response.jump_by.row(i);
        const double least = rows[i].traction ? 1 : 0;
        const double scale = std::max({least, std::abs(rows[i].target), value.cwiseAbs().maxCoeff()});
        met = met && std::abs(r[i]) <= tolerance * scale;
      }
      // One more correction after it was met leaves only rounding.
      y -= correction(by, r);
      if (!y.allFinite()) return false;
      if (met) return true;
    }
    return false;
  }

  // Rows and columns are of different units: both are scaled to 1 first. What nothing resists stays.
  static Unknowns correction(Eigen::Matrix2d by, Eigen::Vector2d r) {
    for (int i = 0; i < 2; ++i) {
      const double size = by.row(i).cwiseAbs().maxCoeff();
      if (size > 0) by.row(i) /= size, r[i] /= size;
    }
    Eigen::Vector2d scale(1, 1);
    for (int j = 0; j < 2; ++j) {
      const double size = by.col(j).cwiseAbs().maxCoeff();
      if (size > 0) by.col(j) /= size, scale[j] = 1 / size;
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix2d> solver;
    solver.setThreshold(tolerance);
    return scale.cwiseProduct(solver.compute(by).solve(r));
  }

  JointLaw law_;
  std::string words_;
  PointMemory memory_;
  Eigen::Vector2d jump_ = {0, 0};
  JointPoint at_;
  int iterations_ = 0;
};

}  // namespace

std::unique_ptr<model::JointDriver> make_joint_driver(core::Registry& registry,
                                                      const core::Settings& settings,
                                                      core::Mistakes& mistakes) {
  JointLaw law = make_joint_law(registry, settings, mistakes);
  if (!law.normal || !law.friction) return nullptr;
  return std::make_unique<PointDriver>(std::move(law), "normal law " + settings.object("normal_law").name +
                                                           ", friction " + settings.object("friction").name);
}

}  // namespace ashlar::contact
