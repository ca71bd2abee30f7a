// Statuses of joints that come round: found, broken by either rule, and solved right.

#include <algorithm>
#include <cmath>

#include "contact/cycle_rules/cycle_rules.hpp"
#include "stability/scene_file.hpp"

namespace ashlar::stability {

namespace {

/// The scene's rule, which counts how often a cycle asks it for a point.
class Counted final : public contact::CycleRule {
 public:
  Counted(std::shared_ptr<const contact::CycleRule> rule, int& asked)
      : rule_(std::move(rule)), asked_(asked) {}
  std::size_t choose(std::span<const double> misfits) const override {
    ++asked_;
    return rule_->choose(misfits);
  }

 private:
  std::shared_ptr<const contact::CycleRule> rule_;
  int& asked_;
};

struct Counting {
  test::SceneRun run;
  int asked = 0;
};

Counting count_cycles(const std::string& scene, test::ParameterValues set, const std::string& rule,
                      Fault fault) {
  Counting counting;
  set.emplace_back("rule", rule);
  counting.run = run_scene(scene, set, fault, {}, [&](app::Scenario& scenario) {
    const auto make = scenario.registry.make<contact::MakeCycleRule>("cycle_rule", rule);
    scenario.registry.add_schema({"cycle_rule", "counted", "", "", {}});
    scenario.registry.add_make(
        "cycle_rule", "counted",
        std::function<contact::MakeCycleRule>([make, &counting](const core::Settings& said) {
          return std::make_shared<const Counted>(make(said), counting.asked);
        }));
    for (auto& entry : scenario.scene.root.entries) {
      if (entry.key != "cycle_rule") continue;
      auto counted = std::make_shared<core::Settings>();
      counted->kind = "cycle_rule", counted->name = "counted", counted->place = entry.object->place;
      entry.object = counted;
    }
  });
  return counting;
}

/// The iteration table of a cycle that is broken: a status comes back, as wrong as before, and instead of
/// several points one changes.
bool comes_back(const model::StageResult& stage) {
  const auto fact = [](const model::Iteration& row, const char* name) {
    const auto found = std::ranges::find(row.facts, name, &std::pair<std::string, double>::first);
    return found == row.facts.end() ? 0.0 : found->second;
  };
  for (std::size_t j = 0; j < stage.iterations.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const auto &before = stage.iterations[i], &again = stage.iterations[j];
      if (!(fact(before, "changed") > 1) || fact(again, "changed") != 1) continue;
      const double was = fact(before, "complementarity"), is = fact(again, "complementarity");
      if (was > 0 && std::abs(is - was) < 1e-9 * was) return true;
    }
  return false;
}

void add_broken(const Counting& counting, Outcome& outcome) {
  if (counting.asked == 0) outcome.missing.push_back("the rule was not asked");
  if (!comes_back(counting.run.result.stages.back()))
    outcome.missing.push_back("no status comes back in the table");
}

/// What any solution of one step from nothing keeps, whatever way led to it.
void add_laws(const test::SceneRun& run, double mu, Outcome& outcome) {
  double pressure = 0, move = 0;
  for (const auto& joint : run.result.stages.back().joints)
    for (const auto& row : joint.rows) {
      pressure = std::max(pressure, row.pressure);
      move = std::max({move, std::abs(row.opening), mu > 0 ? std::abs(row.slip) : 0.0});
    }
  double worst = 0;
  for (const auto& joint : run.result.stages.back().joints)
    for (const auto& row : joint.rows) {
      const double p = row.pressure / pressure, g = row.opening / move;
      worst = std::max({worst, -p, -g, std::abs(p * g), std::abs(row.shear) / pressure - mu * p});
      if (row.state == model::JointResult::Row::State::slip && mu > 0)
        worst = std::max(
            {worst, mu * p - std::abs(row.shear) / pressure, -row.slip * row.shear / (move * pressure)});
      if (row.state == model::JointResult::Row::State::stick)
        worst = std::max(worst, std::abs(row.slip) / move);
    }
  outcome.worst("laws", worst, 1e-9);
}

Case cycle_case(std::string name, std::string risk, std::string bound) {
  return make_case("Cycles of statuses", std::move(name), std::move(risk), std::move(bound),
                   {Fault::cured, Fault::frozen_status, Fault::scaled_traction});
}

Case stops_row() {
  Case row = cycle_case(
      "a beam between three stops, smooth: all points open, five statuses later all open again",
      "an iteration without end; steps cut for nothing; either status of the cycle as an answer",
      "the rule is asked; the table has the first status again, with 1 changed in place of 6; without "
      "friction there is one solution: that of "
      "ten steps in which no status comes back, to 1e-10; both rules, multipliers and penalty; laws to 1e-9");
  row.run = [](Fault fault) {
    Outcome outcome;
    const std::string level = fault == Fault::cured ? "9.0" : "2.0";
    for (const char* enforce : {"lagrange", "penalty"}) {
      const test::ParameterValues set{{"enforce", enforce}, {"level", level}};
      auto small = set;
      small.emplace_back("steps", "10");
      const Counting steps = count_cycles("beam_between_stops", small, "worst_point", Fault::none);
      outcome.worst("asked in small steps", steps.asked, 0);
      for (const char* rule : {"worst_point", "first_point"}) {
        const Counting once = count_cycles("beam_between_stops", set, rule, fault);
        add_broken(once, outcome);
        if (std::string(enforce) == "lagrange") add_laws(once.run, 0, outcome);
        outcome.worst("balance", worst_balance(once.run.result), 1e-9);
        outcome.worst("u",
                      relative_difference(values(once.run.stage("bend"), "displacement"),
                                          values(steps.run.stage("bend"), "displacement")),
                      1e-10);
      }
    }
    return outcome;
  };
  return row;
}

Case teeth_row() {
  Case row = cycle_case(
      "a toothed block pressed and pushed at once, μ = 3: two statuses of two points call for each other",
      "as above; tangents are unsymmetric, and no rule is sure to end",
      "the rule is asked; `changed` is 2, 2, and 1 as the first of both comes back, which leads out; the "
      "solution keeps Coulomb's "
      "and "
      "contact's laws to 1e-9 at every point, and is the same by both rules to 1e-12; balance to the height "
      "of "
      "the teeth over the block, 1e-5");
  row.run = [](Fault fault) {
    Outcome outcome;
    const double mu = fault == Fault::cured ? 0.5 : 3;
    std::vector<Counting> both;
    for (const char* rule : {"worst_point", "first_point"}) {
      both.push_back(count_cycles("toothed_joint", {{"mu", digits(mu)}}, rule, fault));
      add_broken(both.back(), outcome);
      add_laws(both.back().run, mu, outcome);
      outcome.worst("balance", worst_balance(both.back().run.result), 1e-5);
      outcome.worst("statuses", static_cast<double>(both.back().run.result.stages.back().iterations.size()),
                    5);
    }
    outcome.add("u",
                relative_difference(values(both[0].run.stage("press"), "displacement"),
                                    values(both[1].run.stage("press"), "displacement")),
                1e-12);
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> cycle_rows() {
  return {stops_row(), teeth_row()};
}

}  // namespace ashlar::stability
