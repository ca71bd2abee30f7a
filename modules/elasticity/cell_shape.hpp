#pragma once
// What the order-1 element needs to know of a polygon: its measures, and the projection Π of a displacement
// that is linear along each edge onto linear polynomials, computed from the boundary alone.
//
//   (Πv)(x) = Σ_i v_i (w_i + g_i·(x − x̄)),      x̄ = Σ_i w_i x_i
//   g_i = ½ (|e_{i−1}| n_{i−1} + |e_i| n_i)/|E|   so that ∇Πv = 1/|E| ∮ v⊗n   (mean gradient)
//   w_i = ½ (|e_{i−1}| + |e_i|)/|∂E|              so that ∮ Πv = ∮ v          (mean along the border)
//
// Corners may be collinear, edges may be short, the polygon may be non-convex: only its area must be
// positive.

#include <span>

#include "elasticity/scratch.hpp"
#include "geometry/point.hpp"

namespace ashlar::elasticity {

using geometry::Point;

/// A symmetric 2×2 tensor.
struct Tensor2 {
  double xx = 1, xy = 0, yy = 1;
  Point operator*(Point v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y}; }
};

struct CellShape {
  explicit CellShape(std::span<const Point> corners);

  double area = 0;        ///< |E| [m²]
  Point centroid;         ///< of the area, relative to the border's mean x̄ [m]
  Tensor2 second_moment;  ///< ∫ (x−c)⊗(x−c) over the cell about the centroid [m⁴]
  Scratch<Point> offset;  ///< x_i − x̄ [m]
  Scratch<double> mean;   ///< w_i
  Scratch<Point> slope;   ///< g_i [1/m]
};

}  // namespace ashlar::elasticity
