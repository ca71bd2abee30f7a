#pragma once
// A point of a joint that can be led without a mesh: what modules with laws of joints offer to `ashlar
// drive`.

#include <memory>
#include <string>
#include <vector>

#include "core/registry.hpp"

namespace ashlar::model {

/// What a step asks for: an opening or a pressure across the joint, a slip or a shear along it.
struct JointTarget {
  double normal = 0, tangential = 0;
  bool pressure = false;  ///< `normal` is a pressure [Pa], positive in compression; else an opening [m]
  bool shear = false;     ///< `tangential` is a shear [Pa]; else a slip [m]
};

struct JointPoint {
  double opening = 0, slip = 0;    ///< [m]; closure is negative
  double pressure = 0, shear = 0;  ///< effective [Pa]
  double dilation = 0;             ///< part of the opening, made by slip [m]
  std::string status;              ///< "open", "stick", "slip"
  std::vector<double> variables;
  int iterations = 0;  ///< of Newton's method in the last step
};

class JointDriver {
 public:
  virtual ~JointDriver() = default;
  /// "linear, coulomb": the laws.
  virtual std::string law() const = 0;
  /// Names of JointPoint::variables.
  virtual std::vector<std::string> variables() const = 0;
  /// Where it stands: at first closed, without tractions.
  virtual const JointPoint& at() const = 0;
  /// Goes there in one step. False, and it stays where it was, if the laws allow no such point.
  virtual bool go(const JointTarget& target) = 0;
};

/// Modules register it as kind "driven_joint". Null, and mistakes, if a law is wrong.
using MakeJointDriver = std::unique_ptr<JointDriver>(core::Registry& registry, const core::Settings& settings,
                                                     core::Mistakes& mistakes);

}  // namespace ashlar::model
