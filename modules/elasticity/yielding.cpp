#include "elasticity/yielding.hpp"

#include <algorithm>
#include <cassert>

#include "algebra/assemble.hpp"
#include "elasticity/bulk.hpp"
#include "elasticity/cell_access.hpp"

namespace ashlar::elasticity {

namespace {

constexpr fields::State::Id displacement = 0;

/// One cell at the trial state: its points, and what the law says there. Kept from cell to cell.
struct CellNow {
  model::IntegrationPoints points;
  std::vector<model::Response> response;
  std::vector<double> stabilisation;
};

CellNow& scratch() {
  thread_local CellNow now;
  return now;
}

/// Asks the law at every point of a cell. `trial` receives the cell's internal variables.
void ask(const model::Model& model, Index index, std::span<const double> u, std::span<const double> committed,
         std::span<double> trial, CellNow& now) {
  const model::Material& law = model.material(index);
  const auto own = static_cast<std::size_t>(law.internal_variables());
  with_cell(model, index, [&](const model::Cell& cell) {
    model.element->integrate(cell, now.points);
    now.stabilisation.assign(u.size() * (u.size() + 1) / 2, 0.0);
    model.element->add_stabilisation(cell, law, now.stabilisation);
  });
  now.response.resize(static_cast<std::size_t>(now.points.size()));
  for (std::size_t q = 0; q < now.response.size(); ++q)
    now.response[q] = law.respond(now.points.strain(static_cast<int>(q), u), committed.subspan(q * own, own),
                                  trial.subspan(q * own, own));
}

model::Tangent transposed(const model::Tangent& tangent) {
  model::Tangent t;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) t[4 * i + j] = tangent[4 * j + i];
  return t;
}

/// Packed lower triangle of a cell's tangent, or of its transposed.
void pack(const CellNow& now, bool transpose, std::span<double> packed) {
  std::copy(now.stabilisation.begin(), now.stabilisation.end(), packed.begin());
  for (std::size_t q = 0; q < now.response.size(); ++q)
    model::add_tangent(now.points, static_cast<int>(q),
                       transpose ? transposed(now.response[q].tangent) : now.response[q].tangent, packed);
}

/// Entries of the lower triangle of a cell whose dofs do not ascend belong to the upper triangle of the
/// whole.
void sort_triangles(std::span<const Index> dofs, std::span<double> lower, std::span<double> upper) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < dofs.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k, ++at)
      if (dofs[i] < dofs[k]) std::swap(lower[at], upper[at]);
}

}  // namespace

Yielding::Yielding(const model::Model& model, Layout layout, std::set<std::string> fields,
                   fields::State& state)
    : Nonlinear("elasticity"),
      model_(model),
      layout_(std::move(layout)),
      fields_(std::move(fields)),
      history_(state.add("elasticity.history", layout_.history.back())) {}

void Yielding::add_internal_force(fields::State& state, std::span<double> force) const {
  const std::span<const double> u = state.trial(displacement);
  const std::span<const double> committed = state.committed(history_);
  const std::span<double> trial = state.trial(history_);
  algebra::assemble(layout_.dofs, force, [&](Index index, std::span<double> local_force) {
    CellNow& now = scratch();
    const Scratch<double, 64> local = gather(layout_.dofs[index], u);
    ask(model_, index, local, layout_.of(index, committed), layout_.of(index, trial), now);
    std::fill(local_force.begin(), local_force.end(), 0.0);
    for (std::size_t q = 0; q < now.response.size(); ++q)
      model::add_stress(now.points, static_cast<int>(q), now.response[q].stress, local_force);
    model::add_packed_product(now.stabilisation, local, local_force);
  });
}

void Yielding::add_tangent(fields::State& state, const algebra::ScatterMap& map, std::span<double> lower,
                           std::span<double> upper) const {
  const std::span<const double> u = state.trial(displacement);
  const std::span<const double> committed = state.committed(history_);
  const std::span<double> trial = state.trial(history_);
  const auto add = [&](bool into_upper, std::span<double> target) {
    algebra::assemble(map, target, [&](Index index, std::span<double> packed) {
      CellNow& now = scratch();
      const Scratch<double, 64> local = gather(layout_.dofs[index], u);
      ask(model_, index, local, layout_.of(index, committed), layout_.of(index, trial), now);
      pack(now, into_upper, packed);
      if (layout_.symmetric) return;
      thread_local std::vector<double> other;
      other.resize(packed.size());
      pack(now, !into_upper, other);
      sort_triangles(layout_.dofs[index], packed, other);
    });
  };
  add(false, lower);
  if (!upper.empty()) add(true, upper);
}

void Yielding::add_tangent_product(fields::State& state, std::span<const double> direction,
                                   std::span<double> force) const {
  const std::span<const double> u = state.trial(displacement);
  const std::span<const double> committed = state.committed(history_);
  const std::span<double> trial = state.trial(history_);
  algebra::assemble(layout_.dofs, force, [&](Index index, std::span<double> local_force) {
    std::fill(local_force.begin(), local_force.end(), 0.0);
    const Scratch<double, 64> along = gather(layout_.dofs[index], direction);
    const std::span<const double> d = along;
    if (std::ranges::all_of(d, [](double v) { return v == 0; })) return;
    CellNow& now = scratch();
    const Scratch<double, 64> local = gather(layout_.dofs[index], u);
    ask(model_, index, local, layout_.of(index, committed), layout_.of(index, trial), now);
    for (std::size_t q = 0; q < now.response.size(); ++q) {
      const model::Voigt strain = now.points.strain(static_cast<int>(q), d);
      model::Voigt stress{};
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) stress[i] += now.response[q].tangent[4 * i + j] * strain[j];
      model::add_stress(now.points, static_cast<int>(q), stress, local_force);
    }
    model::add_packed_product(now.stabilisation, d, local_force);
  });
}

// A point yields where its internal variables move.
std::vector<std::pair<std::string, double>> Yielding::facts(const fields::State& state) const {
  const std::span<const double> committed = state.committed(history_), trial = state.trial(history_);
  int yielding = 0;
  for (Index cell = 0; cell < model_.mesh.cell_count(); ++cell) {
    const auto own = static_cast<std::size_t>(model_.material(cell).internal_variables());
    const auto from = layout_.of(cell, committed), to = layout_.of(cell, trial);
    for (std::size_t q = 0; q * own < from.size(); ++q)
      yielding += std::ranges::equal(from.subspan(q * own, own), to.subspan(q * own, own)) ? 0 : 1;
  }
  return {{"yielding", yielding}};
}

void Yielding::add_results(const fields::State& state, model::StageResult& result) const {
  add_solid_results(model_, layout_, fields_, state.committed(displacement), state.committed(history_),
                    result);
}

}  // namespace ashlar::elasticity
