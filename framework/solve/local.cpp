#include "solve/local.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::solve {

namespace {

// Far more statuses than any sound stage visits (a handful); a cycle is found long before.
constexpr int most_statuses = 60;
// For a fixed status the terms at hand are linear: one step solves, the second confirms.
constexpr int most_newton_steps = 20;
// Forces in balance relative to the largest force at hand: three digits above round-off of the dense solve.
constexpr double force_tolerance = 1e-12;

}  // namespace

LocalTerms::LocalTerms(std::vector<std::shared_ptr<const model::LocalTerm>> terms,
                       const model::Constraints& constraints)
    : terms_(std::move(terms)) {
  for (const auto& term : terms_)
    touched_.insert(touched_.end(), term->touched().begin(), term->touched().end());
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const auto& term : terms_) {
    std::vector<Index>& place = place_.emplace_back();
    for (const Index dof : term->touched())
      place.push_back(
          static_cast<Index>(std::lower_bound(touched_.begin(), touched_.end(), dof) - touched_.begin()));
  }
  for (std::size_t i = 0; i < touched_.size(); ++i)
    if (!constraints.held[touched_[i]]) free_.push_back(static_cast<Index>(i));
}

std::vector<double> LocalTerms::own(std::size_t term, const Eigen::VectorXd& u) const {
  std::vector<double> values;
  values.reserve(place_[term].size());
  for (const Index i : place_[term]) values.push_back(u[i]);
  return values;
}

void LocalTerms::evaluate(const fields::State& state, const Eigen::VectorXd& u, Eigen::VectorXd& force,
                          Eigen::MatrixXd& tangent) const {
  force.setZero(static_cast<Index>(touched_.size()));
  tangent.setZero(force.size(), force.size());
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const std::vector<Index>& place = place_[t];
    const auto size = static_cast<Index>(place.size());
    if (size == force.size()) {  // one term touches all: no copies
      terms_[t]->add_local(state, own(t, u), force, tangent);
      continue;
    }
    Eigen::VectorXd own_force = Eigen::VectorXd::Zero(size);
    Eigen::MatrixXd own_tangent = Eigen::MatrixXd::Zero(size, size);
    terms_[t]->add_local(state, own(t, u), own_force, own_tangent);
    force(place) += own_force;
    tangent(place, place) += own_tangent;
  }
}

int LocalTerms::update_status(fields::State& state, const Eigen::VectorXd& u) const {
  int changed = 0;
  for (std::size_t t = 0; t < terms_.size(); ++t) changed += terms_[t]->update_status(state, own(t, u));
  return changed;
}

std::vector<std::int8_t> LocalTerms::status(const fields::State& state) const {
  std::vector<std::int8_t> all;
  for (const auto& term : terms_) {
    const auto each = term->status(state);
    all.insert(all.end(), each.begin(), each.end());
  }
  return all;
}

std::string LocalTerms::point_name(std::size_t point, const fields::State& state) const {
  for (const auto& term : terms_) {
    const std::size_t count = term->status(state).size();
    if (point < count) return term->point_name(point);
    point -= count;
  }
  return {};
}

std::vector<std::pair<std::string, double>> LocalTerms::facts(const fields::State& state,
                                                              const Eigen::VectorXd& u) const {
  std::vector<std::pair<std::string, double>> all;
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (auto& fact : terms_[t]->facts(state, own(t, u))) all.push_back(std::move(fact));
  return all;
}

namespace {

/// Solves S u + c(u) = load in the free dofs for the present status. Returns the relative residual left, or a
/// negative number if the system is singular.
double solve_fixed_status(const LocalTerms& terms, const Eigen::MatrixXd& schur, const Eigen::VectorXd& load,
                          const fields::State& state, Eigen::VectorXd& u) {
  const std::vector<Index>& free = terms.free();
  Eigen::VectorXd force;
  Eigen::MatrixXd tangent;
  double before = INFINITY;
  for (int step = 0; step < most_newton_steps; ++step) {
    terms.evaluate(state, u, force, tangent);
    const Eigen::VectorXd bulk = schur * u(free);
    const Eigen::VectorXd residual = bulk + force(free) - load;
    const double scale = std::max({bulk.lpNorm<Eigen::Infinity>(), force.lpNorm<Eigen::Infinity>(),
                                   load.lpNorm<Eigen::Infinity>(), 1e-300});
    const double relative = residual.lpNorm<Eigen::Infinity>() / scale;
    if (!std::isfinite(relative)) return -1;
    // Round-off of stiff penalties may stop short of the tolerance: then it no longer falls.
    if (relative < force_tolerance || (step > 1 && relative > 0.5 * before)) return relative;
    before = relative;
    const Eigen::MatrixXd matrix = schur + Eigen::MatrixXd(tangent(free, free));
    if (!schur.isApprox(schur.transpose(), 1e-13)) {
      const Eigen::PartialPivLU<Eigen::MatrixXd> factor(matrix);
      if (!(factor.rcond() >= 1e-16)) return -1;
      u(free) -= factor.solve(residual);
      continue;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
    if (factor.info() != Eigen::Success || factor.rcond() < 1e-16) return -1;
    u(free) -= factor.solve(residual);
  }
  return before;
}

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

}  // namespace

LocalResult iterate(const LocalTerms& terms, const Eigen::MatrixXd& schur, const Eigen::VectorXd& load,
                    fields::State& state, Eigen::VectorXd& u, std::vector<model::Iteration>& rows) {
  std::set<std::vector<std::int8_t>> visited;
  for (int number = 1; number <= most_statuses; ++number) {
    const std::vector<std::int8_t> before = terms.status(state);
    if (!visited.insert(before).second) {
      terms.update_status(state, u);
      return {false, false, name_cycle(terms, state, before)};
    }
    const double residual = solve_fixed_status(terms, schur, load, state, u);
    if (residual < 0) return {false, true, "the joints do not hold a body that nothing else holds"};
    const int changed = terms.update_status(state, u);
    model::Iteration row{1, number, residual, {{"changed", changed}}};
    for (auto& fact : terms.facts(state, u)) row.facts.push_back(std::move(fact));
    rows.push_back(std::move(row));
    if (changed == 0) return {true, false, {}};
  }
  return {false, false,
          "the status of joints still changes after " + std::to_string(most_statuses) + " iterations"};
}

}  // namespace ashlar::solve
