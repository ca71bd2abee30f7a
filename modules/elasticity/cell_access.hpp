#pragma once
// One cell's corners and displacements, gathered on the stack.

#include "elasticity/scratch.hpp"
#include "model/model.hpp"

namespace ashlar::elasticity {

using mesh::Index;
using model::Point;

/// Calls use(cell) with the corners of one cell.
template <class Use>
void with_cell(const model::Model& model, Index index, Use&& use) {
  const auto points = model.mesh.cell_points[index];
  Scratch<Point> corners(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) corners[i] = model.mesh.points[points[i]];
  use(model.cell({corners.data(), corners.size()}));
}

inline Scratch<double, 64> gather(std::span<const Index> dofs, std::span<const double> u) {
  Scratch<double, 64> local(dofs.size());
  for (std::size_t k = 0; k < dofs.size(); ++k) local[k] = u[dofs[k]];
  return local;
}

}  // namespace ashlar::elasticity
