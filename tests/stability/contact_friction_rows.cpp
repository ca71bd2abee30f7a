// Friction: strengths, first steps, turns of the load. pushed_joint.lua has a block of 2 m by 0.5 m under 1
// MPa that is pushed along its rough base, by a displacement or by a share of its strength.

#include <algorithm>
#include <cmath>

#include "contact/joint_law.hpp"
#include "stability/scene_file.hpp"

namespace ashlar::stability {

namespace {

constexpr double pressed = 2e6;  // N on the joint, as the scene says

Case friction_case(std::string name, std::string risk, std::string bound, std::vector<Fault> plants) {
  return make_case("Friction", std::move(name), std::move(risk), std::move(bound), std::move(plants));
}

/// What all of these must keep: balance, and shear within the strength everywhere.
void add_sound(const test::SceneRun& run, double mu, Outcome& outcome) {
  outcome.worst("balance", worst_balance(run.result), 1e-10);
  double most = 0, excess = 0;
  for (const auto& row : run.result.stages.back().joints.at(0).rows) {
    most = std::max(most, row.pressure);
    excess = std::max(excess, std::abs(row.shear) - mu * row.pressure);
  }
  outcome.worst("shear beyond strength", excess / most, 1e-9);
}

Case strength_row() {
  Case row =
      friction_case("μ = 0, 10⁻⁶, 0.3, 2 and 10, pushed by 1 cm from nothing in one step",
                    "no status fits at first; strong friction makes tangents unsymmetric, and bodies pivot",
                    "the push is μ N to 1e-10 where the block slides (μ ≤ 2) and the shear of the joint "
                    "always; |τ| ≤ μ p to "
                    "1e-9, ten times what a status may be off; at most 10 "
                    "statuses, by multipliers, penalty and augmented",
                    {Fault::stronger, Fault::scaled_traction, Fault::frozen_status});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const double mu : {0.0, 1e-6, 0.3, 2.0, 10.0})
      for (const char* enforce : {"lagrange", "penalty", "augmented_lagrange"}) {
        const double said = mu * (fault == Fault::stronger ? 1.02 : 1);
        const auto run =
            run_scene("pushed_joint",
                      {{"mu", digits(said)}, {"move", "0.01"}, {"one", "true"}, {"enforce", enforce}}, fault);
        const auto& stage = run.stage("push");
        add_sound(run, mu, outcome);
        const double shear = std::abs(stage.joints[0].shear_force), strength = mu * pressed;
        if (mu <= 2)
          outcome.worst("slides", std::abs(shear - strength) / (mu > 0 ? strength : pressed), 1e-10);
        for (const auto& [name, reaction] : stage.balance.reactions)
          if (name == "push") outcome.worst("push", std::abs(std::abs(reaction.x) - shear) / pressed, 1e-10);
        outcome.worst("statuses", static_cast<double>(stage.iterations.size()), 10);
      }
    return outcome;
  };
  return row;
}

test::ParameterValues by_share(double share, const char* steps, const char* order) {
  return {{"share", digits(share)}, {"one", "true"}, {"steps", steps}, {"order", order}};
}

Case first_step_row() {
  Case row = friction_case(
      "pressed and pushed at once from nothing, to 0.5, 0.99 and 0.9999 of the strength; and to 1.0001",
      "the first status is a guess; strength is nothing where nothing presses yet",
      "the joint's shear is the push to 1e-10, |τ| ≤ μ p; beyond the strength it stops and names the body, "
      "its motion "
      "and the cure",
      {Fault::stronger, Fault::scaled_traction, Fault::frozen_status});
  row.run = [](Fault fault) {
    Outcome outcome;
    const std::string mu = digits(0.3 * (fault == Fault::stronger ? 1.02 : 1));
    for (const char* order : {"1", "2"})
      for (const double share : {0.5, 0.99, 0.9999}) {
        const auto run = run_scene("pushed_joint", by_share(share, "1", order), fault);
        add_sound(run, 0.3, outcome);
        const double push = share * 0.3 * pressed;
        outcome.worst("push", std::abs(std::abs(joint_of(run, "push").shear_force) / push - 1), 1e-10);
      }
    auto beyond = by_share(fault == Fault::stronger ? 1.0001 / 1.02 : 1.0001, "1", "1");
    beyond.emplace_back("mu", mu);
    outcome.must_say(
        stopped_by("pushed_joint", beyond, fault),
        {"do not hold a body", "'block' slides along (1.00, 0.00)", "hold the body by a support"});
    return outcome;
  };
  return row;
}

Case steps_row() {
  Case row = friction_case(
      "the same in 1, 3 and 10 steps", "an answer that hangs on the last step's size",
      "1e-10: what grows in proportion from nothing has a solution in proportion, slipping points too",
      {Fault::frozen_status, Fault::scaled_traction});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* order : {"1", "2"}) {
      const auto once = run_scene("pushed_joint", by_share(0.9, "1", order), Fault::none);
      for (const char* steps : {"3", "10"}) {
        const auto run = run_scene("pushed_joint", by_share(0.9, steps, order), fault);
        outcome.worst("u",
                      relative_difference(values(run.stage("push"), "displacement"),
                                          values(once.stage("push"), "displacement")),
                      1e-10);
        const auto &a = joint_of(run, "push"), &b = joint_of(once, "push");
        for (std::size_t i = 0; i < a.rows.size(); ++i) {
          outcome.worst("shear", std::abs(a.rows[i].shear - b.rows[i].shear) / b.max_shear, 1e-10);
          if (a.rows[i].state != b.rows[i].state) outcome.missing.push_back("another status");
        }
      }
    }
    return outcome;
  };
  return row;
}

