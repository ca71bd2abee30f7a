#pragma once
// Forces and couples at mesh points.

#include "model/effect.hpp"

namespace ashlar::loads {

/// force += a `Force { at, x, y, lip }` at the nearest mesh point, by dof [N]. Mistakes: model::point_at.
void add_force(const core::Settings& force, const model::Model& model, std::span<double> forces,
               core::Mistakes& mistakes);

/// force += a `Couple { between, moment }`, by dof [N]. Mistake: both places have the same nearest point.
void add_couple(const core::Settings& couple, const model::Model& model, std::span<double> forces,
                core::Mistakes& mistakes);

}  // namespace ashlar::loads
