#pragma once
// The laws that this module provides, and those of a joint made from its settings.

#include "contact/joint_law.hpp"
#include "core/registry.hpp"

namespace ashlar::contact {

/// The makers of kinds "normal_law" and "friction".
void register_laws(core::Registry& registry);

/// The laws that the keys "normal_law" and "friction" of a joint name. What is wrong with either, or with
/// both together, is a mistake with its place, and a law then missing. Keys that were not said and have no
/// default are nobody's mistake here.
JointLaw make_joint_law(core::Registry& registry, const core::Settings& joint, core::Mistakes& mistakes);

}  // namespace ashlar::contact
