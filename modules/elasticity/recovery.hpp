#pragma once
// Stresses in cells, and recovered at points.
//
// A cell's stress is the mean over its integration points. At a point, each component is the value of the
// polynomial of the element's order that fits the values at the integration points of the cells around it
// best (weights: areas), after Zienkiewicz and Zhu's patch recovery (Int. J. Numer. Methods Engrg. 33, 1992).
// Stresses of that order are recovered exactly, on the border too.
//
// Patches never reach across a change of stiffness or a joint. A point where materials meet gets the mean of
// their values, weighted by their areas at the point; the jump itself shows in the cell fields.

#include <array>
#include <vector>

#include "elasticity/layout.hpp"
#include "model/results.hpp"

namespace ashlar::elasticity {

using mesh::Index;
using model::Point;

using Stress = model::Voigt;  ///< xx, yy, xy, zz [Pa]; tension positive

/// What the law said at one integration point.
struct Sample {
  Point at;
  double area = 0;  ///< its share of the cell [m²]
  Stress stress{};
};

struct CellStresses {
  std::vector<model::Voigt> strain;  ///< mean of each cell: xx, yy, γ_xy, zz
  std::vector<Stress> stress;        ///< mean of each cell
  std::vector<std::size_t> start;    ///< samples of cell c: start[c] … start[c+1]
  std::vector<Sample> sample;
  std::span<const Sample> of(Index cell) const {
    const auto c = static_cast<std::size_t>(cell);
    return {sample.data() + start[c], start[c + 1] - start[c]};
  }
};

/// `u`: displacement by dof [m]; `history`: internal variables of all integration points.
CellStresses cell_stresses(const model::Model& model, const Layout& layout, std::span<const double> u,
                           std::span<const double> history = {});

/// Stresses at any place, from the cells of one stiffness around it.
class Recovery {
 public:
  /// `cells_of_point`: mesh.cell_points transposed.
  Recovery(const model::Model& model, const CellStresses& cells, const mesh::Adjacency& cells_of_point)
      : model_(model), cells_(cells), cells_of_point_(cells_of_point) {}

  /// At a mesh point: the mean over the materials that meet there.
  Stress at_point(Index point);
  /// At a place on or in the cell `of`, from those of `around` that are as stiff.
  Stress on_side(Point at, std::span<const Index> around, Index of);

 private:
  bool first_of_its_material(std::span<const Index> around, std::size_t i) const;
  void gather_patch(std::span<const Index> cells, const model::Material& material);
  Stress patch_value(Point at);
  std::span<const Sample> samples_of(const std::vector<Index>& cells);
  void widen();

  const model::Model& model_;
  const CellStresses& cells_;
  const mesh::Adjacency& cells_of_point_;
  std::vector<Index> patch_, wide_;
  std::vector<Sample> samples_;
};

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
