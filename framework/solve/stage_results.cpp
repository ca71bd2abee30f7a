#include "solve/stage_results.hpp"

#include <algorithm>
#include <cmath>

#include "core/log.hpp"
#include "geometry/polygon.hpp"
#include "solve/local.hpp"

namespace ashlar::solve {

using geometry::Index;
using geometry::Point;
using model::FieldResult;

namespace {

/// By node: what rigid motions give it. The virtual work of nodal forces on them is their resultant.
std::vector<model::RigidValue> rigid_values(const model::Model& model) {
  const mesh::Mesh& mesh = model.mesh;
  std::vector<model::RigidValue> values;
  values.reserve(static_cast<std::size_t>(model.dofs.size() / 2));
  for (const Point at : mesh.points) values.push_back({1, at});
  for (const auto& [from, to] : mesh.edge_points)
    for (int k = 0; k < model.dofs.field().per_edge; ++k) {
      const double t = model.element->edge_node(k);
      values.push_back({1, (1 - t) * mesh.points[from] + t * mesh.points[to]});
    }
  std::vector<Point> corners;
  std::vector<model::RigidValue> own(static_cast<std::size_t>(model.dofs.field().per_cell));
  for (Index cell = 0; cell < mesh.cell_count() && !own.empty(); ++cell) {
    mesh.corners(cell, corners);
    model.element->rigid_values(model.cell(corners), own);
    values.insert(values.end(), own.begin(), own.end());
  }
  return values;
}

/// The resultant of a nodal force at a dof.
model::Resultant nodal_force(const std::vector<model::RigidValue>& rigid, Index dof, double force,
                             Point about) {
  const model::RigidValue& node = rigid[static_cast<std::size_t>(dof / 2)];
  const Point arm = node.place - node.translation * about;
  if (dof % 2 == 0) return {node.translation * force, 0, -arm.y * force};
  return {0, node.translation * force, arm.x * force};
}

void add(model::Resultant& sum, const model::Resultant& part) {
  sum.x += part.x;
  sum.y += part.y;
  sum.moment += part.moment;
}

/// "ux" for the displacement; "sxx" for nodal stresses, "s1" for nodal principal stresses.
std::string component_name(const FieldResult& field, int component) {
  const std::string& part = field.components[component];
  if (field.name == "displacement") return "u" + part;
  if (field.name.starts_with("stress") || field.name.starts_with("principal_stress")) return "s" + part;
  if (field.name.starts_with("strain")) return "e" + part;
  return field.width == 1 ? field.name : field.name + "_" + part;
}

/// A probe reads at points: "von_mises_nodes" is its "von_mises".
std::string probe_name(const FieldResult& field, int component) {
  std::string name = component_name(field, component);
  if (name.ends_with("_nodes")) name.resize(name.size() - std::string_view("_nodes").size());
  return name;
}

/// The regions of the cells around a point.
std::vector<Index> regions_at(const mesh::Mesh& mesh, Index point) {
  std::vector<Index> regions;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (std::ranges::count(mesh.cell_points[cell], point) > 0 &&
        std::ranges::count(regions, mesh.cell_region[cell]) == 0)
      regions.push_back(mesh.cell_region[cell]);
  return regions;
}

/// "stress" asks for the nodal field too, which bears the word with "_nodes".
bool asked_for(const model::ProbeData& probe, const std::string& field) {
  return std::ranges::any_of(
      probe.quantities, [&](const std::string& word) { return field == word || field == word + "_nodes"; });
}

/// Radial forces and their moments cancel around the axis of revolution.
void keep_axial(model::Balance& sums, model::Resultant& left) {
  const auto keep = [](model::Resultant& r) { r.x = r.moment = 0; };
  for (auto& [name, resultant] : sums.loads) keep(resultant);
  for (auto& [name, resultant] : sums.reactions) keep(resultant);
  for (model::Resultant* each : {&sums.load, &sums.reaction, &left}) keep(*each);
}

}  // namespace

model::Balance balance(const model::Model& model, const model::StageData& stage, const StageForces& forces) {
  model::Balance sums;
  double absolute = 0;
  const std::vector<model::RigidValue> rigid = rigid_values(model);
  // The error is summed about a point of the body: moments about a far origin would drown it in round-off.
  const Point inside = model.mesh.points.front();
  model::Resultant left;
  const auto add_load = [&](const std::string& name, const std::vector<double>& force) {
    model::Resultant resultant;
    for (Index dof = 0; dof < model.dofs.size(); ++dof) {
      if (force[dof] == 0) continue;
      add(resultant, nodal_force(rigid, dof, force[dof], {}));
      add(left, nodal_force(rigid, dof, force[dof], inside));
    }
    add(sums.load, resultant);
    sums.loads.emplace_back(name, resultant);
  };
  for (const auto& load : forces.terms.loads) {
    std::vector<double> force(model.dofs.size());
    load->add_force(force);
    for (const double f : force) absolute += std::abs(f);
    add_load(load->effect(), force);
  }
  // Drawn where they were, bodies that have moved along each other press with a moment.
  for (const auto& term : forces.terms.local)
    if (term->follows()) {
      std::vector<double> force(model.dofs.size());
      add_force(*term, forces.state, force);
      for (double& f : force) f = -f;  // from the joints on the bodies
      add_load(term->effect() + " (moved)", force);
    }
  std::vector<model::Resultant> reactions(stage.supports.size());
  double reaction_absolute = 0;
  for (Index dof = 0; dof < model.dofs.size(); ++dof) {
    if (!forces.constraints.held[dof]) continue;
    if (forces.constraints.support[dof] < 0) continue;  // the axis of revolution
    const double reaction = forces.out_of_balance[dof];
    add(reactions[forces.constraints.support[dof]], nodal_force(rigid, dof, reaction, {}));
    add(left, nodal_force(rigid, dof, reaction, inside));
    reaction_absolute += std::abs(forces.out_of_balance[dof]);
  }
  for (std::size_t s = 0; s < reactions.size(); ++s) {
    const model::Resultant& each = reactions[s];
    if (each.x == 0 && each.y == 0) continue;
    add(sums.reaction, each);
    sums.reactions.emplace_back(stage.supports[s].name, each);
  }
  if (model.axisymmetric()) keep_axial(sums, left);
  // Without loads, reactions may be nothing but round-off.
  const double least = absolute > 0 ? absolute : forces.round_off_scale;
  const double scale = std::max({least, reaction_absolute, 1e-300});
  sums.relative_error = std::max(std::hypot(left.x, left.y), std::abs(left.moment) / model.length) / scale;
  return sums;
}

void add_probes(const model::Scene& scene, const model::Model& model, std::span<const Index> points,
                model::StageResult& result) {
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    const model::ProbeData& probe = scene.probes[p];
    const Index point = points[p];
    model::ProbeResult found{probe.name, probe.at, model.mesh.points[point], {}};
    for (const FieldResult& field : result.fields) {
      if (field.on != FieldResult::On::points || !asked_for(probe, field.name)) continue;
      for (int c = 0; c < field.width; ++c)
        found.values[probe_name(field, c)] = field.values[static_cast<std::size_t>(point) * field.width + c];
    }
    result.probes.push_back(std::move(found));
  }
}

