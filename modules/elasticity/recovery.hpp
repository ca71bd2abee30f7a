#pragma once
// Stresses in cells, and recovered at points.
//
// A cell's stress is the law's answer to its mean strain: the stress at the cell's centroid, to second order.
// At a point, each component is the value of the linear function that fits the centroid values of the cells
// around it best (weights: areas), after Zienkiewicz and Zhu's patch recovery (Int. J. Numer. Methods Engrg.
// 33, 1992). Linear stresses are recovered exactly, on the border too.
//
// Patches never reach across a change of stiffness or a joint. A point where materials meet gets the mean of
// their values, weighted by their areas at the point; the jump itself shows in the cell fields.

#include <array>
#include <vector>

#include "model/model.hpp"
#include "model/results.hpp"

namespace ashlar::elasticity {

using mesh::Index;
using model::Point;

using Stress = model::Voigt;  ///< xx, yy, xy, zz [Pa]; tension positive

struct CellStresses {
  std::vector<model::Voigt> strain;  ///< xx, yy, γ_xy, zz
  std::vector<Stress> stress;
  std::vector<double> area;     ///< [m²]
  std::vector<Point> centroid;  ///< [m]
};

/// `dofs`: of each cell, in the element's order; `u`: displacement by dof [m].
CellStresses cell_stresses(const model::Model& model, const mesh::Adjacency& dofs, std::span<const double> u);

/// Stresses at the mesh points; zero at points without cells.
std::vector<Stress> recover_at_points(const model::Model& model, const CellStresses& cells);

/// In-plane principal stresses s1 ≥ s3 [Pa] and the angle from x to the direction of s1 in (−90°, 90°].
struct Principal {
  double s1 = 0, s3 = 0, angle = 0;
};
Principal principal(const Stress& stress);

/// Von Mises' equivalent stress of all four components [Pa].
double von_mises(const Stress& stress);

}  // namespace ashlar::elasticity