Case turn_row() {
  Case row =
      friction_case("a push that turns round within a step: pushed right, then left, in 1 step and in 7",
                    "slip that turns back keeps its sense, or forgets where it rests",
                    "by force, 0.9 of the strength each way: 1e-9, as slip after the turn grows in "
                    "proportion again and no point turns "
                    "twice, so that steps leave no trace; by displacement: −μ N to 1e-10",
                    {Fault::lost_history, Fault::frozen_status, Fault::scaled_traction});
  row.run = [](Fault fault) {
    Outcome outcome;
    const auto pushed = [&](const char* steps, Fault planted) {
      return run_scene("pushed_joint", {{"share", "0.9"}, {"back", "-0.9"}, {"steps", steps}}, planted);
    };
    const auto one = pushed("1", fault), seven = pushed("7", Fault::none);
    outcome.add("u",
                relative_difference(values(one.stage("back"), "displacement"),
                                    values(seven.stage("back"), "displacement")),
                1e-9);
    add_sound(one, 0.3, outcome);
    for (const char* steps : {"1", "7"}) {
      const auto run =
          run_scene("pushed_joint", {{"move", "0.01"}, {"back", "-0.01"}, {"steps", steps}}, fault);
      outcome.worst("slides back", std::abs(joint_of(run, "back").shear_force / (-0.3 * pressed) - 1), 1e-10);
      add_sound(run, 0.3, outcome);
    }
    return outcome;
  };
  return row;
}

Case friction_units_row() {
  Case row = friction_case(
      "Pa to GPa, m to mm: a joint that slips in part, and back", "a tolerance with a hidden unit",
      "the same statuses at the same iterations; to the bit with powers of two, to 1e-8 with 10⁻⁹ and 10³",
      {Fault::absolute_number});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* enforce : {"lagrange", "penalty", "augmented_lagrange"}) {
      const auto run = [&](const char* pa, const char* m) {
        return run_scene(
            "pushed_joint",
            {{"pa", pa}, {"m", m}, {"share", "0.9"}, {"back", "-0.9"}, {"steps", "2"}, {"enforce", enforce}},
            fault);
      };
      const auto si = run("1.0", "1.0");
      const auto compare = [&](const test::SceneRun& other, double metre, double bound,
                               const std::string& name) {
        compare_units(si, other, metre, bound, name, outcome);
        for (const char* stage : {"press", "push", "back"})
          for (std::size_t i = 0; i < joint_of(si, stage).rows.size(); ++i)
            if (joint_of(si, stage).rows[i].state != joint_of(other, stage).rows[i].state)
              outcome.missing.push_back(name + ": another status");
      };
      compare(run("2^-30", "2^10"), 1024, 0, "binary");
      compare(run("1e-9", "1e3"), 1e3, 1e-8, "decimal");
    }
    return outcome;
  };
  return row;
}

/// Strength that is thrice as high once a point has slipped: for a push between both no status fits.
class Cornered final : public contact::Friction {
 public:
  contact::Strength strength(double pressure, double path) const override {
    const double mu = path == 0 ? 0.3 : 0.9;
    return {mu * pressure, mu, 0};
  }
};

std::string cycle_text(Fault fault) {
  if (fault == Fault::cured) return stopped_by("pushed_joint", {{"share", "0.5"}}, Fault::none);
  return stopped_by("pushed_joint", {{"share", "0.5"}}, Fault::none, {}, [](app::Scenario& scenario) {
    scenario.registry.add_schema({"friction", "cornered", "", "", {}});
    scenario.registry.add_make(
        "friction", "cornered",
        std::function<contact::MakeFriction>(
            [](const core::Settings&, core::Mistakes&) { return std::make_shared<const Cornered>(); }));
    for (auto& entry : scenario.scene.joints.at(0).settings.entries) {
      if (entry.key != "friction") continue;
      auto law = std::make_shared<core::Settings>();
      law->kind = "friction", law->name = "cornered", law->place = entry.object->place;
      entry.object = law;
    }
  });
}

Case message_row(std::string name, std::string risk, std::string (*said)(Fault),
                 std::vector<std::string> words) {
  return must_stop(friction_case(std::move(name), std::move(risk), "stops, and names the points and the cure",
                                 {Fault::cured}),
                   said, std::move(words));
}

std::string jump_text(Fault fault) {
  return stopped_by("pushed_joint", {{"share", "0.5"}, {"jump", fault == Fault::cured ? "1.0" : "3.0"}},
                    Fault::none);
}

}  // namespace

std::vector<Case> friction_rows() {
  return {
      strength_row(),
      first_step_row(),
      steps_row(),
      turn_row(),
      friction_units_row(),
      message_row(
          "two statuses that call for each other: a strength that is thrice as high once a point has slipped",
          "an iteration without end, or either of the two as an answer", cycle_text,
          {"repeats itself without settling", "points flip: seam at (", "smaller cells along the joint"}),
      message_row("the same law written in the scenario, with its slope by differences",
                  "a tangent of a jump; blamed on the linear system", jump_text,
                  {"no traction of the joint's law is in balance at seam at (", "load spread over"}),
  };
}

}  // namespace ashlar::stability
