#pragma once
// Faults planted on purpose: each must turn rows red, or the rows watch over nothing.

#include <memory>
#include <string>

#include "model/effect.hpp"

namespace ashlar::stability {

enum class Fault {
  none,
  wrong_sign,          ///< one cell's shear strain has a minus where a plus belongs
  lost_unknown,        ///< one cell gives no force and no stiffness to one of its unknowns
  dropped_edge,        ///< one cell's border integral leaves out an edge
  upward_weight,       ///< one cell's body force points the other way
  absolute_number,     ///< stiffnesses get a number that has no unit
  short_coordinates,   ///< cells see their corners with ten digits
  mismatched_tangent,  ///< one cell's stiffness is not the derivative of its forces
  stiff_rest,          ///< the stabilisation scales with λ, not with μ
  lost_history,        ///< laws begin every step as if nothing had ever yielded or slipped
  cured,               ///< the scene holds nothing that should stop it
  stronger,            ///< the strength in the scene is 2 % above what the row takes it for
  reversed_gap,        ///< one contact point measures its gap with the wrong sign
  scaled_traction,     ///< joints press and hold 1 % more than they say
  frozen_status,       ///< joints keep the status that they begin with
};

std::string words(Fault fault);

/// The element with the fault in it; the element itself if the fault is not one of elements. A fault of one
/// cell is in that with the most inner points.
std::shared_ptr<const model::Element> with_fault(std::shared_ptr<const model::Element> element, Fault fault,
                                                 const mesh::Mesh& mesh);

/// The law with the fault in it, or itself.
std::shared_ptr<const model::Material> with_fault(std::shared_ptr<const model::Material> law, Fault fault);

/// Puts the fault into the joints, if it is one of theirs.
void plant_in_joints(model::Effects& effects, Fault fault);

}  // namespace ashlar::stability
