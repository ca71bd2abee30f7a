#pragma once
// The four parts of contact, each replaced by one word in a script: pairing, normal law, friction,
// enforcement. The parts are pure: they hold their parameters and nothing that changes.
//
// Signs: gap ≤ 0 is contact; pressure positive in compression; slip and shear along ContactPoint::tangent.

#include <memory>
#include <vector>

#include "core/schema.hpp"
#include "model/model.hpp"

namespace ashlar::contact {

using geometry::Index;
using geometry::Point;

/// One point of the slave lip against its place on the master lip, both undeformed. The jump
/// J(u) = Σ factor u(point) is the displacement of the slave against the master; the gap is
/// gap + normal · J and the slip tangent · J.
struct ContactPoint {
  struct Share {
    Index point = -1;   ///< of the mesh
    double factor = 0;  ///< positive on the slave lip, negative on the master
  };
  std::vector<Share> shares;
  Point normal;  ///< outward unit normal of the master's body
  Point
      tangent;  ///< unit vector along which slip is that of the first lip against the second, along the path
  double gap = 0;      ///< before loading [m]
  double length = 0;   ///< of the slave lip that it stands for [m]
  double weight = 0;   ///< length by which its pressure becomes a force [m]
  double h = 0;        ///< mesh size: mean of the slave lip's edges at the point [m]
  double modulus = 0;  ///< E' of the softer side [Pa]
  double s = 0;        ///< arc length along the joint [m]
  Point at;            ///< place of the slave point
  int piece = 0;       ///< changes where the slave lip is interrupted by another joint
};

class Pairing {
 public:
  virtual ~Pairing() = default;
  /// Contact points of a joint, ascending in s; `slave` is the lip (0 or 1) whose points carry them. Points
  /// of welded tips carry none.
  virtual std::vector<ContactPoint> pair(const model::Model& model, const mesh::JointLips& joint,
                                         int slave) const = 0;
};

class NormalLaw {
 public:
  virtual ~NormalLaw() = default;
  /// Whether lips at this gap touch. Gaps within ±tolerance are 0 up to round-off.
  virtual bool closed(double gap, double tolerance) const = 0;
};

/// The pressure of a closed point and its derivative.
struct Pressure {
  double value = 0;   ///< [Pa]
  double by_gap = 0;  ///< [Pa/m]
};

class Enforcement {
 public:
  virtual ~Enforcement() = default;
  virtual Pressure pressure(double gap, const ContactPoint& point) const = 0;
};

/// The shear traction of a closed point, which resists slip, and its derivatives.
struct Shear {
  double value = 0;        ///< [Pa]
  double by_slip = 0;      ///< [Pa/m]
  double by_pressure = 0;  ///< makes the tangent unsymmetric
};

class Friction {
 public:
  virtual ~Friction() = default;
  virtual Shear shear(double slip, double pressure) const = 0;
};

/// Modules register parts as kinds "pairing", "normal_law", "enforcement" and "friction".
using MakePairing = std::shared_ptr<const Pairing>(const core::Settings& settings);
using MakeNormalLaw = std::shared_ptr<const NormalLaw>(const core::Settings& settings);
using MakeEnforcement = std::shared_ptr<const Enforcement>(const core::Settings& settings);
using MakeFriction = std::shared_ptr<const Friction>(const core::Settings& settings);

}  // namespace ashlar::contact
