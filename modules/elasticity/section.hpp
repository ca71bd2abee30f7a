#pragma once
// What sections need of the solid: stresses and displacements along their lines, and the forces of single
// cells.

#include "elasticity/recovery.hpp"

namespace ashlar::elasticity {

/// Fills the profiles of `result.sections` and integrates them over their lines. At each crossing of a cell's
/// border, and order − 1 times between, the stress is the one recovered there from the cells of one side:
/// README.md, Stresses. `u`: displacement by dof [m].
void add_section_profiles(const model::Model& model, const CellStresses& cells, std::span<const double> u,
                          model::StageResult& result);

/// force += what one cell's stress exerts on its dofs. `history`: internal variables of all points.
void add_cell_force(const model::Model& model, const Layout& layout, Index cell, std::span<const double> u,
                    std::span<const double> history, std::span<double> force);

}  // namespace ashlar::elasticity
