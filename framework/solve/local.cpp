#include "solve/local.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace ashlar::solve {

namespace {

// Far more statuses than any sound stage visits (a handful); a cycle is found long before.
constexpr int most_statuses = 60;
// Points that change one by one: where so many did not settle it, a smaller step is the shorter way.
constexpr int most_single = 100;
// For a fixed status most points are linear: one step solves, the second confirms.
constexpr int most_newton_steps = 20;
// A matrix whose last step left no more of the misfit than this is used for the next.
constexpr double serves_again = 1e-3;
// Jumps that fit relative to the largest at hand: two digits above round-off.
constexpr double fit = 1e-14;
// Jumps that stay apart by more than this share are in no balance: a law jumps where it would be.
constexpr double unbalanced = 1e-6;
// A condensed matrix worse than this is singular to working accuracy.
constexpr double singular = 1e-13;
// Jumps so many times those of joints that touch everywhere are a body that rounding alone holds.
constexpr double loose = 1e7;
// Constraints that repeat each other (held lips, two passes) are told apart by this share of the ground
// compliance, in the matrix only: what is solved stays exact.
constexpr double poor = 1e-12, told_apart = 1e-7;
// Springs of this share of the ground stiffness tell the free motion of a singular matrix.
constexpr double next_to_none = 1e-8;
// Displacements below this share of the largest are what rounding leaves of differences.
constexpr double displacement_digits = 1e-12;

double largest(const Eigen::VectorXd& values) {
  return values.size() == 0 ? 0 : values.lpNorm<Eigen::Infinity>();
}

}  // namespace

Condensed::Condensed(Points points, const Eigen::MatrixXd& schur, bool symmetric,
                     const algebra::DenseAlgebra& dense)
    : points_(std::move(points)), symmetric_(symmetric), dense_(dense) {
  const Eigen::SparseMatrix<double>& b = points_.jumps;
  const Eigen::VectorXd stiffness = points_.area.cwiseProduct(points_.ground);
  const Eigen::SparseMatrix<double> ground = b.transpose() * stiffness.asDiagonal() * b;
  Eigen::MatrixXd grounded = schur + ground;
  Eigen::MatrixXd transposed = Eigen::MatrixXd(b).transpose();
  Eigen::MatrixXd compliance;
  if (symmetric_) {
    cholesky_ = dense_.cholesky(std::move(grounded));
    held_ = cholesky_->rcond() > singular;
    if (!held_) return;
    compliance = cholesky_->inverse_between(std::move(transposed));
  } else {
    lu_ = dense_.lu(std::move(grounded));
    held_ = lu_->rcond() > singular;
    if (!held_) return;
    compliance = b * lu_->solve(std::move(transposed));
  }
  by_traction_ = compliance * points_.area.asDiagonal();
  by_jump_ = -compliance * stiffness.asDiagonal();
  by_jump_.diagonal().array() += 1;
}

Eigen::VectorXd Condensed::solve(const Eigen::VectorXd& load) const {
  if (symmetric_) return cholesky_->solve(load);
  return lu_->solve(load);
}

Eigen::VectorXd Condensed::displacement(const Eigen::VectorXd& load, const Eigen::VectorXd& traction,
                                        const Eigen::VectorXd& change) const {
  const Eigen::VectorXd force = points_.area.cwiseProduct(traction - points_.ground.cwiseProduct(change));
  return solve(load - points_.jumps.transpose() * force);
}

namespace {

/// The matrix of a Newton step, (I − F A D) ∂J/∂y + F A ∂q/∂y, its rows scaled to energies and its columns
/// to 1.
class StepMatrix {
 public:
  StepMatrix(const LocalTerms& terms, const Condensed& bulk, const model::JumpResponse& response)
      : terms_(terms), bulk_(bulk), row_scale_(terms.area().cwiseProduct(terms.ground()).cwiseSqrt()) {
    factor(response.jump_by, response.traction_by);
    if (factor_->rcond() >= poor) return;
    Eigen::MatrixXd jump_by = response.jump_by;
    for (Index i = 0; i < jump_by.rows(); ++i)
      jump_by.row(i) += told_apart / terms.ground()[i] * response.traction_by.row(i);
    factor(jump_by, response.traction_by);
  }
  bool regular() const { return factor_->rcond() > singular; }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return column_scale_.cwiseProduct(factor_->solve(row_scale_.cwiseProduct(right)));
  }
  /// Puts next to no springs between the lips: a step is then the motion that meets no other resistance, in
  /// the sense in which forces drive it. False if that does not help.
  bool loosen(const model::JumpResponse& response) {
    Eigen::MatrixXd traction_by = response.traction_by;
    for (Index i = 0; i < traction_by.rows(); ++i)
      traction_by.row(i) += next_to_none * terms_.ground()[i] * response.jump_by.row(i);
    factor(response.jump_by, traction_by);
    return factor_->rcond() > 0;
  }

