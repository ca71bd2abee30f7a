#pragma once
// Two of the four parts of contact: pairing and enforcement (joint_law.hpp has normal laws and friction). The
// parts are pure: they hold their parameters and nothing that changes.
//
// Signs: gap ≤ 0 is contact; pressure positive in compression; slip and shear along ContactPoint::tangent.

#include "contact/joint_law.hpp"
#include "model/model.hpp"

namespace ashlar::contact {

using geometry::Index;
using geometry::Point;

/// A point of the slave lip against its place on the master lip, both undeformed. The jump
/// J(u) = Σ factor u(dof) is the displacement of the slave against the master (a mean, for segments); the gap
/// is gap + normal · J and the slip tangent · J.
struct ContactPoint {
  struct Share {
    Index dof = -1;      ///< the first of a node's two
    double factor = 0;   ///< sums to 1 on the slave lip, to −1 on the master
    Point at;            ///< the node's place
    bool slave = false;  ///< on the slave lip
  };
  std::vector<Share> shares;
  int slave = 0;  ///< the lip that it stands on
  Point normal;   ///< outward unit normal of the master's body
  Point
      tangent;  ///< unit vector along which slip is that of the first lip against the second, along the path
  double gap = 0;      ///< before loading [m]
  double slip = 0;     ///< added to that of the displacement [m]: where points were paired anew
  double overlap = 0;  ///< deepest place nearby where the bodies overlap before loading [m]
  double length = 0;   ///< of the slave lip that it stands for [m]
  double area = 0;     ///< by which its tractions become forces [m²]
  double weight = 1;   ///< area over what the point truly stands for: 1, but for the paper's equal weights
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
  /// What is to be said of the lips goes to `remarks`, if there are any.
  virtual std::vector<ContactPoint> pair(const model::Model& model, const mesh::JointLips& joint, int slave,
                                         std::vector<std::string>* remarks = nullptr) const = 0;
  /// Whether it may pair lips anew that have moved along each other.
  virtual bool follows() const { return false; }
};

/// How lips that a law keeps rigid are held.
class Enforcement {
 public:
  virtual ~Enforcement() = default;
  /// `base`: the tractions that were held last (pressure, shear); `growth` ≥ 1 stiffens augmented ones.
  virtual Hold hold(const ContactPoint& point, const Eigen::Vector2d& base, double growth) const = 0;
  /// What an augmented method does once the status is settled: nothing more if the penetration over h is
  /// small enough, else the base takes over the tractions and the iteration goes on.
  struct Augment {
    bool again = false;
    double growth = 1;
  };
  virtual Augment augment(double /*penetration*/, double /*before*/, double growth) const {
    return {false, growth};
  }
};

/// Which point changes its status alone, once statuses have come round in a cycle.
class CycleRule {
 public:
  virtual ~CycleRule() = default;
  /// `misfits`: energies by which statuses are wrong, by point, of those that are; not empty. Returns a place
  /// in it.
  virtual std::size_t choose(std::span<const double> misfits) const = 0;
};

/// Modules register parts as kinds "pairing", "enforcement" and "cycle_rule".
using MakePairing = std::shared_ptr<const Pairing>(const core::Settings& settings);
using MakeCycleRule = std::shared_ptr<const CycleRule>(const core::Settings& settings);
using MakeEnforcement = std::shared_ptr<const Enforcement>(const core::Settings& settings);

}  // namespace ashlar::contact
