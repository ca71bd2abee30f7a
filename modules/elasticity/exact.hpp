#pragma once
// How far a solution is from one that the scene knows exactly.
//
//   displacement: ‖u_h − u‖ and ‖u‖ over the body, root of the integral of squares [m · m^(3/2)], u_h the
//   cell's polynomial of the element's order; stress: the same of (xx, yy, √2 xy, zz) [Pa · m^(3/2)], σ_h the
//   polynomial through the law's answers at the cell's points; energy: √∫ (σ_h−σ) : C (σ_h−σ), C the inverse
//   of the law's tangent at rest [J^(1/2)]
//
// Integrals by a rule of degree 6 in the triangles of each cell.

#include "elasticity/recovery.hpp"
#include "model/results.hpp"
#include "model/scene.hpp"

namespace ashlar::elasticity {

/// Adds a row for each quantity that an `Exact` of the scene's outputs gives for this stage. Throws
/// InputError where a function of the scene fails or returns no numbers, with the place in the body.
void add_norms(const model::Model& model, const Layout& layout, const model::Scene& scene,
               std::span<const double> u, std::span<const double> history, model::StageResult& result);

}  // namespace ashlar::elasticity