 private:
  void factor(const Eigen::MatrixXd& jump_by, const Eigen::MatrixXd& traction_by) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(terms_.size(), terms_.size());
    for (const LocalTerms::Block& block : terms_.blocks()) {
      const Index at = block.first, width = block.width;
      matrix.middleCols(at, width) =
          bulk_.by_jump().middleCols(at, width) * jump_by.block(at, 0, width, width) +
          bulk_.by_traction().middleCols(at, width) * traction_by.block(at, 0, width, width);
    }
    matrix = row_scale_.asDiagonal() * matrix;
    column_scale_ = matrix.cwiseAbs().colwise().maxCoeff().cwiseMax(1e-300).cwiseInverse();
    matrix = matrix * column_scale_.asDiagonal();
    factor_ = bulk_.dense().lu(std::move(matrix));
  }

  const LocalTerms& terms_;
  const Condensed& bulk_;
  Eigen::VectorXd row_scale_, column_scale_;
  std::unique_ptr<algebra::DenseLu> factor_;
};

std::string name_cycle(const LocalTerms& terms, const fields::State& state,
                       const std::vector<std::int8_t>& before) {
  const std::vector<std::int8_t> now = terms.status(state);
  std::string names;
  int count = 0;
  for (std::size_t p = 0; p < now.size(); ++p) {
    if (now[p] == before[p]) continue;
    if (++count <= 4) names += (names.empty() ? "" : ", ") + terms.point_name(p, state);
  }
  return "the status of joints repeats itself without settling; " + std::to_string(count) +
         " points flip: " + names + (count > 4 ? " …" : "");
}

/// The search for the status that fits one load.
class Search {
 public:
  Search(const LocalTerms& terms, const Condensed& bulk, const Eigen::VectorXd& load, fields::State& state,
         Eigen::VectorXd& u)
      : terms_(terms), bulk_(bulk), load_(load), state_(state), u_(u) {
    terms_.begin(state_, terms_.jumps(u_), unknown_);
    Eigen::VectorXd held = u_;
    held(terms_.free()).setZero();
    fixed_ = terms_.jumps(held);
    from_load_ = bulk_.jump_of(load_);
  }

  LocalResult run(std::vector<model::Iteration>& rows) {
    const int most = most_statuses + std::min(most_single, static_cast<int>(terms_.blocks().size()));
    for (int number = 1; number <= most; ++number) {
      const std::vector<std::int8_t> before = terms_.status(state_);
      if (!visited_.insert(before).second && !break_cycle())
        return loosened_ ? not_held()
                         : LocalResult{false, false,
                                       name_cycle(terms_, state_, good_ != before ? good_ : flipping_)};
      const Eigen::VectorXd start = unknown_;
      residual_ = solve_fixed_status();
      if (residual_ < 0) {
        unknown_ = start;  // what a singular matrix made of it is of no use
        loosened_ = true;
        if (stop_motion() || step_back()) continue;
        return not_held();
      }
      if (good_ != before) flipping_ = good_;
      good_ = before;
      good_unknown_ = unknown_;
      const model::StatusUpdate update = update_status();
      add_row(number, update, rows);
      if (update.changed > 0) continue;
      if (residual_ > unbalanced) return {false, false, name_unbalanced()};
      if (terms_.settle(state_, unknown_)) {
        visited_.clear();
        one_ = false;
        continue;
      }
      finish();
      return {true, false, {}};
    }
    if (loosened_) return not_held();
    return {false, false, "the status of joints still changes after " + std::to_string(most) + " iterations"};
  }

 private:
  /// Newton for the present status; the relative misfit of the jumps, or a negative number if singular.
  double solve_fixed_status() {
    jump_motion_.resize(0);
    std::optional<StepMatrix> matrix;
    double before = INFINITY;
    for (int step = 0; step < most_newton_steps; ++step) {
      terms_.respond(state_, unknown_, response_);
      change_ = response_.jump - fixed_;
      const Eigen::VectorXd pressed = bulk_.by_traction() * response_.traction;
      const Eigen::VectorXd misfit = bulk_.by_jump() * change_ - from_load_ + pressed;
      const double scale = std::max({largest(change_), largest(from_load_), largest(pressed), 1e-300});
      const double relative = largest(misfit) / scale;
      if (!std::isfinite(relative)) return -1;
      misfit.cwiseAbs().maxCoeff(&worst_);
      if (largest(change_) > loose * std::max(largest(from_load_), largest(fixed_))) {
        motion_ = displacement();
        jump_motion_ = change_;
        return -1;
      }
      if (step > 0 && (relative < fit || (step > 1 && relative > 0.5 * before))) return relative;
      if (!matrix || relative > serves_again * before) matrix.emplace(terms_, bulk_, response_);
      before = relative;
      if (!matrix->regular()) {
        if (matrix->loosen(response_)) tell_motion(matrix->solve(-misfit));
        return -1;
      }
      if (relative < fit) return relative;  // nothing to do, and nothing moves
      unknown_ -= matrix->solve(misfit);
    }
    return before;
  }

