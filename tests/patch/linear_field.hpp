#pragma once
// The patch test: a linear displacement prescribed on the border must come out exactly inside.

#include <gtest/gtest.h>

#include "patch/solid.hpp"

namespace ashlar::patch {

/// A general linear displacement; strains of about 1e-3.
inline Point linear_field(Point p) {
  return {2e-4 + 1e-3 * p.x - 6e-4 * p.y, -3e-4 + 8e-4 * p.x - 4e-4 * p.y};
}
constexpr model::Voigt linear_strain = {1e-3, -4e-4, 2e-4, 0};
constexpr double greatest_displacement = 1.5e-3;

/// 1e-12: a system of some hundred unknowns solved in double precision, its condition number in hand.
inline void expect_exact(Solid& solid, double tolerance = 1e-12) {
  const mesh::Mesh& mesh = solid.model.mesh;
  for (const Index point : solid.border_points()) {
    const Point u = linear_field(mesh.points[point]);
    solid.hold(point, 0, u.x);
    solid.hold(point, 1, u.y);
  }
  ASSERT_FALSE(solid.solve().empty()) << solid.failure;
  double error = 0;
  for (Index p = 0; p < mesh.point_count(); ++p)
    error = std::max(error, distance(solid.displacement(p), linear_field(mesh.points[p])));
  EXPECT_LT(error, tolerance * greatest_displacement);

  const auto exact = solid.model.material(0).respond(linear_strain, {}, {});
  const elasticity::Stress stress = exact.stress;
  double scale = 0, cell_error = 0, point_error = 0;
  for (const double s : stress) scale = std::max(scale, std::abs(s));
  const auto cells =
      elasticity::cell_stresses(solid.model, elasticity::Layout(solid.model), solid.state.committed(0));
  const auto points = elasticity::recover_at_points(solid.model, cells);
  for (int k = 0; k < 4; ++k) {
    for (const auto& s : cells.stress) cell_error = std::max(cell_error, std::abs(s[k] - stress[k]));
    for (const auto& s : points) point_error = std::max(point_error, std::abs(s[k] - stress[k]));
  }
  // Stresses differentiate over a cell: the error of displacements grows by the number of cells across.
  EXPECT_LT(cell_error, 100 * tolerance * scale);
  EXPECT_LT(point_error, 100 * tolerance * scale);
}

}  // namespace ashlar::patch
