#pragma once
// Patch tests of degree k for the table.

#include "patch/exact.hpp"
#include "stability/table.hpp"

namespace ashlar::stability {

using geometry::Point;

/// The program's own element of an order, with its default stabilisation.
std::shared_ptr<const model::Element> element_of(int order);

/// The bounds of the issue for orders 1, 2, 3: displacements relative to the largest.
constexpr double patch_bound(int order) {
  return order == 1 ? 1e-12 : order == 2 ? 1e-11 : 1e-10;
}

struct PatchRun {
  Point centre{0.3, 0.1};  ///< of the polynomials
  double nu = 0.3;
  double stretch = 1;         ///< factor on the bounds
  double stress_stretch = 1;  ///< and one more on those of stresses
};

/// Solves for the polynomials of degree 1 … k on one mesh with orders 1, 2, 3 and adds what it finds.
void add_patch_tests(const mesh::Mesh& mesh, const PatchRun& how, Fault fault, Outcome& outcome);

}  // namespace ashlar::stability
