#include "elasticity/bulk.hpp"

#include <cassert>

#include "algebra/assemble.hpp"
#include "elasticity/cell_access.hpp"
#include "elasticity/recovery.hpp"
#include "model/results.hpp"

namespace ashlar::elasticity {

using model::FieldResult;
using model::Model;

namespace {

/// What the scene's outputs ask for; everything if they do not say.
std::set<std::string> wanted_fields(const model::Scene& scene) {
  for (const auto& entry : scene.outputs.entries) {
    if (entry.key != "fields" || !entry.value.table()) continue;
    std::set<std::string> wanted;
    for (const core::Value& item : entry.value.table()->items)
      if (item.text() && all_fields.contains(*item.text())) wanted.insert(*item.text());
    return wanted;
  }
  return all_fields;
}

using On = FieldResult::On;

FieldResult displacement_field(const Model& model, std::span<const double> u) {
  FieldResult field{"displacement", "m", On::points, 2, {"x", "y"}, {}};
  field.values.assign(u.begin(), u.begin() + 2 * static_cast<std::ptrdiff_t>(model.mesh.point_count()));
  return field;
}

FieldResult strain_field(std::span<const model::Voigt> strain) {
  FieldResult field{"strain", "", On::cells, 3, {"xx", "yy", "gamma_xy"}, {}};
  for (const model::Voigt& e : strain) field.values.insert(field.values.end(), e.begin(), e.end());
  return field;
}

FieldResult stress_field(const std::string& name, On on, std::span<const Stress> stress) {
  FieldResult field{name, "Pa", on, 4, {"xx", "yy", "xy", "zz"}, {}};
  field.values.reserve(4 * stress.size());
  for (const Stress& s : stress) field.values.insert(field.values.end(), s.begin(), s.end());
  return field;
}

/// Two fields, since the angle has another unit: "principal_stress" and "principal_stress_angle".
void add_principal(const std::string& name, On on, std::span<const Stress> stress,
                   std::vector<FieldResult>& fields) {
  FieldResult values{name, "Pa", on, 3, {"s1", "s3", "von_mises"}, {}};
  FieldResult angle{name + "_angle", "deg", on, 1, {"angle"}, {}};
  for (const Stress& s : stress) {
    const Principal p = principal(s);
    values.values.insert(values.values.end(), {p.s1, p.s3, p.von_mises});
    angle.values.push_back(p.angle);
  }
  fields.push_back(std::move(values));
  fields.push_back(std::move(angle));
}

}  // namespace

Bulk::Bulk(const Model& model, std::set<std::string> fields)
    : Stiffness("elasticity"), model_(model), fields_(std::move(fields)) {
  std::vector<Index> dofs;
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    dofs.clear();
    model.dofs.append_cell(model.mesh, cell, dofs);
    dofs_.append(dofs);
  }
}

void Bulk::add_tangent(const algebra::ScatterMap& map, std::span<double> value) const {
  algebra::assemble(map, value, [this](Index index, std::span<double> packed) {
    with_cell(model_, index, [&](const model::Cell& cell) {
      model_.element->stiffness(cell, model_.material(index), packed);
    });
  });
}

void Bulk::add_internal_force(std::span<const double> u, std::span<double> force) const {
  algebra::assemble(dofs_, force, [&](Index index, std::span<double> local_force) {
    const Scratch<double, 64> local = gather(dofs_[index], u);
    std::fill(local_force.begin(), local_force.end(), 0.0);
    with_cell(model_, index, [&](const model::Cell& cell) {
      model_.element->add_internal_force(cell, model_.material(index), local, local_force);
    });
  });
}

std::size_t Bulk::bytes() const {
  return sizeof(Index) * (dofs_.offsets().size() + dofs_.values().size());
}

void Bulk::add_results(const fields::State& state, model::StageResult& result) const {
  const fields::State::Id id = state.find("displacement");
  assert(id >= 0);
  const std::span<const double> u = state.committed(id);
  const auto wanted = [&](const char* name) { return fields_.contains(name); };
  if (wanted("displacement")) result.fields.push_back(displacement_field(model_, u));

  const bool at_points = wanted("stress_nodes") || wanted("principal_stress_nodes");
  if (!at_points && !wanted("strain") && !wanted("stress") && !wanted("principal_stress")) return;
  const CellStresses cells = cell_stresses(model_, dofs_, u);
  if (wanted("strain")) result.fields.push_back(strain_field(cells.strain));
  if (wanted("stress")) result.fields.push_back(stress_field("stress", On::cells, cells.stress));
  if (wanted("principal_stress")) add_principal("principal_stress", On::cells, cells.stress, result.fields);
  if (!at_points) return;
  const std::vector<Stress> points = recover_at_points(model_, cells);
  if (wanted("stress_nodes")) result.fields.push_back(stress_field("stress_nodes", On::points, points));
  if (wanted("principal_stress_nodes"))
    add_principal("principal_stress_nodes", On::points, points, result.fields);
}

void Elasticity::contribute(const model::StageContext& context, model::Terms& terms) {
  if (!bulk_) bulk_ = std::make_shared<Bulk>(context.model, wanted_fields(context.scene));
  terms.stiffness.push_back(bulk_);
}

}  // namespace ashlar::elasticity
