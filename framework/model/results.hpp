#pragma once
// What a run found, ready to be written: fields, joint profiles, probes, balance, iterations.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/term.hpp"

namespace ashlar::model {

/// A field on points or cells, `width` values each.
struct FieldResult {
  enum class On { points, cells };
  std::string name;  ///< "displacement", "stress", "principal_stress" …
  std::string unit;  ///< "m", "Pa", ""
  On on = On::points;
  int width = 1;
  std::vector<std::string> components;  ///< "x", "y" / "xx", "yy", "xy", "zz"
  std::vector<double> values;           ///< entity by entity
};

/// One joint along its arc length: rows at the points of the slave lip, ascending s.
struct JointResult {
  struct Row {
    double s = 0;            ///< arc length along the joint [m]
    Point at;                ///< undeformed place
    double opening = 0;      ///< normal distance of the lips [m]; negative: penetration of the penalty
    double slip = 0;         ///< movement of the first lip against the second, along the path [m]
    double pressure = 0;     ///< contact pressure (effective), compression positive [Pa]
    double shear = 0;        ///< positive where the first lip is held against slip along the path [Pa]
    double utilisation = 0;  ///< |shear| over the shear strength at this pressure; 0 without friction
    double water = 0;        ///< pressure of water between the lips; pressure + water is the total [Pa]
    enum class State { open, stick, slip } state = State::open;
    bool closed = false;  ///< not open
    int piece = 0;        ///< changes where the profile is interrupted
  };
  /// Where the lips end in one point: no opening, no slip, and no contact point.
  struct Tip {
    double s = 0;
    Point at;
  };
  std::string name;
  std::vector<Row> rows;
  std::vector<Tip> tips;      ///< welded ends, ascending s
  double length = 0;          ///< of the slave lip [m]
  double contact_length = 0;  ///< of it, what the rows stand for: not the half edges at tips [m]
  double normal_force = 0;    ///< Σ contact forces along the normals, compression positive [N]
  double shear_force = 0;     ///< Σ of the shear tractions along the path [N]
  double strength_force = 0;  ///< Σ of the shear strengths of closed points: N tan φ + c A for Coulomb [N]
  /// strength_force over |shear_force|; 0 where there is no friction or nothing to resist.
  double safety = 0;
  double water_force = 0;     ///< Σ of the water's pressure between the lips [N]
  double action_s = 0;        ///< arc length where the normal forces' resultant acts [m]
  double cracked_length = 0;  ///< of `contact_length`, what is open [m]
  Resultant resultant;        ///< contact force on the first lip's body
  double max_opening = 0, max_slip = 0, max_penetration = 0, max_pressure = 0, max_shear = 0;
  double penetration_over_h = 0;
  int closed = 0, slipping = 0, points = 0;
};

struct ProbeResult {
  std::string name;
  Point asked, at;                       ///< asked place, and the mesh point used
  std::map<std::string, double> values;  ///< "ux", "uy", "sxx", "syy", "sxy", "s1", "s3" …
};

/// Force and moment over a line: what the body on its left exerts on the body on its right, N n + V t, with t
/// from its first to its last point and n = t turned left, and M about the middle between both. N is positive
/// in tension, M where the end of the line is pulled more than its beginning. On the modelled thickness.
struct SectionForces {
  double normal = 0, shear = 0, moment = 0;  ///< N, V [N], M [N·m]
};

/// One line through the body.
struct SectionResult {
  enum class Side { both, left, right };  ///< whose values they are where the line follows a jump
  struct Column {
    std::string name, unit;
  };
  struct Row {
    double s = 0;  ///< from the line's first point [m]
    Point at;
    Side side = Side::both;
    int piece = 0;  ///< changes where the profile jumps or is interrupted
    std::string region;
    std::vector<double> values;  ///< by column; NaN: not known there
  };
  std::string name;
  Point first, last;  ///< the line's first and last place in the body
  bool ends_inside = false;
  bool summed = false;          ///< `forces` were filled: not in bodies of revolution
  SectionForces forces;         ///< from the forces of the cells on one side: they balance the loads
  bool integrated = false;      ///< `integral` and `difference` were filled
  SectionForces integral;       ///< of the profile's tractions
  double absolute = 0;          ///< ∫ |traction| over the line [N]
  double size = 0;              ///< greatest stress along the line times its area [N]: measures round-off
  double difference = 0;        ///< of both, relative to `absolute`: how accurate the profile is
  std::vector<Column> columns;  ///< ux, uy, sxx, syy, sxy, sn (normal), tau, s1, s3
  std::vector<Row> rows;        ///< along the line; then the right sides of jumps that it follows
};

/// Sums of loads and reactions. The error is relative to the sum of absolute loads.
struct Balance {
  std::vector<std::pair<std::string, Resultant>> loads;      ///< by effect
  std::vector<std::pair<std::string, Resultant>> reactions;  ///< by support
  Resultant load, reaction;
  double relative_error = 0;
};

struct Extreme {
  std::string quantity, unit;  ///< "uy", "m"
  double least = 0, greatest = 0;
  Point least_at, greatest_at;
};

/// Distance from a solution that the scene knows, as an integral over the body.
struct NormResult {
  std::string name, quantity, unit;  ///< of the scene's `Exact`; "displacement", "stress", "energy"
  double error = 0, norm = 0;        ///< ‖found − exact‖ and ‖exact‖
  double relative() const { return norm > 0 ? error / norm : error; }
};

/// One row of a stage's iteration table.
struct Iteration {
  int step = 1, number = 1;
  double residual = 0;  ///< relative force residual
  std::vector<std::pair<std::string, double>> facts;
};

struct StageResult {
  std::string name;
  bool converged = true;
  std::string reason;  ///< if not; it then has no fields, joints, probes, balance and extremes
  std::string advice;  ///< if not: what to try
  std::vector<std::string> effects;
  std::vector<FieldResult> fields;
  std::vector<JointResult> joints;
  std::vector<ProbeResult> probes;
  std::vector<SectionResult> sections;
  Balance balance;
  std::vector<Iteration> iterations;
  std::vector<Extreme> extremes;
  std::vector<NormResult> norms;
  bool factored = true;  ///< false: the previous factorisation served
  Index unknowns = 0, kept = 0;
  std::string solver;         ///< what the solver said of its factorisation
  double backward_error = 0;  ///< of the last step's linear solves, the worst
  double forward_error = 0;   ///< what round-off does to the displacements, relative to the largest; 0 where
                              ///< joints or yielding iterate
  double condition = 0;  ///< estimate of ‖K‖₁ ‖K⁻¹‖₁ over the free unknowns; 0 where it is not asked for
};

struct RunResult {
  std::vector<StageResult> stages;  ///< those that were begun; only the last one may have failed
  bool converged = true;

  /// The stages that reached their end: those whose fields, joints and balance mean something.
  std::span<const StageResult> good() const {
    return {stages.data(), stages.size() - (stages.empty() || stages.back().converged ? 0 : 1)};
  }
};

}  // namespace ashlar::model
