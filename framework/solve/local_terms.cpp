#include <algorithm>

#include "core/ledger.hpp"
#include "solve/local.hpp"

namespace ashlar::solve {

using model::JumpResponse;

LocalTerms::LocalTerms(std::vector<std::shared_ptr<model::LocalTerm>> terms,
                       const model::Constraints& constraints)
    : terms_(std::move(terms)), held_(constraints.held) {
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
  gather_jumps();
}

void LocalTerms::gather_jumps() {
  first_ = {0};
  blocks_.clear();
  std::vector<double> area, ground, initial;
  for (const auto& term : terms_) {
    const model::Jumps& jumps = term->jumps();
    for (Index i = 0; i < jumps.size(); i += jumps.width) blocks_.push_back({first_.back() + i, jumps.width});
    area.insert(area.end(), jumps.area.begin(), jumps.area.end());
    ground.insert(ground.end(), jumps.ground.begin(), jumps.ground.end());
    initial.insert(initial.end(), jumps.initial.begin(), jumps.initial.end());
    first_.push_back(first_.back() + jumps.size());
  }
  const auto vector = [](const std::vector<double>& list) {
    return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Index>(list.size()));
  };
  area_ = vector(area), ground_ = vector(ground), initial_ = vector(initial);
}

bool LocalTerms::follow(fields::State& state) {
  bool moved = false;
  for (const auto& term : terms_) moved |= term->follow(state);
  if (!moved) return false;
  gather_jumps();
  condensed_.reset();
  return true;
}

bool LocalTerms::serves(const std::vector<std::shared_ptr<model::LocalTerm>>& terms,
                        const model::Constraints& constraints) const {
  return terms == terms_ && constraints.held == held_;
}

Eigen::SparseMatrix<double> LocalTerms::free_jumps() const {
  std::vector<Index> column(touched_.size(), -1);
  for (std::size_t f = 0; f < free_.size(); ++f) column[free_[f]] = static_cast<Index>(f);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const model::Jumps& jumps = terms_[t]->jumps();
    for (Index i = 0; i < jumps.size(); ++i)
      for (const model::Jumps::Part& part : jumps.parts[i])
        if (const Index j = column[place_[t][part.place]]; j >= 0)
          entries.emplace_back(first_[t] + i, j, part.factor);
  }
  Eigen::SparseMatrix<double> b(size(), static_cast<Index>(free_.size()));
  b.setFromTriplets(entries.begin(), entries.end());
  return b;
}

Eigen::VectorXd LocalTerms::jumps(const Eigen::VectorXd& u) const {
  Eigen::VectorXd all = initial_;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const model::Jumps& jumps = terms_[t]->jumps();
    for (Index i = 0; i < jumps.size(); ++i)
      for (const model::Jumps::Part& part : jumps.parts[i])
        all[first_[t] + i] += part.factor * u[place_[t][part.place]];
  }
  return all;
}

void add_force(const model::LocalTerm& term, const fields::State& state, std::span<double> force) {
  const model::Jumps& jumps = term.jumps();
  std::vector<double> traction(static_cast<std::size_t>(jumps.size()));
  term.tractions(state, traction);
  for (Index i = 0; i < jumps.size(); ++i)
    for (const model::Jumps::Part& part : jumps.parts[i])
      force[term.touched()[part.place]] += part.factor * jumps.area[i] * traction[i];
}

void LocalTerms::add_force(const fields::State& state, std::span<double> force) const {
  for (const auto& term : terms_) solve::add_force(*term, state, force);
}

namespace {

std::span<const double> part_of(const Eigen::VectorXd& all, Index from, Index to) {
  return {all.data() + from, static_cast<std::size_t>(to - from)};
}

std::span<double> part_of(Eigen::VectorXd& all, Index from, Index to) {
  return {all.data() + from, static_cast<std::size_t>(to - from)};
}

}  // namespace

void LocalTerms::respond(const fields::State& state, const Eigen::VectorXd& unknown,
                         JumpResponse& response) const {
  if (terms_.size() == 1) return terms_[0]->respond(state, part_of(unknown, 0, size()), response);
  int width = 1;
  for (const Block& block : blocks_) width = std::max(width, static_cast<int>(block.width));
  response.resize(size(), width);
  JumpResponse own;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    terms_[t]->respond(state, part_of(unknown, first_[t], first_[t + 1]), own);
    const Index rows = first_[t + 1] - first_[t];
    response.jump.segment(first_[t], rows) = own.jump;
    response.traction.segment(first_[t], rows) = own.traction;
    response.jump_by.block(first_[t], 0, rows, own.jump_by.cols()) = own.jump_by;
    response.traction_by.block(first_[t], 0, rows, own.traction_by.cols()) = own.traction_by;
  }
}

void LocalTerms::begin(const fields::State& state, const Eigen::VectorXd& jump,
                       Eigen::VectorXd& unknown) const {
  unknown.resize(size());
  for (std::size_t t = 0; t < terms_.size(); ++t)
    terms_[t]->begin(state, part_of(jump, first_[t], first_[t + 1]),
                     part_of(unknown, first_[t], first_[t + 1]));
}

model::StatusUpdate LocalTerms::update_status(fields::State& state, const model::StatusChange& change,
                                              Eigen::VectorXd& unknown) const {
  model::StatusUpdate all;
  for (std::size_t t = 0; t < terms_.size() && !(change.one && all.changed > 0); ++t) {
    const auto own = terms_[t]->update_status(state, change, part_of(unknown, first_[t], first_[t + 1]));
    all.changed += own.changed;
    all.complementarity = std::max(all.complementarity, own.complementarity);
  }
  return all;
}

bool LocalTerms::stop_first(fields::State& state, const Eigen::VectorXd& motion,
                            Eigen::VectorXd& unknown) const {
  for (std::size_t t = 0; t < terms_.size(); ++t)
    if (terms_[t]->stop_first(state, part_of(motion, first_[t], first_[t + 1]),
                              part_of(unknown, first_[t], first_[t + 1])))
      return true;
  return false;
}

bool LocalTerms::settle(fields::State& state, const Eigen::VectorXd& unknown) const {
  bool again = false;
  for (std::size_t t = 0; t < terms_.size(); ++t)
    again |= terms_[t]->settle(state, part_of(unknown, first_[t], first_[t + 1]));
  return again;
}

std::vector<std::int8_t> LocalTerms::status(const fields::State& state) const {
  std::vector<std::int8_t> all;
  for (const auto& term : terms_) {
    const auto each = term->status(state);
    all.insert(all.end(), each.begin(), each.end());
  }
  return all;
}

void LocalTerms::restore(fields::State& state, std::span<const std::int8_t> status) const {
  for (const auto& term : terms_) {
    const std::size_t count = term->status(state).size();
    term->restore(state, status.first(count));
    status = status.subspan(count);
  }
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
                                                              const Eigen::VectorXd& unknown) const {
  std::vector<std::pair<std::string, double>> all;
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (auto& fact : terms_[t]->facts(state, part_of(unknown, first_[t], first_[t + 1])))
      all.push_back(std::move(fact));
  return all;
}

const Condensed& LocalTerms::condensed(const Bulk& bulk) {
  if (!condensed_) {
    const auto timing = core::ledger().time("condense", effect());
    condensed_.emplace(Condensed::Points{free_jumps(), area_, ground_}, bulk.solver().schur(),
                       bulk.symmetric(), bulk.solver().dense());
  }
  return *condensed_;
}

}  // namespace ashlar::solve
