#include "solve/march.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/ledger.hpp"
#include "core/log.hpp"
#include "model/place.hpp"
#include "solve/advance.hpp"
#include "solve/build.hpp"
#include "solve/condition.hpp"
#include "solve/sections.hpp"
#include "solve/stage_results.hpp"

namespace ashlar::solve {

namespace {

// Halving a stage this often makes steps of 1/64; a contact that still does not settle will not.
constexpr int most_cuts = 6;

// Loads and reactions of a solved stage agree to round-off, some 1e-14; this is far off.
constexpr double poor_balance = 1e-8;

// Displacements that lost ten of their sixteen digits are said.
constexpr double poor_forward_error = 1e-6;

// Where nothing loads, reactions below this share of ‖K‖ ‖u‖ are next to nothing: their balance says nothing.
constexpr double negligible = 1e-8;
// The same where neither loads nor moving supports act any more: all forces left are round-off of former
// ones.
constexpr double negligible_at_rest = 1e-6;
// Displacements beyond this share of the model's size turn and stretch it visibly.
constexpr double large_share = 0.02;

/// Everything of one stage that can be made before anything is solved.
struct Prepared {
  model::Constraints constraints;
  model::Terms terms;
  std::vector<double> load;
};

/// Where a stage ended: what its children start from.
struct Ended {
  fields::State state;
  std::vector<double> load;
  int equations = -1;  ///< whose balance it is
};

class March {
 public:
  March(const MarchInput& input, Observer& observer) : in_(input), observer_(observer) {
    state_.add("displacement", in_.model.dofs.size());
  }

  model::RunResult run() {
    prepare();
    model::RunResult result;
    for (std::size_t s = 0; s < in_.scene.stages.size(); ++s) {
      observer_.stage_begins(in_.scene.stages[s].name, static_cast<int>(s) + 1,
                             static_cast<int>(in_.scene.stages.size()));
      result.stages.push_back(run_stage(s));
      if (!result.stages.back().converged) {
        result.converged = false;
        return result;
      }
      observer_.stage_ends(result.stages.back());
    }
    return result;
  }

 private:
  void prepare() {
    core::Mistakes mistakes;
    for (std::size_t s = 0; s < in_.scene.stages.size(); ++s) {
      const model::StageData& stage = in_.scene.stages[s];
      Prepared& ready = prepared_.emplace_back();
      ready.constraints = build_constraints(in_.model, stage, mistakes);
      const bool held_as_before = s > 0 && ready.constraints.same_dofs(prepared_[s - 1].constraints);
      if (mistakes.empty() && !held_as_before)
        check_support(in_.model, in_.scene, stage, ready.constraints, mistakes);
      for (const model::Call& call : in_.plan.stages[s].calls) {
        const auto timing = core::ledger().time("prepare", call.effect);
        in_.effects.at(call.effect)->contribute({in_.scene, stage, in_.model, state_, mistakes}, ready.terms);
      }
      ready.load.assign(in_.model.dofs.size(), 0);
      for (const auto& load : ready.terms.loads) load->add_force(ready.load);
    }
    for (const model::ProbeData& probe : in_.scene.probes)
      probe_points_.push_back(model::point_at(in_.model.mesh, {probe.at, probe.lip, probe.place}, mistakes));
    mistakes.throw_if_any();
    warn_of_mixed_probes(in_.scene, in_.model, probe_points_);
  }

  /// The state and load that stage `s` starts from.
  Ended start_of(std::size_t s) const {
    const int parent = in_.scene.stages[s].parent;
    if (parent < 0) return {state_, std::vector<double>(in_.model.dofs.size()), -1};
    return ended_[parent];
  }

  LocalTerms& local_for(const Prepared& ready) {
    if (!local_ || !local_->serves(ready.terms.local, ready.constraints)) {
      local_.emplace(ready.terms.local, ready.constraints);
      ++equations_;
    }
    return *local_;
  }

