#include <algorithm>
#include <cmath>
#include <optional>

#include "model/place.hpp"
#include "solve/build.hpp"

namespace ashlar::solve {

using geometry::Point;
using mesh::Index;

namespace {

/// Mesh points and edges that one support holds.
struct Held {
  std::vector<Index> points, edges;
};

/// A point support at a joint holds all its sides: any of the lips there finds the place.
std::string some_lip(const mesh::Mesh& mesh, Point at) {
  const Index nearest = mesh::nearest_point(mesh, at);
  for (const mesh::JointLips& joint : mesh.joints)
    for (int side = 0; side < 2; ++side)
      for (const mesh::LipEdge& edge : joint.lips[side])
        if (edge.from == nearest || edge.to == nearest) return joint.name + "." + joint.sides[side];
  return {};
}

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
    const Index point =
        model::point_at(mesh, {*support.at, some_lip(mesh, *support.at), support.place}, mistakes);
    if (point >= 0) held.points = model::points_together(mesh, point);
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
  return value.function()->number(arguments, {1, 0, 0});
}

struct Hold {
  model::Constraints& constraints;
  core::Mistakes& mistakes;
  std::vector<char> clashed;

  void at(Index dof, std::optional<double> value, const model::StageData& stage, int support, Point place) {
    model::Constraints& c = constraints;
    const bool clash = value && c.at_value[dof] && c.value[dof] != *value;
    if (clash && !clashed[dof]) {
      clashed[dof] = 1;
      mistakes.add(stage.supports[support].place,
                   "the point " + model::place_text(place) + " is held at two different displacements");
    }
    if (!c.held[dof]) c.support[dof] = support;
    c.held[dof] = 1;
    if (value) {
      c.at_value[dof] = 1;
      c.value[dof] = *value;
    } else {
      c.in_place[dof] = 1;
    }
  }
};

/// Nothing on the axis of revolution moves off it. No support bears that: `support` stays -1.
void hold_axis(const model::Model& model, model::Constraints& constraints) {
  const auto hold_x = [&](Index dof) {
    if (!constraints.held[dof]) constraints.held[dof] = constraints.at_value[dof] = 1;
  };
  const auto on_axis = [&](Index p) { return std::abs(model.mesh.points[p].x) <= 1e-12 * model.length; };
  for (Index p = 0; p < model.mesh.point_count(); ++p)
    if (on_axis(p)) hold_x(model.dofs.of_point(p));
  for (Index edge = 0; edge < model.mesh.edge_count(); ++edge)
    if (on_axis(model.mesh.edge_points[edge][0]) && on_axis(model.mesh.edge_points[edge][1]))
      for (int k = 0; k < model.dofs.field().per_edge; ++k) hold_x(model.dofs.of_edge(edge, k));
}

}  // namespace

model::Constraints build_constraints(const model::Model& model, const model::StageData& stage,
                                     core::Mistakes& mistakes) {
  model::Constraints constraints;
  const Index size = model.dofs.size();
  constraints.held.assign(size, 0);
  constraints.value.assign(size, 0);
  constraints.in_place.assign(size, 0);
  constraints.at_value.assign(size, 0);
  constraints.support.assign(size, -1);
  Hold hold{constraints, mistakes, std::vector<char>(size)};
  for (int s = 0; s < static_cast<int>(stage.supports.size()); ++s) {
    const model::SupportData& support = stage.supports[s];
    const Held held = find_held(model, support, mistakes);
    for (int c = 0; c < 2; ++c) {
      if (!support.move[c]) continue;
      for (const Index point : held.points) {
        const Point at = model.mesh.points[point];
        hold.at(model.dofs.of_point(point) + c, moved_to(*support.move[c], at), stage, s, at);
      }
      for (const Index edge : held.edges)
        for (int k = 0; k < model.dofs.field().per_edge; ++k) {
          const auto [from, to] = model.mesh.edge_points[edge];
          const double t = model.element->edge_node(k);
          const Point at = (1 - t) * model.mesh.points[from] + t * model.mesh.points[to];
          hold.at(model.dofs.of_edge(edge, k) + c, moved_to(*support.move[c], at), stage, s, at);
        }
    }
  }
  if (model.axisymmetric()) hold_axis(model, constraints);
  constraints.unknown.assign(size, -1);
  for (Index dof = 0; dof < size; ++dof)
    if (!constraints.held[dof]) {
      constraints.unknown[dof] = constraints.unknowns();
      constraints.dof.push_back(dof);
    }
  return constraints;
}

}  // namespace ashlar::solve
