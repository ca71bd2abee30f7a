#include "solve/bulk.hpp"

#include <algorithm>

#include "core/ledger.hpp"

namespace ashlar::solve {

namespace {

/// Groups of dofs as groups of free unknowns (-1: held).
algebra::Adjacency to_unknowns(const algebra::Adjacency& groups, const model::Constraints& constraints) {
  std::vector<Index> offsets(groups.offsets().begin(), groups.offsets().end());
  std::vector<Index> values(groups.values().size());
  std::transform(groups.values().begin(), groups.values().end(), values.begin(),
                 [&](Index dof) { return constraints.unknown[dof]; });
  return {std::move(offsets), std::move(values)};
}

}  // namespace

bool BulkTerms::symmetric() const {
  return std::ranges::all_of(nonlinear, [](const auto& term) { return term->symmetric(); });
}

Bulk::Bulk(const model::Model& model, BulkTerms terms, const model::Constraints& constraints,
           std::vector<Index> touched, std::unique_ptr<algebra::LinearSolver> solver)
    : terms_(std::move(terms)),
      held_(constraints.held),
      touched_(std::move(touched)),
      solver_(std::move(solver)) {
  for (const Index dof : touched_)
    if (constraints.unknown[dof] >= 0) kept_.push_back(constraints.unknown[dof]);
  if (constraints.unknowns() == 0) {
    report_.done = true;
    report_.ordering = "nothing: every displacement is given";
    return;
  }
  assemble(constraints);
  order(model, constraints);
  core::ledger().add_unknowns("factor", "", constraints.unknowns());
  if (!linear()) {
    constant_ = matrix_.value;
    report_.done = true;
    return;
  }
  factor();
  matrix_ = {};
}

bool Bulk::serves(const BulkTerms& terms, const model::Constraints& constraints,
                  std::span<const Index> touched) const {
  return terms == terms_ && constraints.held == held_ && std::ranges::equal(touched, touched_);
}

void Bulk::assemble(const model::Constraints& constraints) {
  auto& ledger = core::ledger();
  const auto timing = ledger.time("assemble");
  std::vector<algebra::Adjacency> groups;
  for (const auto& term : terms_.stiffness) groups.push_back(to_unknowns(term->groups(), constraints));
  for (const auto& term : terms_.nonlinear) groups.push_back(to_unknowns(term->groups(), constraints));
  std::vector<const algebra::Adjacency*> pointers;
  for (const auto& each : groups) pointers.push_back(&each);
  matrix_.pattern = algebra::make_pattern(constraints.unknowns(), pointers);
  matrix_.value.assign(matrix_.pattern.entries(), 0.0);
  for (std::size_t t = 0; t < terms_.stiffness.size(); ++t) {
    const std::string& effect = terms_.stiffness[t]->effect();
    const auto term_timing = ledger.time("assemble", effect);
    const algebra::ScatterMap map(matrix_.pattern, groups[t]);
    terms_.stiffness[t]->add_tangent(map, matrix_.value);
    ledger.add_bytes("assemble", effect, static_cast<std::int64_t>(map.bytes()));
  }
  for (std::size_t t = terms_.stiffness.size(); t < groups.size(); ++t) {
    maps_.emplace_back(matrix_.pattern, groups[t]);
    ledger.add_bytes("assemble", terms_.nonlinear[t - terms_.stiffness.size()]->effect(),
                     static_cast<std::int64_t>(maps_.back().bytes()));
  }
  norm_ = algebra::infinity_norm(matrix_);
}

void Bulk::order(const model::Model& model, const model::Constraints& constraints) {
  std::vector<Index> node(constraints.dof.size());
  std::transform(constraints.dof.begin(), constraints.dof.end(), node.begin(),
                 [&](Index dof) { return dof / model.dofs.field().width; });
  const auto timing = core::ledger().time("order");
  solver_->analyse(matrix_.pattern, kept_, node);
}

void Bulk::factor() {
  const auto timing = core::ledger().time("factor");
  report_ = solver_->factor(matrix_);
  core::ledger().add_bytes("factor", "",
                           static_cast<std::int64_t>(solver_->bytes()) - static_cast<std::int64_t>(bytes_));
  bytes_ = solver_->bytes();
}

void Bulk::linearise(fields::State& state) {
  {
    const auto timing = core::ledger().time("assemble");
    matrix_.value = constant_;
    if (!terms_.symmetric()) matrix_.upper = constant_;
    for (std::size_t t = 0; t < terms_.nonlinear.size(); ++t) {
      const auto term_timing = core::ledger().time("assemble", terms_.nonlinear[t]->effect());
      terms_.nonlinear[t]->add_tangent(state, maps_[t], matrix_.value, matrix_.upper);
    }
    norm_ = algebra::infinity_norm(matrix_);
  }
  factor();
}

void Bulk::add_internal_force(fields::State& state, std::span<double> force) const {
  for (const auto& term : terms_.stiffness) term->add_internal_force(state.trial(displacement), force);
  for (const auto& term : terms_.nonlinear) term->add_internal_force(state, force);
}

void Bulk::add_tangent_product(fields::State& state, std::span<const double> direction,
                               std::span<double> force) const {
  for (const auto& term : terms_.stiffness) term->add_internal_force(direction, force);
  for (const auto& term : terms_.nonlinear) term->add_tangent_product(state, direction, force);
}

std::vector<std::pair<std::string, double>> Bulk::facts(const fields::State& state) const {
  std::vector<std::pair<std::string, double>> all;
  for (const auto& term : terms_.nonlinear)
    for (auto& fact : term->facts(state)) all.push_back(std::move(fact));
  return all;
}

}  // namespace ashlar::solve
