#include "loads/point_loads.hpp"

#include <algorithm>

#include "core/log.hpp"

namespace ashlar::loads {

namespace {

using geometry::Index;
using geometry::Point;

/// The longest edge at a point [m].
double edge_length(const mesh::Mesh& mesh, Index point) {
  double longest = 0;
  for (const auto& [from, to] : mesh.edge_points)
    if (from == point || to == point)
      longest = std::max(longest, geometry::distance(mesh.points[from], mesh.points[to]));
  return longest;
}

Index point_at(const model::Model& model, Point at, const core::Place& place, const std::string& lip = {}) {
  const Index point = mesh::nearest_point(model.mesh, at, lip);
  const double away = geometry::distance(at, model.mesh.points[point]);
  if (away > edge_length(model.mesh, point))
    core::log().warning(core::to_string(place) + ": the nearest mesh point is " +
                        core::format_quantity(away, {1, 0, 0}) +
                        " away, outside the body or beyond a coarse mesh");
  return point;
}

}  // namespace

void add_force(const core::Settings& force, const model::Model& model, std::span<double> forces) {
  const auto [x, y] = force.point("at");
  const Index point = point_at(model, {x, y}, force.place_of("at"), force.text("lip"));
  const Index dof = model.dofs.of_point(point);
  forces[dof] += force.number("x", 0);
  forces[dof + 1] += force.number("y", 0);
}

void add_couple(const core::Settings& couple, const model::Model& model, std::span<double> forces,
                core::Mistakes& mistakes) {
  std::array<Index, 2> point;
  for (int end = 0; end < 2; ++end) {
    const core::Value& place = couple.value("between").table()->items[end];
    const core::Table& pair = *place.table();
    const Point at{pair.items[0].quantity()->value, pair.items[1].quantity()->value};
    point[end] = point_at(model, at, place.place);
  }
  const Point arm = model.mesh.points[point[1]] - model.mesh.points[point[0]];
  const double square = geometry::dot(arm, arm);
  if (square == 0) {
    mistakes.add(couple.place_of("between"), "both places of the couple have the same nearest mesh point",
                 "move them apart, or refine the mesh there");
    return;
  }
  const Point f = (couple.number("moment") / square) * geometry::left_of(arm);
  const Index a = model.dofs.of_point(point[0]), b = model.dofs.of_point(point[1]);
  forces[a] -= f.x;
  forces[a + 1] -= f.y;
  forces[b] += f.x;
  forces[b + 1] += f.y;
}

}  // namespace ashlar::loads
