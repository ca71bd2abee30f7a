#pragma once
// The elastic stiffness of a square of n × n cells, clamped along its first points.

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>

#include "elasticity/bulk.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/vem.hpp"

namespace ashlar::benchmarks {

using mesh::Index;

inline void complete(model::Model& model) {
  model.mesh.cell_region.assign(static_cast<std::size_t>(model.mesh.cell_count()), 0);
  model.materials = {std::make_shared<elasticity::Elastic>(1e10, 0.3, model.plane)};
  model.element =
      std::make_shared<elasticity::VemElement>(std::make_shared<elasticity::BendingStabilisation>());
  model.dofs = fields::DofMap(model.mesh, {"displacement", "m"});
}

/// n × n quadrilaterals, numbered row by row.
inline model::Model quads(Index n) {
  model::Model model;
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x <= n; ++x) model.mesh.points.push_back({1.0 * x / n, 1.0 * y / n});
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index a = y * (n + 1) + x;
      model.mesh.cell_points.append(std::array{a, a + 1, a + n + 2, a + n + 1});
    }
  complete(model);
  return model;
}

/// n × n bricks, each row shifted by half a brick: three cells meet at a point, as in Voronoi meshes. Points
/// are numbered at random, so that no ordering profits from a tidy numbering.
inline model::Model bricks(Index n) {
  model::Model model;
  const Index width = 2 * n + 2;
  std::vector<Index> number(static_cast<std::size_t>(width) * (n + 1));
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), std::mt19937(5));
  // Two corners belong to no brick: they become the first points, which are held.
  const Index unused[] = {width - 1, n * width + (n % 2 == 0 ? 0 : width - 1)};
  for (Index k = 0; k < 2; ++k) std::swap(number[unused[k]], *std::find(number.begin(), number.end(), k));
  model.mesh.points.resize(number.size());
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x < width; ++x) model.mesh.points[number[y * width + x]] = {0.5 * x / n, 1.0 * y / n};
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index a = y * width + 2 * x + y % 2, b = a + width;
      model.mesh.cell_points.append(
          std::array{number[a], number[a + 1], number[a + 2], number[b + 2], number[b + 1], number[b]});
    }
  complete(model);
  return model;
}

/// Dofs renumbered without those of the bottom row of points.
inline algebra::Adjacency unknowns_of(const algebra::Adjacency& dofs, Index held) {
  std::vector<Index> offsets(dofs.offsets().begin(), dofs.offsets().end());
  std::vector<Index> values(dofs.values().begin(), dofs.values().end());
  for (Index& value : values) value = std::max(value - held, Index{-1});
  return {std::move(offsets), std::move(values)};
}

struct System {
  /// The first `held_points` points are held.
  System(model::Model made, Index held_points)
      : model(std::move(made)),
        bulk(model, {}),
        held(2 * held_points),
        groups(unknowns_of(bulk.groups(), held)),
        unknowns(model.dofs.size() - held) {}

  model::Model model;
  elasticity::Bulk bulk;
  Index held;
  algebra::Adjacency groups;
  Index unknowns;
};

}  // namespace ashlar::benchmarks
