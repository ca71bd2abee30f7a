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
            std::make_shared<elasticity::BendingStabilisation>()) {
    model.mesh = std::move(mesh);
    model.materials.assign(std::max<std::size_t>(1, model.mesh.regions.size()), material);
    model.element = std::make_shared<elasticity::VemElement>(std::move(stabilisation));
    model.dofs = fields::DofMap(model.mesh, {"displacement", "m"});
    bulk = std::make_shared<elasticity::Bulk>(model, elasticity::all_fields);
    const auto size = static_cast<std::size_t>(model.dofs.size());
    load.assign(size, 0);
    constraints.held.assign(size, 0);
    constraints.value.assign(size, 0);
    state.add("displacement", size);
  }

  void hold(Index point, int component, double value) {
    const Index dof = model.dofs.of_point(point) + component;
    constraints.held[dof] = 1;
    constraints.value[dof] = value;
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
    const solve::Bulk factored(model, {bulk}, constraints, {},
                               std::make_unique<suitesparse::Cholesky>(suitesparse::Method::automatic));
    failure = factored.report().reason;
    if (!factored.report().done) return {};
    report = solve::advance(factored, {}, constraints, {load, constraints.value}, state);
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
};

}  // namespace ashlar::patch