  Bulk& bulk_for(const Prepared& ready, LocalTerms& local, model::StageResult& result) {
    const BulkTerms terms{ready.terms.stiffness, ready.terms.nonlinear};
    result.factored = !bulk_ || !bulk_->serves(terms, ready.constraints, local.touched());
    if (result.factored) {
      ++equations_;
      bulk_.reset();  // frees the old factor first
      local.bulk_changed();
      bulk_.emplace(in_.model, terms, ready.constraints, local.touched(), make_solver(terms.symmetric()));
    }
    result.unknowns = ready.constraints.unknowns();
    result.kept = static_cast<Index>(bulk_->kept().size());
    result.solver = bulk_->report().ordering;
    return *bulk_;
  }

  /// The scene's solver; where a tangent is not symmetric, one that takes such.
  std::unique_ptr<algebra::LinearSolver> make_solver(bool symmetric) const {
    const core::Settings& settings = in_.scene.solver;
    if (symmetric) return in_.registry.make<algebra::MakeSolver>("solver", settings.name)(settings);
    const std::vector<std::string> names = in_.registry.names("unsymmetric_solver");
    if (names.empty())
      throw core::InputError(
          core::Mistake{in_.scene.solver.place,
                        "a law's tangent is not symmetric, and no module provides a solver for such",
                        "take associated flow, or see that the modules folder is complete"});
    return in_.registry.make<algebra::MakeSolver>("unsymmetric_solver", names.front())({});
  }

  model::StageResult run_stage(std::size_t s) {
    const Prepared& ready = prepared_[s];
    stage_ = s;
    model::StageResult result;
    result.name = in_.scene.stages[s].name;
    for (const model::Call& call : in_.plan.stages[s].calls) result.effects.push_back(call.effect);
    LocalTerms& local = local_for(ready);
    Bulk& bulk = bulk_for(ready, local, result);
    if (!bulk.linear() && !local.empty())
      core::log().info(
          "stage '" + result.name +
          "': the body may yield, so it is factored and condensed to its joints in every iteration");
    if (!bulk.report().done) {
      result.converged = false;
      result.reason = bulk.report().reason + at_unknown(ready.constraints, bulk.report().unknown);
      result.advice = "see that supports hold every body; if memory ran out, take fewer cells";
      return result;
    }
    const Ended start = start_of(s);
    state_ = start.state;
    state_.revert();
    if (!step_through(bulk, local, ready, start, result)) return result;
    finish(s, start, bulk, local, result);
    return result;
  }

  /// " at (x, y)" of an unknown; nothing for -1.
  std::string at_unknown(const model::Constraints& constraints, Index unknown) const {
    return unknown < 0 ? "" : " at " + place_of_dof(in_.model, constraints.dof[unknown]);
  }