void warn_of_unread(const model::Scene& scene, const model::StageResult& result) {
  for (const model::ProbeData& probe : scene.probes)
    for (const std::string& word : probe.quantities) {
      const bool there = std::ranges::any_of(result.fields, [&](const FieldResult& field) {
        return field.on == FieldResult::On::points && (field.name == word || field.name == word + "_nodes");
      });
      if (!there)
        core::log().warning(core::to_string(probe.place) + ": '" + word +
                            "' is known in cells only: the probe does not read it");
    }
}

void warn_of_mixed_probes(const model::Scene& scene, const model::Model& model,
                          std::span<const Index> points) {
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    const model::ProbeData& probe = scene.probes[p];
    if (std::ranges::all_of(probe.quantities, [](const std::string& q) { return q == "displacement"; }))
      continue;
    const std::vector<Index> regions = regions_at(model.mesh, points[p]);
    const auto differs = [&](Index region) {
      return !same_stiffness(*model.materials[region], *model.materials[regions.front()]);
    };
    if (std::ranges::none_of(regions, differs)) continue;
    std::string names;
    for (const Index region : regions)
      names += (names.empty() ? "'" : " and '") + scene.regions[region].name + "'";
    core::log().warning(core::to_string(probe.place) + ": the probe lies where the materials of " + names +
                        " meet: its stresses are the mean of all sides, which none of them has; place it a "
                        "cell's width inside the region that is meant, or read both sides by a section");
  }
}

void add_extremes(const model::Model& model, model::StageResult& result) {
  std::vector<Point> corners;
  const auto place = [&](const FieldResult& field, std::size_t entity) {
    if (field.on == FieldResult::On::points) return model.mesh.points[entity];
    return geometry::centroid(model.mesh.corners(static_cast<Index>(entity), corners));
  };
  for (const FieldResult& field : result.fields) {
    for (int c = 0; c < field.width; ++c) {
      const std::size_t count = field.values.size() / field.width;
      std::size_t least = 0, greatest = 0;
      const auto value = [&](std::size_t i) { return field.values[i * field.width + c]; };
      for (std::size_t i = 1; i < count; ++i) {
        if (value(i) < value(least)) least = i;
        if (value(i) > value(greatest)) greatest = i;
      }
      result.extremes.push_back({field.on == FieldResult::On::points ? component_name(field, c)
                                                                     : component_name(field, c) + " (cells)",
                                 field.unit, value(least), value(greatest), place(field, least),
                                 place(field, greatest)});
    }
  }
}

}  // namespace ashlar::solve
