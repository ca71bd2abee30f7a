#pragma once
// A law alone, led along a path: what `return Drive { … }` says, read and checked. A material is led by
// strains or held stresses, a point of a joint by opening or pressure and slip or shear.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "model/joint_driver.hpp"
#include "model/material.hpp"

namespace ashlar::model {

/// One straight piece of the path. Components in Voigt order; each is led to a strain or to a stress [Pa], or
/// (neither) keeps its strain.
struct Leg {
  std::array<std::optional<double>, 4> strain, stress;
};

/// One straight piece of a joint's path: each direction is led to at most one of its two; with neither it
/// keeps the one that was led last (at first opening 0, slip 0).
struct JointLeg {
  std::optional<double> opening, pressure, slip, shear;
};

struct Drive {
  std::string title;
  std::string law;  ///< the registered name
  Plane plane = Plane::strain;
  std::shared_ptr<const Material> material;
  std::vector<Leg> legs;
  /// In place of plane, material and its legs.
  std::unique_ptr<JointDriver> joint;
  std::vector<JointLeg> joint_legs;
  /// In place of legs: strains (xx, yy, xy[, zz]), or opening and slip, at t from 0 to 1.
  std::shared_ptr<const core::Function> path;
  core::Place path_place;
  int steps = 1;  ///< of each leg, or of the function
};

/// The kinds "drive" and "leg".
void register_drive_kinds(core::Registry& registry);

/// Every mistake goes to `mistakes`; material or joint are null if there was one in them.
Drive read_drive(const core::Value& value, core::Registry& registry, core::Mistakes& mistakes);

}  // namespace ashlar::model
