// Loads that come and go, and loads at the limit of what can be carried.

#include <cmath>
#include <cstdio>
#include <numbers>

#include "stability/scene_file.hpp"

namespace ashlar::stability {

namespace {

std::string order_name(int order) {
  return "order " + std::to_string(order);
}

Case elastic_ramp_row() {
  Case row;
  row.group = "Loads";
  row.name = "weight put on in steps, taken off, put on again: elastic";
  row.risk = "steps that add up to another answer; something left when nothing acts";
  row.bound =
      "1e-12 of the largest displacement: each stage is one linear solve for its whole load; balance the "
      "same, but 1e-8 "
      "where no load is left to measure by";
  row.plants = {Fault::upward_weight};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order) {
      const auto set = [&](const char* steps) {
        return test::ParameterValues{{"order", std::to_string(order)}, {"yields", "false"}, {"steps", steps}};
      };
      const auto ramp = run_scene("weighed_soil", set("4"), fault),
                 once = run_scene("weighed_soil", set("1"), Fault::none);
      const auto& u = values(once.stage("up"), "displacement");
      const std::string name = order_name(order);
      outcome.worst(name + " steps", relative_difference(values(ramp.stage("up"), "displacement"), u), 1e-12);
      outcome.worst(name + " again", relative_difference(values(ramp.stage("again"), "displacement"), u),
                    1e-12);
      std::vector<double> left = values(ramp.stage("down"), "displacement");
      for (std::size_t i = 0; i < left.size(); ++i) left[i] += u[i];
      outcome.worst(name + " left", relative_difference(left, u), 1e-12);
      for (const model::StageResult& stage : ramp.result.stages)
        outcome.worst(name + " balance", stage.balance.relative_error, stage.name == "down" ? 1e-8 : 1e-12);
    }
    return outcome;
  };
  return row;
}

Case yielding_ramp_row() {
  Case row;
  row.group = "Loads";
  row.name = "the same with a bank that yields at its foot, down to half the weight and back";
  row.risk = "history lost or counted twice when the load turns; Newton stuck at the turn";
  row.bound =
      "balance 1e-10, as Newton's steps end there; unloading is a straight way on which the second loading "
      "goes back to "
      "the "
      "first state, within 1e-7: what is out of balance, times the softness (1e3) of a bank that "
      "yields";
  row.plants = {Fault::lost_history, Fault::wrong_sign};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order) {
      const std::string name = order_name(order);
      const test::ParameterValues set{{"order", std::to_string(order)}, {"steps", "2"}, {"least", "0.5"}};
      const auto run = run_scene("weighed_soil", set, fault);
      const auto at = [&](const char* stage) { return values(run.stage(stage), "displacement"); };
      const std::vector<double> up = at("up"), half_way = at("down 1");
      std::vector<double> middle = at("down");
      for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = 0.5 * (middle[i] + up[i]);
      outcome.worst(name + " unloading", relative_difference(half_way, middle), 1e-7);
      outcome.worst(name + " loading", relative_difference(at("again 1"), half_way), 1e-7);
      outcome.worst(name + " again", relative_difference(values(run.stage("again"), "displacement"), up),
                    1e-7);
      outcome.worst(name + " balance", worst_balance(run.result), 1e-10);
      if (run.stage("up").iterations.back().number < 3) outcome.missing.push_back(name + ": nothing yields");
    }
    return outcome;
  };
  return row;
}

/// 2 c cos φ/(1 − sin φ) for c = 10 kPa and φ = 30°.
double strength() {
  return 2 * 10e3 * std::cos(std::numbers::pi / 6) / (1 - std::sin(std::numbers::pi / 6));
}

test::ParameterValues pressed(int order, double share, Fault fault) {
  char pressure[40];
  std::snprintf(pressure, sizeof pressure, "%.17g", share * strength());
  return {{"order", std::to_string(order)},
          {"pressure", pressure},
          {"cohesion", fault == Fault::stronger ? "10.2e3" : "10e3"}};
}

Case limit_row() {
  Case row;
  row.group = "Loads";
  row.name = "a limit load approached from below and overshot";
  row.risk = "Newton fails below the limit, or finds an answer above it";
  row.bound =
      "0.999 and 0.999999 of the limit are carried; 1.01 of it stops, no earlier than 1/64 of the stage (the "
      "smallest step) before the limit and not after it, and says so";
  row.plants = {Fault::stronger};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order) {
      for (const double share : {0.999, 0.999999})
        outcome.worst(order_name(order) + " balance",
                      worst_balance(run_scene("pressed_soil", pressed(order, share, fault), fault).result),
                      1e-9);
      const std::string said = stopped_by("pressed_soil", pressed(order, 1.01, fault), fault);
      outcome.must_say(said,
                       {"stage 'whole' did not converge", "most of them at (", "(reached ", "less of it"});
      const auto at = said.find("(reached ");
      if (at == std::string::npos) continue;
      // The stage goes from 0.505 of the limit to 1.01 of it.
      const double limit = (1 / 1.01 - 0.5) / 0.5, reached = std::stod(said.substr(at + 9)) / 100;
      outcome.worst(order_name(order) + " missed", limit - reached, 1.0 / 64 + 0.01);
      if (reached > limit) outcome.missing.push_back(order_name(order) + ": carried more than the limit");
    }
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> load_rows() {
  return {elastic_ramp_row(), yielding_ramp_row(), limit_row()};
}

}  // namespace ashlar::stability