  /// Load steps from the start to the stage's end: one if it converges, else halved and grown again.
  bool step_through(Bulk& bulk, LocalTerms& local, const Prepared& ready, const Ended& start,
                    model::StageResult& result) {
    const auto from = start.state.committed(displacement);
    if (!agrees(ready.constraints, from, result)) return false;
    const double largest = 1.0 / steps_of(in_.scene.stages[stage_]);
    double reached = 0, size = largest;
    int step = 1;
    std::vector<double> load(ready.load.size()), prescribed(ready.load.size()), balanced;
    if (start.equations == equations_) balanced = start.load;
    while (reached < 1) {
      const double to = reached + size > 1 - 1e-9 ? 1.0 : reached + size;
      for (std::size_t dof = 0; dof < load.size(); ++dof) {
        load[dof] = to == 1 ? ready.load[dof] : start.load[dof] + to * (ready.load[dof] - start.load[dof]);
        const double end = ready.constraints.at_value[dof] ? ready.constraints.value[dof] : from[dof];
        prescribed[dof] = to == 1 ? end : from[dof] + to * (end - from[dof]);
      }
      StepReport report = take_step(bulk, local, ready.constraints, {load, prescribed, balanced});
      for (model::Iteration row : report.iterations) {
        row.step = step;
        observer_.iterated(row);
        result.iterations.push_back(std::move(row));
      }
      result.backward_error = report.backward_error;
      result.forward_error = report.forward_error;
      if (report.converged) {
        state_.commit();
        out_of_balance_ = std::move(report.out_of_balance);
        balanced = load;
        reached = to;
        size = std::min({1.0 - reached, 2 * size, largest});
        ++step;
        continue;
      }
      state_.revert();
      size /= 2;
      if ((bulk.linear() && local.empty()) || (report.singular && !report.held_before) ||
          size < std::ldexp(largest, -most_cuts)) {
        result.converged = false;
        result.reason = report.reason + at_unknown(ready.constraints, report.worst);
        result.advice = report.advice;
        if (report.singular) result.reason += who_moves(ready, report);
        if (reached > 0)
          result.reason +=
              " (reached " + std::to_string(static_cast<int>(100 * reached)) + " % of the stage)";
        return false;
      }
      core::log().info("stage '" + result.name + "': " + report.reason + "; trying a step of half the size");
    }
    return true;
  }

  std::string who_moves(const Prepared& ready, const StepReport& report) const {
    const std::string moving = moving_bodies(in_.model, in_.scene, report.mechanism);
    return moving.empty() ? loose_bodies(in_.model, in_.scene, ready.constraints) : moving;
  }

  /// One step. Points that move along each other are paired where the step begins, and then where it ends.
  StepReport take_step(Bulk& bulk, LocalTerms& local, const model::Constraints& constraints,
                       StepTarget target) {
    const bool moving = local.follow(state_);
    if (moving) target.balanced = {};
    StepReport report = advance(bulk, local, constraints, target, state_);
    if (!moving || !report.converged) return report;
    local.follow(state_);
    std::vector<model::Iteration> rows = std::move(report.iterations);
    report = advance(bulk, local, constraints, target, state_);
    rows.insert(rows.end(), report.iterations.begin(), report.iterations.end());
    report.iterations = std::move(rows);
    return report;
  }

  static int steps_of(const model::StageData& stage) {
    const core::Settings::Entry* entry = stage.settings.find("steps");
    const core::Quantity* steps = entry ? entry->value.quantity() : nullptr;
    return steps ? static_cast<int>(steps->value) : 1;
  }

  /// False if a point is held where it is and, by another support, somewhere else.
  bool agrees(const model::Constraints& constraints, std::span<const double> from,
              model::StageResult& result) const {
    for (Index dof = 0; dof < in_.model.dofs.size(); ++dof) {
      if (!constraints.in_place[dof] || !constraints.at_value[dof]) continue;
      // Both say the same if they differ by round-off of displacements at hand.
      if (std::abs(from[dof] - constraints.value[dof]) <= 1e-12 * std::abs(from[dof])) continue;
      result.converged = false;
      result.reason = "the point " + place_of_dof(in_.model, dof) + " is fixed where it is, displaced by " +
                      core::format_quantity(from[dof], {1, 0, 0}) + ", and by another support held at " +
                      core::format_quantity(constraints.value[dof], {1, 0, 0});
      result.advice = "leave one of the two supports out of this stage";
      return false;
    }
    return true;
  }