  model::StatusUpdate update_status() {
    const Eigen::VectorXd u = displacement();
    const model::StatusChange change{displacement_digits * std::max(largest(u), largest(u_)), one_};
    return terms_.update_status(state_, change, unknown_);
  }

  Eigen::VectorXd displacement() const { return bulk_.displacement(load_, response_.traction, change_); }

  /// A status came back: from here on points change one by one, as the term chooses them. False if they do
  /// so already.
  bool break_cycle() {
    if (one_) return false;
    one_ = true;
    visited_.clear();
    return true;
  }

  LocalResult not_held() const {
    LocalResult result{false, true, "the joints do not hold a body that nothing else holds" + counts()};
    result.held_before = !good_.empty();
    if (motion_.size() == 0 || !motion_.allFinite()) return result;
    result.motion = Eigen::VectorXd::Zero(u_.size());
    result.motion(terms_.free()) = motion_;
    return result;
  }

  /// How jumps and the free touched dofs move where the points' unknowns change so.
  void tell_motion(const Eigen::VectorXd& unknown) {
    Eigen::VectorXd traction(unknown.size());
    jump_motion_.resize(unknown.size());
    for (const LocalTerms::Block& block : terms_.blocks()) {
      const Index at = block.first, width = block.width;
      const auto own = unknown.segment(at, width);
      jump_motion_.segment(at, width) = response_.jump_by.block(at, 0, width, width) * own;
      traction.segment(at, width) = response_.traction_by.block(at, 0, width, width) * own;
    }
    motion_ = bulk_.displacement(Eigen::VectorXd::Zero(load_.size()), traction, jump_motion_);
  }

  std::string name_unbalanced() const {
    std::size_t point = 0;
    while (point + 1 < terms_.blocks().size() && terms_.blocks()[point + 1].first <= worst_) ++point;
    char text[40];
    std::snprintf(text, sizeof text, "%.1e", residual_);
    return "no traction of the joint's law is in balance at " + terms_.point_name(point, state_) +
           ": jumps stay off by " + text + " of the largest";
  }

  /// The last change let a body loose: only its worst point changes.
  bool step_back() {
    if (one_ || good_.empty()) return false;
    one_ = true;
    visited_.clear();
    terms_.restore(state_, good_);
    unknown_ = good_unknown_;
    terms_.respond(state_, unknown_, response_);
    change_ = response_.jump - fixed_;
    return update_status().changed > 0;
  }

  /// A body that nothing holds moves with its load until a point touches, or slip turns back and sticks.
  bool stop_motion() {
    return terms_.stop_first(
        state_, jump_motion_.size() > 0 && jump_motion_.allFinite() ? jump_motion_ : from_load_, unknown_);
  }

  /// " (open 3, stick 0, slip 5)": how the joints stand.
  std::string counts() const {
    std::string words;
    for (const auto& [name, value] : terms_.facts(state_, unknown_))
      if (value == std::floor(value) && name != "pressure" && name != "penetration/h")
        words += (words.empty() ? "" : ", ") + name + " " + std::to_string(static_cast<long>(value));
    return words.empty() ? "" : " (" + words + ")";
  }

  void add_row(int number, const model::StatusUpdate& update, std::vector<model::Iteration>& rows) {
    model::Iteration row{
        1, number, residual_, {{"changed", update.changed}, {"complementarity", update.complementarity}}};
    for (auto& fact : terms_.facts(state_, unknown_)) row.facts.push_back(std::move(fact));
    rows.push_back(std::move(row));
  }

  void finish() { u_(terms_.free()) = displacement(); }

  const LocalTerms& terms_;
  const Condensed& bulk_;
  const Eigen::VectorXd& load_;
  fields::State& state_;
  Eigen::VectorXd& u_;
  Eigen::VectorXd unknown_, good_unknown_, fixed_, from_load_, change_;
  // In the last status that did not hold a body: of the free touched dofs, of the jumps.
  Eigen::VectorXd motion_, jump_motion_;
  model::JumpResponse response_;
  std::set<std::vector<std::int8_t>> visited_;
  std::vector<std::int8_t> good_;      ///< the last status that could be solved
  std::vector<std::int8_t> flipping_;  ///< the one before it
  bool loosened_ = false;              ///< a status was met that does not hold a body
  double residual_ = 0;
  Index worst_ = 0;  ///< the component that fits least
  bool one_ = false;
};

}  // namespace

LocalResult iterate(const LocalTerms& terms, const Condensed& bulk, const Eigen::VectorXd& load,
                    fields::State& state, Eigen::VectorXd& u, std::vector<model::Iteration>& rows) {
  if (!bulk.held()) return {false, true, "nothing holds a body, not even joints that touch"};
  return Search(terms, bulk, load, state, u).run(rows);
}

}  // namespace ashlar::solve
