#pragma once
// One point of a joint, led by `ashlar drive`.

#include "model/joint_driver.hpp"

namespace ashlar::contact {

/// The maker of kind "driven_joint", name "contact_point".
model::MakeJointDriver make_joint_driver;

}  // namespace ashlar::contact
