#pragma once
// The iteration of local terms (contact) on their own dofs, with the bulk condensed to a small dense system:
//   S δ + c(u + δ) = g,   S: Schur complement of the bulk, g: condensed residual.
// Newton for a fixed status; the status is updated outside of it; visited statuses are remembered, so that a
// cycle is found and named.

#include <set>

#include "model/results.hpp"
#include "solve/bulk.hpp"

namespace ashlar::solve {

/// The local terms of a stage, joined: their touched dofs merged into one ascending list.
class LocalTerms {
 public:
  LocalTerms() = default;
  LocalTerms(std::vector<std::shared_ptr<const model::LocalTerm>> terms,
             const model::Constraints& constraints);

  bool empty() const { return terms_.empty(); }
  /// The effect that the time of the iteration is booked on.
  const std::string& effect() const { return terms_.front()->effect(); }
  const std::vector<Index>& touched() const { return touched_; }
  /// Positions in `touched()` of the free dofs: the order of the kept unknowns.
  const std::vector<Index>& free() const { return free_; }
  /// c(u) and ∂c/∂u over the touched dofs.
  void evaluate(const fields::State& state, const Eigen::VectorXd& u, Eigen::VectorXd& force,
                Eigen::MatrixXd& tangent) const;
  int update_status(fields::State& state, const Eigen::VectorXd& u) const;
  std::vector<std::int8_t> status(const fields::State& state) const;
  std::string point_name(std::size_t point, const fields::State& state) const;
  std::vector<std::pair<std::string, double>> facts(const fields::State& state,
                                                    const Eigen::VectorXd& u) const;

 private:
  /// The values of one term's dofs out of those of all.
  std::vector<double> own(std::size_t term, const Eigen::VectorXd& u) const;

  std::vector<std::shared_ptr<const model::LocalTerm>> terms_;
  std::vector<std::vector<Index>> place_;  ///< by term: positions of its dofs in touched_
  std::vector<Index> touched_, free_;
};

struct LocalResult {
  bool converged = false;
  bool singular = false;  ///< a body is free to move in the present status
  std::string reason;
};

/// Iterates from the displacements `u` of the touched dofs (held ones already at their values) and leaves the
/// solution there. `load` is g + S u_free, so that S u + c(u) = load. Adds a row per status to `rows`.
LocalResult iterate(const LocalTerms& terms, const Eigen::MatrixXd& schur, const Eigen::VectorXd& load,
                    fields::State& state, Eigen::VectorXd& u, std::vector<model::Iteration>& rows);

}  // namespace ashlar::solve
