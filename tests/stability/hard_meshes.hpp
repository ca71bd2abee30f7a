#pragma once
// Meshes that are harder than testing/meshes.hpp: one given cell in a square, cells joined to odd shapes,
// copies that are stretched, turned, moved and renumbered.

#include <functional>
#include <span>

#include "mesh/mesh.hpp"

namespace ashlar::stability {

using geometry::Point;
using mesh::Index;

/// A mesh whose border is where it is; no domain to conform to.
mesh::Mesh bare(mesh::RawMesh raw);

/// The unit square with a cell in its middle and a ring of cells around it. `ring` turns counter-clockwise
/// around (0, 0), is seen from there, and lies within 0.4; corner i is joined with the border at `angle(i)`.
mesh::RawMesh around(std::span<const Point> ring, const std::function<double(std::size_t)>& angle);
/// A regular cell of n corners in a square; `flat` squeezes it in y.
mesh::RawMesh regular_cell(int n, double flat = 1);
/// A star of n points in a square.
mesh::RawMesh star_cell(int n);

/// Cells of one group become one cell: group(centroid) names it. Every group must be one simple polygon.
mesh::RawMesh joined(const mesh::RawMesh& raw, const std::function<int(Point)>& group);
/// C-shaped cells, each with a plug in its mouth: n × n of them.
mesh::RawMesh c_shaped(int n);
/// One coarse cell beside `n` small ones on its side.
mesh::RawMesh many_to_one(int n);
/// Random heaps of about `size` cells of a distorted mesh, joined.
mesh::RawMesh agglomerated(int n, int size, unsigned seed);

/// Every point moved by a map.
mesh::RawMesh mapped(mesh::RawMesh raw, const std::function<Point(Point)>& map);
/// The same mesh with points, cells and first corners in another order.
mesh::RawMesh renumbered(const mesh::RawMesh& raw, unsigned seed);

}  // namespace ashlar::stability
