#include "loads/point_loads.hpp"

#include "model/place.hpp"

namespace ashlar::loads {

using geometry::Index;
using geometry::Point;

void add_force(const core::Settings& force, const model::Model& model, std::span<double> forces,
               core::Mistakes& mistakes) {
  const auto [x, y] = force.point("at");
  const Index point =
      model::point_at(model.mesh, {{x, y}, force.text("lip"), force.place_of("at")}, mistakes);
  if (point < 0) return;
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
    point[end] = model::point_at(model.mesh, {at, {}, place.place}, mistakes);
    if (point[end] < 0) return;
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