  void finish(std::size_t s, const Ended& start, const Bulk& bulk, const LocalTerms& local,
              model::StageResult& result) {
    const auto timing = core::ledger().time("recover");
    const Prepared& ready = prepared_[s];
    result.sections = begin_sections(in_.model);
    for (const auto& term : ready.terms.stiffness) term->add_results(state_, result);
    for (const auto& term : ready.terms.nonlinear) term->add_results(state_, result);
    for (const auto& term : ready.terms.local) term->add_results(state_, result);
    for (const auto& term : ready.terms.loads) term->add_results(state_, result);
    add_lip_pressures(in_.model, ready.terms, result);
    double largest = 0;
    for (const double u : state_.committed(displacement)) largest = std::max(largest, std::abs(u));
    if (largest > large_share * in_.model.length)
      core::log().warning("stage '" + result.name + "': displacements reach " +
                          core::format_quantity(largest, {1, 0, 0}) + ", " +
                          std::to_string(static_cast<int>(100 * largest / in_.model.length)) +
                          " % of the model: small-displacement theory, which is used, no longer holds");
    if (condition_wanted()) result.condition = condition_estimate(bulk, local, ready.constraints.unknowns());
    warn_of_round_off(result);
    if (out_of_balance_.empty()) out_of_balance_ = out_of_balance(bulk, local, ready.load, state_);
    // Where all load is taken off, what is left is round-off of the forces that were.
    for (const double u : start.state.committed(displacement)) largest = std::max(largest, std::abs(u));
    const double share = at_rest(ready) ? negligible_at_rest : negligible;
    result.balance =
        balance(in_.model, in_.scene.stages[s],
                {ready.terms, ready.constraints, state_, out_of_balance_, share * bulk.norm() * largest});
    add_section_forces(bulk, ready, result);
    add_probes(in_.scene, in_.model, probe_points_, result);
    if (s == 0) warn_of_unread(in_.scene, result);
    if (result.balance.relative_error > poor_balance)
      core::log().warning("stage '" + result.name + "': loads and reactions differ by " +
                          std::to_string(100 * result.balance.relative_error) + " %");
    add_extremes(in_.model, result);
    ended_.push_back({state_, ready.load, equations_});
    drop_unneeded(s);
  }

  static bool at_rest(const Prepared& stage) {
    const auto none = [](double value) { return value == 0; };
    return std::ranges::all_of(stage.load, none) && std::ranges::all_of(stage.constraints.value, none);
  }

  void add_section_forces(const Bulk& bulk, const Prepared& ready, model::StageResult& result) {
    if (result.sections.empty()) return;
    // Without contact what is out of balance is what supports and joints exert.
    const std::vector<double> outside =
        out_of_balance(bulk, LocalTerms({}, ready.constraints), ready.load, state_);
    finish_sections({in_.model, ready.terms, state_, outside}, result.sections);
  }

  bool condition_wanted() const {
    const core::Settings::Entry* entry = in_.scene.root.find("condition_estimate");
    return entry && entry->value.boolean() && *entry->value.boolean();
  }

  static void warn_of_round_off(const model::StageResult& result) {
    if (result.forward_error < poor_forward_error) return;
    char text[120];
    std::snprintf(text, sizeof text, "': round-off changes displacements by some %.0e of the largest",
                  result.forward_error);
    core::log().warning("stage '" + result.name + text);
  }

  /// Frees the states that no later stage starts from.
  void drop_unneeded(std::size_t s) {
    for (std::size_t e = 0; e < ended_.size(); ++e) {
      bool needed = false;
      for (std::size_t later = s + 1; later < in_.scene.stages.size(); ++later)
        needed |= in_.scene.stages[later].parent == static_cast<int>(e);
      if (!needed) ended_[e] = {};
    }
  }

  const MarchInput& in_;
  Observer& observer_;
  fields::State state_;
  std::vector<Prepared> prepared_;
  std::vector<Ended> ended_;
  std::vector<Index> probe_points_;
  std::vector<double> out_of_balance_;  ///< at the stage's end; empty if the last step did not tell
  std::size_t stage_ = 0;               ///< at work
  int equations_ = 0;                   ///< counts bulks and joints: states of the same number obey the same
  std::optional<Bulk> bulk_;
  std::optional<LocalTerms> local_;
};

}  // namespace

model::RunResult march(const MarchInput& input, Observer& observer) {
  return March(input, observer).run();
}

}  // namespace ashlar::solve
