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

Bulk::Bulk(const model::Model& model, std::vector<std::shared_ptr<const model::Stiffness>> stiffness,
           const model::Constraints& constraints, std::vector<Index> touched,
           std::unique_ptr<algebra::LinearSolver> solver)
    : stiffness_(std::move(stiffness)),
      held_(constraints.held),
      touched_(std::move(touched)),
      solver_(std::move(solver)) {
  for (const Index dof : touched_)
    if (constraints.unknown[dof] >= 0) kept_.push_back(constraints.unknown[dof]);
  assemble_and_factor(model, constraints);
}

bool Bulk::serves(const std::vector<std::shared_ptr<const model::Stiffness>>& stiffness,
                  const model::Constraints& constraints, std::span<const Index> touched) const {
  return stiffness == stiffness_ && constraints.held == held_ && std::ranges::equal(touched, touched_);
}

void Bulk::assemble_and_factor(const model::Model& model, const model::Constraints& constraints) {
  if (constraints.unknowns() == 0) {
    report_.done = true;
    report_.ordering = "nothing: every displacement is given";
    return;
  }
  auto& ledger = core::ledger();
  algebra::SymmetricMatrix matrix;
  {
    const auto timing = ledger.time("assemble");
    std::vector<algebra::Adjacency> groups;
    std::vector<const algebra::Adjacency*> pointers;
    for (const auto& term : stiffness_) groups.push_back(to_unknowns(term->groups(), constraints));
    for (const auto& each : groups) pointers.push_back(&each);
    matrix.pattern = algebra::make_pattern(constraints.unknowns(), pointers);
    matrix.value.assign(matrix.pattern.entries(), 0.0);
    for (std::size_t t = 0; t < stiffness_.size(); ++t) {
      const auto term_timing = ledger.time("assemble", stiffness_[t]->effect());
      const algebra::ScatterMap map(matrix.pattern, groups[t]);
      stiffness_[t]->add_tangent(map, matrix.value);
      ledger.add_bytes("assemble", stiffness_[t]->effect(), static_cast<std::int64_t>(map.bytes()));
    }
    norm_ = algebra::infinity_norm(matrix);
  }
  std::vector<Index> node(constraints.dof.size());
  std::transform(constraints.dof.begin(), constraints.dof.end(), node.begin(),
                 [&](Index dof) { return dof / model.dofs.field().width; });
  {
    const auto timing = ledger.time("order");
    solver_->analyse(matrix.pattern, kept_, node);
  }
  {
    const auto timing = ledger.time("factor");
    report_ = solver_->factor(matrix);
  }
  bytes_ = solver_->bytes();
  ledger.add_bytes("factor", "", static_cast<std::int64_t>(bytes_));
  ledger.add_unknowns("factor", "", constraints.unknowns());
}

void Bulk::add_internal_force(std::span<const double> u, std::span<double> force) const {
  for (const auto& term : stiffness_) term->add_internal_force(u, force);
}

}  // namespace ashlar::solve
