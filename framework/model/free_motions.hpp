#pragma once
// Rigid motions of a body that supports leave free, and the one mistake that tells of them.

#include <string>

#include <Eigen/Dense>

#include "core/error.hpp"
#include "geometry/point.hpp"
#include "model/material.hpp"

namespace ashlar::model {

class FreeMotions {
 public:
  /// `origin` is a point of the body and `length` its size [m]: they scale rotations against slides.
  FreeMotions(geometry::Point origin, double length, Plane plane = Plane::strain)
      : origin_(origin), length_(length) {
    // A body of revolution can only slide along its axis.
    if (plane == Plane::axisymmetric) held_ = Eigen::Vector3d(1, 0, 1).asDiagonal();
  }

  /// Component 0 (x) or 1 (y) of the displacement at a point is held.
  void hold(geometry::Point at, int component);

  /// "slide in x and rotate about (3, 0)"; empty if the body is held. A rotation beside other free motions
  /// has no centre of its own.
  std::string words() const;

 private:
  std::string name(const Eigen::Vector3d& motion, bool only) const;

  geometry::Point origin_;
  double length_;
  Eigen::Matrix3d held_ =
      Eigen::Matrix3d::Zero();  ///< Σ rowᵀ row over held components: its null space is free
};

/// A body that nothing holds.
struct UnheldBody {
  std::string regions;  ///< "'dam' with 'rock'"
  std::string stage;
  std::string motions;  ///< from FreeMotions
  std::string edge;     ///< one of its named edges, for the advice; may be empty
};

void add_unheld(const UnheldBody& body, const core::Place& place, core::Mistakes& mistakes);

}  // namespace ashlar::model
