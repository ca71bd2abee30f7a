#include "elasticity/yielding.hpp"

#include <algorithm>
#include <cassert>

#include "algebra/assemble.hpp"
#include "core/parallel.hpp"
#include "elasticity/bulk.hpp"
#include "elasticity/cell_access.hpp"
#include "elasticity/exact.hpp"
#include "elasticity/section.hpp"

namespace ashlar::elasticity {

/// One cell at the trial state. Kept from cell to cell.
struct CellNow {
  const CellOperators* operators = nullptr;
  std::vector<model::Response> response;
};

namespace {

constexpr fields::State::Id displacement = 0;

/// Operators of all cells are kept up to this size: they cost more time to make than all else in a cell.
constexpr std::size_t most_bytes = std::size_t{512} << 20;

void make_operators(const model::Model& model, Index index, CellOperators& made) {
  with_cell(model, index, [&](const model::Cell& cell) {
    model.element->integrate(cell, made.points);
    made.rest.clear();
    if (!model.element->stabilised()) return;
    const auto n = static_cast<std::size_t>(made.points.dofs());
    made.rest.assign(n * (n + 1) / 2, 0.0);
    model.element->add_stabilisation(cell, model.material(index), made.rest);
  });
}

model::Tangent transposed(const model::Tangent& tangent) {
  model::Tangent t;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) t[4 * i + j] = tangent[4 * j + i];
  return t;
}

/// Packed lower triangle of a cell's tangent, or of its transposed.
void pack(const CellNow& now, bool transpose, std::span<double> packed) {
  std::fill(packed.begin(), packed.end(), 0.0);
  std::ranges::copy(now.operators->rest, packed.begin());
  for (std::size_t q = 0; q < now.response.size(); ++q)
    model::add_tangent(now.operators->points, static_cast<int>(q),
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

Yielding::Yielding(const model::Model& model, Layout layout, const model::Scene& scene,
                   std::set<std::string> fields, fields::State& state)
    : Nonlinear("elasticity"),
      model_(model),
      layout_(std::move(layout)),
      scene_(scene),
      fields_(std::move(fields)),
      history_(state.add("elasticity.history", layout_.history.back())) {
  keep_operators();
}

void Yielding::keep_operators() {
  const auto count = static_cast<std::size_t>(model_.mesh.cell_count());
  std::size_t bytes = 0;
  for (Index cell = 0; cell < model_.mesh.cell_count(); ++cell) {
    const auto at = static_cast<std::size_t>(cell);
    const std::size_t dofs = layout_.dofs[cell].size(), points = layout_.point[at + 1] - layout_.point[at];
    const std::size_t rest = model_.element->stabilised() ? dofs * (dofs + 1) / 2 : 0;
    bytes += sizeof(CellOperators) + sizeof(double) * (points * (4 * dofs + 3) + rest);
  }
  if (bytes > most_bytes) return;
  kept_bytes_ = bytes;
  kept_.resize(count);
  core::parallel_for(count, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) make_operators(model_, static_cast<Index>(c), kept_[c]);
  });
}

const CellOperators& Yielding::operators(Index cell) const {
  if (!kept_.empty()) return kept_[static_cast<std::size_t>(cell)];
  thread_local CellOperators made;
  make_operators(model_, cell, made);
  return made;
}

CellNow& Yielding::ask(Index index, std::span<const double> u, fields::State& state) const {
  thread_local CellNow now;
  const model::Material& law = model_.material(index);
  const auto own = static_cast<std::size_t>(law.internal_variables());
  const auto committed = layout_.of(index, std::span<const double>(state.committed(history_)));
  const auto trial = layout_.of(index, state.trial(history_));
  now.operators = &operators(index);
  const model::IntegrationPoints& points = now.operators->points;
  now.response.assign(static_cast<std::size_t>(points.size()), {});
  for (std::size_t q = 0; q < now.response.size(); ++q) {
    const auto before = committed.subspan(q * own, own);
    const auto after = trial.subspan(q * own, own);
    if (points.weight[q] == 0)
      std::ranges::copy(before, after.begin());
    else
      now.response[q] = law.respond(points.strain(static_cast<int>(q), u), before, after);
  }
  return now;
}

void Yielding::add_internal_force(fields::State& state, std::span<double> force) const {
  const std::span<const double> u = state.trial(displacement);
  algebra::assemble(layout_.dofs, force, [&](Index index, std::span<double> local_force) {
    const Scratch<double, 64> local = gather(layout_.dofs[index], u);
    const CellNow& now = ask(index, local, state);
    std::fill(local_force.begin(), local_force.end(), 0.0);
    for (std::size_t q = 0; q < now.response.size(); ++q)
      model::add_stress(now.operators->points, static_cast<int>(q), now.response[q].stress, local_force);
    if (!now.operators->rest.empty()) model::add_packed_product(now.operators->rest, local, local_force);
  });
}

void Yielding::add_tangent(fields::State& state, const algebra::ScatterMap& map, std::span<double> lower,
                           std::span<double> upper) const {
  const std::span<const double> u = state.trial(displacement);
  const auto add = [&](bool into_upper, std::span<double> target) {
    algebra::assemble(map, target, [&](Index index, std::span<double> packed) {
      const Scratch<double, 64> local = gather(layout_.dofs[index], u);
      const CellNow& now = ask(index, local, state);
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
  algebra::assemble(layout_.dofs, force, [&](Index index, std::span<double> local_force) {
    std::fill(local_force.begin(), local_force.end(), 0.0);
    const Scratch<double, 64> along = gather(layout_.dofs[index], direction);
    const std::span<const double> d = along;
    if (std::ranges::all_of(d, [](double v) { return v == 0; })) return;
    const Scratch<double, 64> local = gather(layout_.dofs[index], u);
    const CellNow& now = ask(index, local, state);
    for (std::size_t q = 0; q < now.response.size(); ++q) {
      const model::Voigt strain = now.operators->points.strain(static_cast<int>(q), d);
      model::Voigt stress{};
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) stress[i] += now.response[q].tangent[4 * i + j] * strain[j];
      model::add_stress(now.operators->points, static_cast<int>(q), stress, local_force);
    }
    if (!now.operators->rest.empty()) model::add_packed_product(now.operators->rest, d, local_force);
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

void Yielding::add_group_force(const fields::State& state, Index cell, std::span<double> force) const {
  add_cell_force(model_, layout_, cell, state.committed(displacement), state.committed(history_), force);
}

void Yielding::add_results(const fields::State& state, model::StageResult& result) const {
  const auto u = state.committed(displacement), history = state.committed(history_);
  add_solid_results(model_, layout_, fields_, u, history, result);
  add_norms(model_, layout_, scene_, u, history, result);
}

}  // namespace ashlar::elasticity
