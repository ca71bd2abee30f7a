#pragma once
// A law alone, led along a path of strains or held stresses: what `return Drive { … }` says, read and
// checked.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "model/material.hpp"

namespace ashlar::model {

/// One straight piece of the path. Components in Voigt order; each is led to a strain or to a stress [Pa], or
/// (neither) keeps its strain.
struct Leg {
  std::array<std::optional<double>, 4> strain, stress;
};

struct Drive {
  std::string title;
  std::string law;  ///< the registered name
  Plane plane = Plane::strain;
  std::shared_ptr<const Material> material;
  std::vector<Leg> legs;
  /// In place of legs: strains (xx, yy, xy[, zz]) at t from 0 to 1.
  std::shared_ptr<const core::Function> path;
  core::Place path_place;
  int steps = 1;  ///< of each leg, or of the function
};

/// The kinds "drive" and "leg".
void register_drive_kinds(core::Registry& registry);

/// Every mistake goes to `mistakes`; the material is null if there was one in it.
Drive read_drive(const core::Value& value, core::Registry& registry, core::Mistakes& mistakes);

}  // namespace ashlar::model
