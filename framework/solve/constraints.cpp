#include <algorithm>
#include <cmath>
#include <optional>

#include "solve/build.hpp"

namespace ashlar::solve {

using geometry::Point;
using mesh::Index;

namespace {

/// Mesh points and edges that one support holds.
struct Held {
  std::vector<Index> points, edges;
};

Held find_held(const model::Model& model, const model::SupportData& support, core::Mistakes& mistakes) {
  const mesh::Mesh& mesh = model.mesh;
  Held held;
  if (!support.edge.empty()) {
    const auto group = mesh.edge_groups.find(support.edge);
    if (group == mesh.edge_groups.end() || group->second.empty()) {
      mistakes.add(support.place, "the mesh has no edges named '" + support.edge + "'",
                   core::did_you_mean(support.edge, mesh::edge_group_names(mesh)));
      return held;
    }
    held.edges = group->second;
    for (const Index edge : held.edges)
      held.points.insert(held.points.end(), mesh.edge_points[edge].begin(), mesh.edge_points[edge].end());
  } else if (support.at) {
    held.points = {mesh::nearest_point(mesh, *support.at)};
  } else if (support.box) {
    const auto [a, b] = *support.box;
    const double slack = 1e-9 * model.length;
    for (Index p = 0; p < mesh.point_count(); ++p) {
      const Point at = mesh.points[p];
      if (at.x >= std::min(a.x, b.x) - slack && at.x <= std::max(a.x, b.x) + slack &&
          at.y >= std::min(a.y, b.y) - slack && at.y <= std::max(a.y, b.y) + slack)
        held.points.push_back(p);
    }
    if (held.points.empty()) mistakes.add(support.place, "no mesh point lies in this box");
  }
  std::sort(held.points.begin(), held.points.end());
  held.points.erase(std::unique(held.points.begin(), held.points.end()), held.points.end());
  return held;
}

/// The prescribed displacement of one component at a place; nothing: held where it is.
std::optional<double> moved_to(const core::Value& value, Point at) {
  if (value.is_nothing()) return {};
  if (const core::Quantity* number = value.quantity()) return number->value;
  const std::array<double, 2> arguments{at.x, at.y};
  return value.function()->call(arguments).at(0);
}

struct Hold {
  model::Constraints& constraints;
  core::Mistakes& mistakes;
  std::vector<char> clashed;

  void at(Index dof, std::optional<double> value, const model::SupportData& support, Point place) {
    const bool clash = constraints.value[dof] != value.value_or(0);
    if (constraints.held[dof] && clash && !clashed[dof]) {
      clashed[dof] = 1;
      mistakes.add(support.place, "the point (" + core::format_quantity(place.x, {1, 0, 0}) + ", " +
                                      core::format_quantity(place.y, {1, 0, 0}) +
                                      ") is held at two different displacements");
    }
    constraints.in_place[dof] = !value && (!constraints.held[dof] || constraints.in_place[dof]);
    constraints.held[dof] = 1;
    constraints.value[dof] = value.value_or(0);
  }
};

}  // namespace

model::Constraints build_constraints(const model::Model& model, const model::StageData& stage,
                                     core::Mistakes& mistakes) {
  model::Constraints constraints;
  const Index size = model.dofs.size();
  constraints.held.assign(size, 0);
  constraints.value.assign(size, 0);
  constraints.in_place.assign(size, 0);
  Hold hold{constraints, mistakes, std::vector<char>(size)};
  for (const auto& support : stage.supports) {
    const Held held = find_held(model, support, mistakes);
    for (int c = 0; c < 2; ++c) {
      if (!support.move[c]) continue;
      for (const Index point : held.points) {
        const Point at = model.mesh.points[point];
        hold.at(model.dofs.of_point(point) + c, moved_to(*support.move[c], at), support, at);
      }
      for (const Index edge : held.edges)
        for (int k = 0; k < model.dofs.field().per_edge; ++k) {
          const auto [from, to] = model.mesh.edge_points[edge];
          const double t = (k + 1.0) / (model.dofs.field().per_edge + 1);
          const Point at = (1 - t) * model.mesh.points[from] + t * model.mesh.points[to];
          hold.at(model.dofs.of_edge(edge, k) + c, moved_to(*support.move[c], at), support, at);
        }
    }
  }
  constraints.unknown.assign(size, -1);
  for (Index dof = 0; dof < size; ++dof)
    if (!constraints.held[dof]) {
      constraints.unknown[dof] = constraints.unknowns();
      constraints.dof.push_back(dof);
    }
  return constraints;
}

}  // namespace ashlar::solve
