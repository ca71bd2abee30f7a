#pragma once
// An elastic solid on a given mesh: hold and load its dofs, solve, look at stresses.

#include <functional>
#include <memory>

#include "elasticity/bulk.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/recovery.hpp"
#include "elasticity/vem.hpp"
#include "solve/advance.hpp"
#include "suitesparse/cholesky.hpp"

namespace ashlar::patch {

using geometry::Point;
using mesh::Index;

class Solid {
 public:
  Solid(mesh::Mesh mesh, const std::shared_ptr<const model::Material>& material,
        std::shared_ptr<const elasticity::Stabilisation> stabilisation =
            std::make_shared<elasticity::BendingStabilisation>())
      : Solid(std::move(mesh), material,
              std::static_pointer_cast<const model::Element>(
                  std::make_shared<elasticity::VemElement>(std::move(stabilisation)))) {}

  Solid(mesh::Mesh mesh, const std::shared_ptr<const model::Material>& material,
        std::shared_ptr<const model::Element> element, model::Plane plane = model::Plane::strain) {
    model.plane = plane;
    model.mesh = std::move(mesh);
    model.materials.assign(std::max<std::size_t>(1, model.mesh.regions.size()), material);
    model.element = std::move(element);
    const model::NodeCounts nodes = model.element->nodes();
    model.dofs =
        fields::DofMap(model.mesh, {"displacement", "m", 2, nodes.per_point, nodes.per_edge, nodes.per_cell});
    bulk = std::make_shared<elasticity::Bulk>(model, elasticity::all_fields);
    const auto size = static_cast<std::size_t>(model.dofs.size());
    load.assign(size, 0);
    constraints.held.assign(size, 0);
    constraints.value.assign(size, 0);
    state.add("displacement", size);
  }

  void hold(Index point, int component, double value) {
    hold_dof(model.dofs.of_point(point) + component, value);
  }

  void hold_dof(Index dof, double value) {
    constraints.held[dof] = 1;
    constraints.value[dof] = value;
  }

  /// Place of an edge's own node.
  Point edge_node(Index edge, int node) const {
    const auto [from, to] = model.mesh.edge_points[edge];
    const double t = model.element->edge_node(node);
    return (1 - t) * model.mesh.points[from] + t * model.mesh.points[to];
  }

  /// Holds all nodes of the border at a field.
  template <class Field>
  void hold_border(Field&& field) {
    for (Index edge = 0; edge < model.mesh.edge_count(); ++edge) {
      if (model.mesh.edge_cells[edge][1] >= 0) continue;
      const auto node = [&](Index dof, Point at) {
        const Point u = field(at);
        hold_dof(dof, u.x);
        hold_dof(dof + 1, u.y);
      };
      for (const Index point : model.mesh.edge_points[edge])
        node(model.dofs.of_point(point), model.mesh.points[point]);
      for (int k = 0; k < model.dofs.field().per_edge; ++k)
        node(model.dofs.of_edge(edge, k), edge_node(edge, k));
    }
  }

  /// Adds a constant body force [N/m³].
  void weigh(Point b) {
    std::vector<Point> corners;
    std::vector<double> force;
    const elasticity::Layout layout(model);
    for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
      const auto dofs = layout.dofs[cell];
      force.assign(dofs.size(), 0.0);
      model.element->add_body_force(model.cell(model.mesh.corners(cell, corners)), b, force);
      for (std::size_t i = 0; i < dofs.size(); ++i) load[dofs[i]] += force[i];
    }
  }

  /// Adds the nodal forces of a traction [Pa] on a straight border edge.
  void pull(Index edge, Point traction) {
    const auto [a, b] = model.mesh.edge_points[edge];
    const double half = 0.5 * model.thickness * distance(model.mesh.points[a], model.mesh.points[b]);
    for (const Index point : {a, b}) {
      load[model.dofs.of_point(point)] += half * traction.x;
      load[model.dofs.of_point(point) + 1] += half * traction.y;
    }
  }

  /// Equilibrium; the displacement by dof.
  std::span<const double> solve() {
    constraints.unknown.assign(constraints.held.size(), -1);
    constraints.dof.clear();
    for (Index dof = 0; dof < model.dofs.size(); ++dof)
      if (!constraints.held[dof]) {
        constraints.unknown[dof] = constraints.unknowns();
        constraints.dof.push_back(dof);
      }
    std::unique_ptr<algebra::LinearSolver> solver =
        std::make_unique<suitesparse::Cholesky>(suitesparse::Method::automatic);
    if (wrap) solver = wrap(std::move(solver));
    solve::Bulk factored(model, {{bulk}, {}}, constraints, {}, std::move(solver));
    failure = factored.report().reason;
    if (!factored.report().done) return {};
    solve::LocalTerms no_joints;
    report = solve::advance(factored, no_joints, constraints, {load, constraints.value}, state);
    state.commit();
    return state.committed(0);
  }

  Point displacement(Index point) const {
    const auto u = state.committed(0);
    return {u[model.dofs.of_point(point)], u[model.dofs.of_point(point) + 1]};
  }

  std::vector<Index> border_points() const {
    std::vector<Index> points;
    for (Index e = 0; e < model.mesh.edge_count(); ++e)
      if (model.mesh.edge_cells[e][1] < 0)
        points.insert(points.end(), model.mesh.edge_points[e].begin(), model.mesh.edge_points[e].end());
    return points;
  }

  model::Model model;
  std::shared_ptr<const elasticity::Bulk> bulk;
  model::Constraints constraints;
  std::vector<double> load;
  fields::State state;
  solve::StepReport report;
  std::string failure;
  /// Puts another solver around the own one.
  std::function<std::unique_ptr<algebra::LinearSolver>(std::unique_ptr<algebra::LinearSolver>)> wrap;
};

}  // namespace ashlar::patch
