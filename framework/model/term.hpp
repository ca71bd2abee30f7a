#pragma once
// A term is one contribution to the equilibrium of a stage:
//   residual(u) = Σ stiffness terms K u + Σ nonlinear terms n(u) + Σ local terms c(u, status) − Σ loads f = 0
// in the free dofs; in the held dofs the residual is the reaction. Elasticity, contact, gravity and water are
// equals.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "algebra/sparse.hpp"
#include "model/model.hpp"

namespace ashlar::model {

struct StageResult;
struct LoadOrigin;

/// Forces and their moment about the origin [N, N, N·m].
struct Resultant {
  double x = 0, y = 0, moment = 0;
};

class Term {
 public:
  explicit Term(std::string effect) : effect_(std::move(effect)) {}
  virtual ~Term() = default;
  /// The effect it belongs to: its name in the ledger and in the balance.
  const std::string& effect() const { return effect_; }
  /// Memory that it holds.
  virtual std::size_t bytes() const { return 0; }
  /// Adds what it knows to a finished stage's results (stresses, joint profiles …), from the committed state.
  virtual void add_results(const fields::State&, StageResult&) const {}

 private:
  std::string effect_;
};

/// Forces that do not depend on the displacement.
class Load : public Term {
 public:
  using Term::Term;
  /// force += this load, by dof [N].
  virtual void add_force(std::span<double> force) const = 0;
  /// What its forces come from, if they are more than forces at points: sections ask on which side of a line
  /// they act.
  virtual const LoadOrigin* origin() const { return nullptr; }
};

/// A constant, symmetric, positive semidefinite tangent.
class Stiffness : public Term {
 public:
  using Term::Term;
  /// Groups of dofs that couple: one row per cell.
  virtual const algebra::Adjacency& groups() const = 0;
  /// value[map] += packed lower triangles of all groups.
  virtual void add_tangent(const algebra::ScatterMap& map, std::span<double> value) const = 0;
  /// force += K u, by dof.
  virtual void add_internal_force(std::span<const double> u, std::span<double> force) const = 0;
  /// force += that of one group alone, in its order, at the committed state: sections sum these on one side.
  virtual void add_group_force(const fields::State&, Index /*group*/, std::span<double> /*force*/) const {}
};

/// A force all over the body that is no linear function of the displacement (yielding …). Every iteration
/// assembles and factors its tangent anew. It is asked at the trial displacement and starts from the
/// committed internal variables; those of the trial follow.
class Nonlinear : public Term {
 public:
  using Term::Term;
  /// Groups of dofs that couple: one row per cell.
  virtual const algebra::Adjacency& groups() const = 0;
  virtual bool symmetric() const = 0;
  /// force += n(u), by dof.
  virtual void add_internal_force(fields::State& state, std::span<double> force) const = 0;
  /// lower[map] += packed lower triangles of all groups; upper[map] += those of the transposed, unless empty.
  virtual void add_tangent(fields::State& state, const algebra::ScatterMap& map, std::span<double> lower,
                           std::span<double> upper) const = 0;
  /// force += that of one group alone, in its order, at the committed state: sections sum these on one side.
  virtual void add_group_force(const fields::State&, Index /*group*/, std::span<double> /*force*/) const {}
  /// force += ∂n/∂u · direction.
  virtual void add_tangent_product(fields::State& state, std::span<const double> direction,
                                   std::span<double> force) const = 0;
  /// Numbers for the iteration table at the trial state: "yielding" …
  virtual std::vector<std::pair<std::string, double>> facts(const fields::State&) const { return {}; }
};

/// Jumps of displacement at points of joints: J = initial + B u, `width` components a point. The tractions q
/// that are conjugate to them are forces Bᵀ (area q) on the dofs.
struct Jumps {
  struct Part {
    Index place = 0;  ///< in the term's touched dofs
    double factor = 0;
  };
  int width = 2;
  std::vector<std::vector<Part>> parts;  ///< rows of B, by component
  std::vector<double> initial;           ///< by component [m]
  std::vector<double> area;              ///< by component: what a traction acts on [m²]
  std::vector<double> ground;            ///< by component: stiffness that a touching point might have [Pa/m]
  Index size() const { return static_cast<Index>(parts.size()); }
};

/// What the points of a local term answer to their unknowns, by component; derivatives by the unknowns of the
/// same point: `width` columns.
struct JumpResponse {
  Eigen::VectorXd jump, traction;
  Eigen::MatrixXd jump_by, traction_by;
  void resize(Index size, int width);
};

/// How a status is chosen anew.
struct StatusChange {
  double jump = 0;   ///< jumps below this are round-off [m]
  bool one = false;  ///< only one point changes, which the term chooses
};

/// What came of it.
struct StatusUpdate {
  int changed = 0;             ///< points
  double complementarity = 0;  ///< by how much the status before broke the laws where it did worst, over h
};

/// A nonlinear term in a few dofs only, through jumps of displacement: the bulk is factored once, and the
/// iteration stays on those jumps. Each point has `width` unknowns of its own, tractions or jumps by its
/// status (closed, open, slipping …), from which both follow: stiff, rigid and free points are equally well
/// conditioned. For a fixed status both are smooth functions of the unknowns.
class LocalTerm : public Term {
 public:
  using Term::Term;
  /// Ascending dofs that it touches, held ones included.
  virtual std::span<const Index> touched() const = 0;
  virtual const Jumps& jumps() const = 0;
  /// Whether points move along each other: then forces act where they are, not where they were drawn.
  virtual bool follows() const { return false; }
  /// Makes the jumps anew where points have moved by the trial state; true if it did.
  virtual bool follow(fields::State&) { return false; }
  /// Jumps and tractions for the trial status.
  virtual void respond(const fields::State& state, std::span<const double> unknown,
                       JumpResponse& response) const = 0;
  /// The unknowns that fit the trial state's status and tractions and these jumps.
  virtual void begin(const fields::State& state, std::span<const double> jump,
                     std::span<double> unknown) const = 0;
  /// Chooses the status that fits the unknowns and stores it in the trial state, with new unknowns where it
  /// changed.
  virtual StatusUpdate update_status(fields::State& state, const StatusChange& change,
                                     std::span<double> unknown) const = 0;
  /// Changes the point that stands against `motion` (a change of the jumps) first: an open one that it
  /// closes, a slipping one that it turns back. False if there is none: nothing resists.
  virtual bool stop_first(fields::State&, std::span<const double> /*motion*/,
                          std::span<double> /*unknown*/) const {
    return false;
  }
  /// Settled for its status: stores tractions and what the points remember in the trial state. True if the
  /// iteration is to go on with them (multipliers that are still growing).
  virtual bool settle(fields::State& state, std::span<const double> unknown) const = 0;
  /// Tractions of the trial state, by component [Pa].
  virtual void tractions(const fields::State& state, std::span<double> traction) const = 0;
  /// Status of every point as small integers: what tells two iterates apart when a cycle is looked for.
  virtual std::vector<std::int8_t> status(const fields::State& state) const = 0;
  /// Goes back to a status of before.
  virtual void restore(fields::State& state, std::span<const std::int8_t> status) const = 0;
  /// A point's name for messages: "fault at (6.2, 7.8)".
  virtual std::string point_name(std::size_t point) const = 0;
  /// Numbers for the iteration table: "open", "stick", "penetration/h" …
  virtual std::vector<std::pair<std::string, double>> facts(const fields::State& state,
                                                            std::span<const double> unknown) const = 0;
};

/// The terms of one stage.
struct Terms {
  std::vector<std::shared_ptr<const Load>> loads;
  std::vector<std::shared_ptr<const Stiffness>> stiffness;
  std::vector<std::shared_ptr<const Nonlinear>> nonlinear;
  std::vector<std::shared_ptr<LocalTerm>> local;
};

}  // namespace ashlar::model
