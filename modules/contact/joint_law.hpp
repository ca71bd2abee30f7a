#pragma once
// The laws of a joint: what presses (normal law) and what resists sliding (friction), each a registered kind,
// pure and without a mesh; and their composition at one contact point.
//
// Signs: pressure positive in compression, tension negative; opening positive, closure negative; slip and
// shear along the same tangent. All pressures are effective: water in the joint is a load of its own.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/schema.hpp"

namespace ashlar::contact {

/// What a normal law remembers of a point (greatest opening, broken …); those it does not use stay 0.
using Variables = std::array<double, 3>;

/// A function value and its derivative.
struct Opening {
  double value = 0;        ///< [m]
  double by_pressure = 0;  ///< [m/Pa], ≤ 0
};
struct Pressure {
  double value = 0;       ///< [Pa]
  double by_opening = 0;  ///< [Pa/m]
};

/// Pressure across lips that touch (or hang together), against their opening. The opening is that of the
/// surfaces, without what dilation has wedged them apart.
class NormalLaw {
 public:
  enum class Form {
    rigid,      ///< touching lips do not close further: the enforcement holds them
    compliant,  ///< `opening(pressure)`: closure is a one-to-one function of the pressure
    traction    ///< `pressure(opening)`: any function, with memory; it also holds for open lips
  };
  virtual ~NormalLaw() = default;
  virtual Form form() const = 0;
  /// Of compliant laws, for any pressure (pulls up to the tensile strength too).
  virtual Opening opening(double /*pressure*/) const { return {}; }
  /// Of traction laws. `trial` starts as a copy of `committed`.
  virtual Pressure pressure(double /*opening*/, const Variables& /*committed*/, Variables& /*trial*/) const {
    return {};
  }
  /// The pull that rigid or compliant lips bear before they part [Pa], ≥ 0.
  virtual double tensile_strength(const Variables& /*committed*/) const { return 0; }
  /// What remains in memory when lips have parted (a broken bond).
  virtual void part(Variables& /*trial*/) const {}
  /// Names of the variables in use.
  virtual std::vector<std::string> variables() const { return {}; }
};

/// The greatest shear that a point bears.
struct Strength {
  double value = 0;        ///< [Pa], ≥ 0
  double by_pressure = 0;  ///< makes tangents unsymmetric
  double by_path = 0;      ///< [Pa/m]
};

/// How far slip has wedged the lips apart.
struct Dilation {
  double value = 0;        ///< [m]
  double by_pressure = 0;  ///< [m/Pa]
  double by_path = 0;
};

/// Resistance to sliding. `path` is the slip travelled so far, ∫|ds| ≥ 0, elastic parts left out.
class Friction {
 public:
  virtual ~Friction() = default;
  /// Never any shear.
  virtual bool frictionless() const { return false; }
  /// Shear stiffness while the lips stick [Pa/m]; infinite: the enforcement decides.
  virtual double stiffness() const { return std::numeric_limits<double>::infinity(); }
  virtual Strength strength(double pressure, double path) const = 0;
  /// Opening gained while the path grows from `from` to `to` at this pressure.
  virtual Dilation dilation(double /*pressure*/, double /*from*/, double /*to*/) const { return {}; }
};

struct JointLaw {
  std::shared_ptr<const NormalLaw> normal;
  std::shared_ptr<const Friction> friction;
};

/// With a law of traction lips touch while they are closed or the law gives them a pressure or a pull.
enum class Status : std::int8_t { open, stick, slip_forward, slip_backward };
inline bool touching(Status status) {
  return status != Status::open;
}

/// What a contact point remembers from step to step.
struct PointMemory {
  Status status = Status::stick;
  double pressure = 0, shear = 0;  ///< effective tractions [Pa]
  double rest = 0;                 ///< slip at which the shear would vanish [m]
  double path = 0;                 ///< slip travelled [m]
  double dilation = 0;             ///< opening that it made [m]
  Variables law{};
};

/// How the enforcement holds lips that a law keeps rigid: opening = −compliance (pressure − base), and alike
/// for slip. Compliance 0 is exact; 1/k is a penalty; with a base it is an augmented Lagrangian.
struct Hold {
  double normal = 0, tangential = 0;         ///< compliances [m/Pa]
  double base_pressure = 0, base_shear = 0;  ///< [Pa]
};

/// A point's two unknowns are tractions where lips touch and displacements where they do not, so that rigid
/// and soft joints are equally well conditioned:
///   open   (gap, slip)
///   stick  (pressure, shear)              slip   (pressure, Δpath: growth of the path in this step)
/// With a normal law of form `traction` the first unknown is the opening without dilation, whatever the
/// status.
using Unknowns = Eigen::Vector2d;

struct PointResponse {
  Eigen::Vector2d jump = {0, 0};                          ///< gap, slip [m]
  Eigen::Vector2d traction = {0, 0};                      ///< −pressure, shear: conjugate to the jump [Pa]
  Eigen::Matrix2d jump_by = Eigen::Matrix2d::Zero();      ///< ∂jump/∂unknowns
  Eigen::Matrix2d traction_by = Eigen::Matrix2d::Zero();  ///< ∂traction/∂unknowns
};

/// With o, p the opening and pressure that the normal law couples, f the strength, d the dilation, σ = ±1 the
/// sense of slip, c the tangential compliance (1/stiffness, or the enforcement's):
///   stick:  slip = rest + c τ,           gap = o + dilation
///   slip:   τ = σ f(p, path + Δ),  slip = rest + σΔ + c τ,  gap = o + dilation + d(p, path, path + Δ)
///   frictionless: as slip with f = 0, σ = 1 and Δ of any sign
///   open:   gap, slip free, no traction
PointResponse respond(const JointLaw& law, const Hold& hold, const PointMemory& committed, Status status,
                      const Unknowns& unknowns);

/// How far the enforcement gives way where the laws would not [m]: across and along the joint. An augmented
/// Lagrangian makes it vanish.
Eigen::Vector2d yielding(const JointLaw& law, const Hold& hold, const PointMemory& committed, Status status,
                         const Unknowns& unknowns);

/// How far closed lips overlap beyond what the normal law asks for [m], ≥ 0: the enforcement's error.
double penetration(const JointLaw& law, const PointMemory& memory, double gap);

/// Below these, tractions and displacements count as zero.
struct Tolerance {
  double traction = 0;      ///< [Pa]
  double displacement = 0;  ///< [m]
};

/// The status that the solution for `status` calls for: open lips that overlap touch; a pull beyond the
/// tensile strength parts them; shear beyond the strength makes them slip; slip that would turn back sticks.
Status next_status(const JointLaw& law, const PointMemory& committed, Status status, const Unknowns& unknowns,
                   const PointResponse& response, const Tolerance& tolerance);

/// By how much a status breaks the laws [m], 0 where it fits: overlap of open lips; pull or shear beyond the
/// strength over the ground stiffness [Pa/m]; slip that turned back.
double violation(const JointLaw& law, const PointMemory& committed, Status status, const Unknowns& unknowns,
                 const PointResponse& response, double ground);

/// What is to be remembered of this solution.
PointMemory remember(const JointLaw& law, const Hold& hold, const PointMemory& committed, Status status,
                     const Unknowns& unknowns);

/// The unknowns to begin with in a status, from tractions and jump at hand.
Unknowns begin_with(const JointLaw& law, Status status, const PointMemory& memory,
                    const Eigen::Vector2d& jump);

/// Modules register laws as kinds "normal_law" and "friction".
/// Null, and a mistake with its place, for what schemas cannot see. Only for settings that are complete.
using MakeNormalLaw = std::shared_ptr<const NormalLaw>(const core::Settings& settings,
                                                       core::Mistakes& mistakes);
using MakeFriction = std::shared_ptr<const Friction>(const core::Settings& settings,
                                                     core::Mistakes& mistakes);

}  // namespace ashlar::contact
