#pragma once
// The iteration of local terms (contact) on their jumps. With S the bulk's Schur complement on the touched
// dofs, b its load, J = initial + B u the jumps, q the tractions on areas A:
//   S u + Bᵀ A q = b
// Bodies that only joints hold make S singular. So every point is first given a ground stiffness D, which is
// taken off again on the right-hand side: no spring is left in the solution.
//   (S + Bᵀ A D B) u = b − Bᵀ A (q − D B u)      ⇒      B u = F_b − F A (q − D B u)
// with the compliance F = B (S + Bᵀ A D B)⁻¹ Bᵀ, made once for a factorisation. Newton's method solves this
// for the points' unknowns y, from which J(y) and q(y) follow, for a fixed status; the status is updated
// outside of it; visited statuses are remembered, so that a cycle is found, broken, or named. A status that
// lets bodies loose tells their motion: the first point that stands against it changes, or it is named.

#include <optional>

#include <Eigen/SparseCore>

#include "algebra/dense.hpp"
#include "model/results.hpp"
#include "solve/bulk.hpp"

namespace ashlar::solve {

/// The bulk as the jumps feel it.
class Condensed {
 public:
  struct Points {
    Eigen::SparseMatrix<double> jumps;  ///< B over the free touched dofs
    Eigen::VectorXd area, ground;
  };
  Condensed(Points points, const Eigen::MatrixXd& schur, bool symmetric, const algebra::DenseAlgebra& dense);
  /// False if a body is free to move although all joints touch.
  bool held() const { return held_; }
  const algebra::DenseAlgebra& dense() const { return dense_; }
  /// F A and I − F A D.
  const Eigen::MatrixXd& by_traction() const { return by_traction_; }
  const Eigen::MatrixXd& by_jump() const { return by_jump_; }
  /// B (S + Bᵀ A D B)⁻¹ b.
  Eigen::VectorXd jump_of(const Eigen::VectorXd& load) const { return points_.jumps * solve(load); }
  /// (S + Bᵀ A D B)⁻¹ (b − Bᵀ A (q − D j)), j: the jumps' change B u.
  Eigen::VectorXd displacement(const Eigen::VectorXd& load, const Eigen::VectorXd& traction,
                               const Eigen::VectorXd& change) const;

 private:
  Eigen::VectorXd solve(const Eigen::VectorXd& load) const;

  Points points_;
  bool symmetric_, held_ = true;
  Eigen::MatrixXd by_traction_, by_jump_;
  const algebra::DenseAlgebra& dense_;
  std::unique_ptr<algebra::DenseCholesky> cholesky_;
  std::unique_ptr<algebra::DenseLu> lu_;
};

/// force += Bᵀ A q of one term over all dofs, q: the trial state's tractions.
void add_force(const model::LocalTerm& term, const fields::State& state, std::span<double> force);

/// The local terms of a stage, joined: their touched dofs merged into one ascending list, their points'
/// components put one after the other.
class LocalTerms {
 public:
  LocalTerms() = default;
  LocalTerms(std::vector<std::shared_ptr<model::LocalTerm>> terms, const model::Constraints& constraints);

  bool empty() const { return terms_.empty(); }
  /// The effect that the time of the iteration is booked on.
  const std::string& effect() const { return terms_.front()->effect(); }
  const std::vector<Index>& touched() const { return touched_; }
  /// Positions in `touched()` of the free dofs: the order of the kept unknowns.
  const std::vector<Index>& free() const { return free_; }
  /// Components of all jumps.
  Index size() const { return static_cast<Index>(area_.size()); }
  const Eigen::VectorXd& area() const { return area_; }
  const Eigen::VectorXd& ground() const { return ground_; }
  /// B over the free touched dofs.
  Eigen::SparseMatrix<double> free_jumps() const;
  /// initial + B u over all touched dofs.
  Eigen::VectorXd jumps(const Eigen::VectorXd& u) const;
  /// force += Bᵀ A q over all dofs, q: the trial state's tractions.
  void add_force(const fields::State& state, std::span<double> force) const;

  void respond(const fields::State& state, const Eigen::VectorXd& unknown,
               model::JumpResponse& response) const;
  void begin(const fields::State& state, const Eigen::VectorXd& jump, Eigen::VectorXd& unknown) const;
  model::StatusUpdate update_status(fields::State& state, const model::StatusChange& change,
                                    Eigen::VectorXd& unknown) const;
  bool stop_first(fields::State& state, const Eigen::VectorXd& motion, Eigen::VectorXd& unknown) const;
  bool settle(fields::State& state, const Eigen::VectorXd& unknown) const;
  std::vector<std::int8_t> status(const fields::State& state) const;
  void restore(fields::State& state, std::span<const std::int8_t> status) const;
  std::string point_name(std::size_t point, const fields::State& state) const;
  std::vector<std::pair<std::string, double>> facts(const fields::State& state,
                                                    const Eigen::VectorXd& unknown) const;
  /// The components of one point: the first, and how many.
  struct Block {
    Index first = 0, width = 0;
  };
  const std::vector<Block>& blocks() const { return blocks_; }
  /// The bulk as the jumps feel it, made when it is first asked for after `bulk_changed`.
  const Condensed& condensed(const Bulk& bulk);
  void bulk_changed() { condensed_.reset(); }
  /// Points that move along each other are paired anew where the trial state has them. True if there are any.
  bool follow(fields::State& state);
  /// True if these serve a stage with such terms and dofs.
  bool serves(const std::vector<std::shared_ptr<model::LocalTerm>>& terms,
              const model::Constraints& constraints) const;

 private:
  void gather_jumps();

  std::vector<std::shared_ptr<model::LocalTerm>> terms_;
  std::vector<Index> first_;               ///< by term: its first component; then their number
  std::vector<std::vector<Index>> place_;  ///< by term: positions of its dofs in touched_
  std::vector<Index> touched_, free_;
  std::vector<char> held_;
  std::vector<Block> blocks_;
  Eigen::VectorXd area_, ground_, initial_;
  std::optional<Condensed> condensed_;
};

struct LocalResult {
  bool converged = false;
  bool singular = false;  ///< a body is free to move in the present status
  std::string reason;
  bool held_before = false;     ///< but not in one of before: a smaller step may keep to that
  Eigen::VectorXd motion = {};  ///< of the touched dofs, how the body moves; empty if that is not known
};

/// Iterates from the displacements `u` of the touched dofs (held ones already at their values) and leaves the
/// solution there. `load` is b. Adds a row per status to `rows`.
LocalResult iterate(const LocalTerms& terms, const Condensed& bulk, const Eigen::VectorXd& load,
                    fields::State& state, Eigen::VectorXd& u, std::vector<model::Iteration>& rows);

}  // namespace ashlar::solve
