#include "elasticity/bulk.hpp"

#include <algorithm>
#include <cassert>

#include "algebra/assemble.hpp"
#include "elasticity/cell_access.hpp"
#include "elasticity/exact.hpp"
#include "elasticity/recovery.hpp"
#include "elasticity/section.hpp"
#include "elasticity/utilisation.hpp"
#include "model/results.hpp"

namespace ashlar::elasticity {

using model::FieldResult;
using model::Model;

namespace {

/// What the scene's outputs and probes ask for; everything if the outputs do not say. A probe reads at
/// points.
std::set<std::string> wanted_fields(const model::Scene& scene) {
  const core::Settings::Entry* fields = scene.outputs.find("fields");
  if (!fields || !fields->value.table()) return all_fields;
  std::set<std::string> wanted;
  const auto want = [&](const std::string& name) {
    if (all_fields.contains(name)) wanted.insert(name);
  };
  for (const core::Value& item : fields->value.table()->items)
    if (item.text()) want(*item.text());
  for (const model::ProbeData& probe : scene.probes)
    for (const std::string& quantity : probe.quantities)
      want(all_fields.contains(quantity + "_nodes") ? quantity + "_nodes" : quantity);
  return wanted;
}

using On = FieldResult::On;

FieldResult displacement_field(const Model& model, std::span<const double> u) {
  FieldResult field{"displacement", "m", On::points, 2, {"x", "y"}, {}};
  field.values.assign(u.begin(), u.begin() + 2 * static_cast<std::ptrdiff_t>(model.mesh.point_count()));
  return field;
}

FieldResult strain_field(std::span<const model::Voigt> strain) {
  FieldResult field{"strain", "", On::cells, 3, {"xx", "yy", "gamma_xy"}, {}};
  for (const model::Voigt& e : strain) field.values.insert(field.values.end(), e.begin(), e.begin() + 3);
  return field;
}

/// Adds the wanted ones of stress, principal_stress, principal_angle and von_mises, each name + `suffix`.
void add_stress_fields(const std::set<std::string>& wanted, const std::string& suffix, On on,
                       std::span<const Stress> stress, std::vector<FieldResult>& fields) {
  const auto add = [&](const char* name, const char* unit, std::vector<std::string> components,
                       auto&& values) {
    if (!wanted.contains(name + suffix)) return;
    FieldResult field{name + suffix,         unit, on, static_cast<int>(components.size()),
                      std::move(components), {}};
    field.values.reserve(stress.size() * static_cast<std::size_t>(field.width));
    for (const Stress& s : stress) values(s, field.values);
    fields.push_back(std::move(field));
  };
  using Values = std::vector<double>;
  add("stress", "Pa", {"xx", "yy", "xy", "zz"},
      [](const Stress& s, Values& values) { values.insert(values.end(), s.begin(), s.end()); });
  add("principal_stress", "Pa", {"1", "3"}, [](const Stress& s, Values& values) {
    const Principal p = principal(s);
    values.insert(values.end(), {p.s1, p.s3});
  });
  add("principal_angle", "deg", {"angle"},
      [](const Stress& s, Values& values) { values.push_back(principal(s).angle); });
  add("von_mises", "Pa", {"von_mises"},
      [](const Stress& s, Values& values) { values.push_back(von_mises(s)); });
}

}  // namespace

Bulk::Bulk(const Model& model, std::set<std::string> fields, const model::Scene* scene)
    : Stiffness("elasticity"), model_(model), fields_(std::move(fields)), scene_(scene), layout_(model) {}

void Bulk::add_tangent(const algebra::ScatterMap& map, std::span<double> value) const {
  algebra::assemble(map, value, [this](Index index, std::span<double> packed) {
    with_cell(model_, index, [&](const model::Cell& cell) {
      model_.element->stiffness(cell, model_.material(index), packed);
    });
  });
}

void Bulk::add_internal_force(std::span<const double> u, std::span<double> force) const {
  algebra::assemble(layout_.dofs, force, [&](Index index, std::span<double> local_force) {
    const Scratch<double, 64> local = gather(layout_.dofs[index], u);
    std::fill(local_force.begin(), local_force.end(), 0.0);
    with_cell(model_, index, [&](const model::Cell& cell) {
      model_.element->add_internal_force(cell, model_.material(index), local, local_force);
    });
  });
}

std::size_t Bulk::bytes() const {
  return layout_.bytes();
}

void Bulk::add_group_force(const fields::State& state, Index cell, std::span<double> force) const {
  add_cell_force(model_, layout_, cell, state.committed(state.find("displacement")), {}, force);
}

void Bulk::add_results(const fields::State& state, model::StageResult& result) const {
  const fields::State::Id id = state.find("displacement");
  assert(id >= 0);
  add_solid_results(model_, layout_, fields_, state.committed(id), {}, result);
  if (scene_) add_norms(model_, layout_, *scene_, state.committed(id), {}, result);
}

void add_solid_results(const Model& model, const Layout& layout, const std::set<std::string>& fields,
                       std::span<const double> u, std::span<const double> history,
                       model::StageResult& result) {
  const auto asked = [&](auto&& belongs) { return std::any_of(fields.begin(), fields.end(), belongs); };
  const bool at_points = asked([](const std::string& name) { return name.ends_with("_nodes"); });
  const bool in_cells =
      asked([](const std::string& name) { return name != "displacement" && !name.ends_with("_nodes"); });
  if (fields.contains("displacement")) result.fields.push_back(displacement_field(model, u));
  if (!at_points && !in_cells && model.sections.empty()) return;
  const CellStresses cells = cell_stresses(model, layout, u, history);
  add_section_profiles(model, cells, u, result);
  if (fields.contains("strain")) result.fields.push_back(strain_field(cells.strain));
  add_stress_fields(fields, "", On::cells, cells.stress, result.fields);
  if (at_points)
    add_stress_fields(fields, "_nodes", On::points, recover_at_points(model, cells), result.fields);
  add_utilisation(model, cells, fields, result);
}

void Elasticity::contribute(const model::StageContext& context, model::Terms& terms) {
  if (!bulk_ && !yielding_) {
    warn_of_no_strength(context.scene, context.model);
    if (std::ranges::all_of(context.model.materials, [](const auto& law) { return law->linear(); }))
      bulk_ = std::make_shared<Bulk>(context.model, wanted_fields(context.scene), &context.scene);
    else
      yielding_ = std::make_shared<Yielding>(context.model, Layout(context.model), context.scene,
                                             wanted_fields(context.scene), context.state);
  }
  if (bulk_)
    terms.stiffness.push_back(bulk_);
  else
    terms.nonlinear.push_back(yielding_);
}

}  // namespace ashlar::elasticity
