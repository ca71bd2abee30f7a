// Joints that press: stiffnesses, gaps and meshes that are hard on them. pressed_joint.lua has a block of 2 m
// on another, under 1 MPa or under a pressure that leans so far to one side that the joint opens.

#include <algorithm>
#include <cmath>

#include "core/log.hpp"
#include "stability/scene_file.hpp"

namespace ashlar::stability {

namespace {

constexpr double pressed = 1e6;  // as the scene says

Case contact_case(std::string name, std::string risk, std::string bound, std::vector<Fault> plants) {
  return make_case("Contact", std::move(name), std::move(risk), std::move(bound), std::move(plants));
}

/// How far the pressure is from an even one, everywhere along a joint.
double uneven(const model::JointResult& joint, double right = pressed) {
  double worst = joint.rows.empty() ? INFINITY : 0;
  for (const auto& row : joint.rows) worst = std::max(worst, std::abs(row.pressure / right - 1));
  return worst;
}

double iterations(const test::SceneRun& run) {
  return static_cast<double>(run.result.stages.back().iterations.size());
}

Case closed_row() {
  Case row = contact_case("penalty factors 10⁻² to 10⁸ on a joint that stays closed",
                          "the factor spoils the conditioning, or the status flickers",
                          "p to 1e-12 up to 10⁸, as tractions are the unknowns: nothing is a difference of "
                          "two large displacements; ten times "
                          "that for 10⁻², which lets the block move a hundred times farther, with its "
                          "round-off; one status, one solve",
                          {Fault::scaled_traction, Fault::reversed_gap});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* order : {"1", "2"})
      for (const char* factor : {"1e-2", "1.0", "1e2", "1e4", "1e6", "1e8"}) {
        const auto run = run_scene("pressed_joint", {{"factor", factor}, {"order", order}}, fault);
        const bool soft = std::string(factor) == "1e-2";
        outcome.worst(soft ? "p, factor 10⁻²" : "p", uneven(joint_of(run, "press")), soft ? 1e-11 : 1e-12);
        outcome.worst("iterations", iterations(run), 1);
      }
    return outcome;
  };
  return row;
}

Case stiffness_row() {
  Case row = contact_case(
      "penalties of 10¹¹, 10¹², 10¹³ Pa/m on a joint that stays closed",
      "public codes take 17 and 91 iterations here, and fail at the third",
      "as above; the block comes down by q (2 L/E' + 1/K), to 1e-12: 2e-16 of a hundred cells' compression",
      {Fault::scaled_traction, Fault::reversed_gap});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const double k : {1e11, 1e12, 1e13}) {
      const auto run = run_scene("pressed_joint", {{"stiffness", digits(k)}}, fault);
      outcome.worst("p", uneven(joint_of(run, "press")), 1e-12);
      outcome.worst("iterations", iterations(run), 1);
      double least = 0;
      for (const model::Extreme& each : run.stage("press").extremes)
        if (each.quantity == "uy") least = each.least;
      const double down = pressed * (2 * (1 - 0.3 * 0.3) / 10e9 + 1 / k);
      outcome.worst("settlement", std::abs(-least / down - 1), 1e-12);
    }
    return outcome;
  };
  return row;
}

/// Worst difference of two joints' pressures, over the largest.
double pressure_difference(const model::JointResult& a, const model::JointResult& b) {
  double worst = a.rows.size() == b.rows.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.rows.size(), b.rows.size()); ++i)
    worst = std::max(worst, std::abs(a.rows[i].pressure - b.rows[i].pressure) / b.max_pressure);
  return worst;
}

/// A joint that opens, by its statics, and against `exact`.
void add_opening(const test::SceneRun& run, double factor, const model::JointResult& exact,
                 Outcome& outcome) {
  const auto& joint = joint_of(run, "press");
  const auto& load = run.stage("press").balance.load;
  outcome.worst("resultant", std::abs(joint.normal_force / -load.y - 1), 1e-10);
  outcome.worst("its place", std::abs(joint.action_s - load.moment / load.y), 1e-10);
  outcome.worst("statuses", iterations(run), 8);
  if (factor >= 100)
    outcome.worst("p against multipliers, times factor", factor * pressure_difference(joint, exact), 10);
  for (const auto& each : joint.rows)
    if (each.pressure < 0) outcome.missing.push_back("a joint pulls");
  if (joint.closed == joint.points && factor >= 1) outcome.missing.push_back("nothing opens");
}

Case opening_row() {
  Case row = contact_case(
      "penalty factors 10⁻² to 10⁸ on a joint that opens at one end, at both, or between closed ends",
      "statuses that run in circles; a pressure that hangs on the factor",
      "resultant 1e-10 and its place, by statics, whatever the factor; against multipliers on the same mesh "
      "10/factor: a point gives way by 1/factor of a cell, and the pressure is uneven by a few cells' worth; "
      "at most 8 statuses, as a front that moves by cells; no pull",
      {Fault::scaled_traction, Fault::frozen_status, Fault::reversed_gap});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* load : {"\"one end\"", "\"both ends\"", "middle"})
      for (const char* order : {"1", "2"}) {
        const auto exact = run_scene(
            "pressed_joint", {{"load", load}, {"enforce", "lagrange"}, {"order", order}}, Fault::none);
        for (const double factor : {1e-2, 1.0, 1e2, 1e4, 1e6, 1e8}) {
          const auto run = run_scene("pressed_joint",
                                     {{"load", load}, {"factor", digits(factor)}, {"order", order}}, fault);
          add_opening(run, factor, joint_of(exact, "press"), outcome);
        }
      }
    return outcome;
  };
  return row;
}

Case gap_row() {
  Case row = contact_case(
      "gaps of 0 and ±10⁻¹⁵ of a cell, bodies meshed apart", "rounding of coordinates decides what touches",
      "p to 1e-12 and no word of an overlap: 1e-9 of an edge is no gap; one status", {Fault::reversed_gap});
  row.run = [](Fault fault) {
    Outcome outcome;
    core::log().clear();
    for (const char* pairing : {"node_to_segment", "node_insertion", "mortar"})
      for (const double gap : {0.0, 2.5e-16, -2.5e-16}) {
        const auto run = run_scene("pressed_joint",
                                   {{"apart", "true"},
                                    {"gap", digits(gap)},
                                    {"pairing", "\"" + std::string(pairing) + "\""},
                                    {"enforce", "lagrange"}},
                                   fault);
        outcome.worst("p", uneven(joint_of(run, "press")), 1e-12);
        outcome.worst("statuses", iterations(run), 1);
      }
    for (const auto& line : core::log().lines())
      if (line.second.find("overlap") != std::string::npos) outcome.missing.push_back(line.second);
    return outcome;
  };
  return row;
}

/// The block's displacement at its head.
double head(const test::SceneRun& run) {
  double least = 0;
  for (const model::Extreme& each : run.stage("press").extremes)
    if (each.quantity == "uy") least = each.least;
  return least;
}

Case overlap_row() {
  Case row = contact_case(
      "bodies drawn 4·10⁻⁵ of a cell into each other, or as far apart",
      "an overlap that stays, or a gap that is lost",
      "a warning of the overlap, and p to 1e-9; the block moves by the overlap more than without it, to 1e-9 "
      "of it: both to 1e-12 of a body of 2 m that is moved by 10 µm",
      {Fault::reversed_gap, Fault::scaled_traction});
  row.run = [](Fault fault) {
    Outcome outcome;
    const auto at = [&](double gap, Fault planted) {
      return run_scene("pressed_joint", {{"apart", "true"}, {"gap", digits(gap)}, {"enforce", "lagrange"}},
                       planted);
    };
    const double touching = head(at(0, Fault::none));
    core::log().clear();
    for (const double gap : {-1e-5, 1e-5}) {
      const auto run = at(gap, fault);
      outcome.worst("p", uneven(joint_of(run, "press")), 1e-9);
      outcome.worst("moved", std::abs((touching - head(run)) / gap - 1), 1e-9);
    }
    std::string said;
    for (const auto& [level, words] : core::log().lines())
      if (level == core::Level::warning) said += (said.empty() ? "" : " ") + words;
    outcome.must_say(said, {"overlap at the start by 0.01 mm", "the first stage presses it out"});
    return outcome;
  };
  return row;
}

Case deep_overlap_row() {
  Case row =
      contact_case("bodies drawn 4 % of a cell into each other", "stresses of a mistake in the drawing",
                   "stops, and names joint, depth, place and the cure", {Fault::cured});
  row.run = [](Fault fault) {
    Outcome outcome;
    outcome.must_say(
        stopped_by("pressed_joint", {{"apart", "true"}, {"gap", fault == Fault::cured ? "0.0" : "-0.01"}},
                   Fault::none),
        {"joint 'seam' overlap at the start by 10 mm at (", "draw them apart"});
    return outcome;
  };
  return row;
}

Case uneven_row() {
  Case row = contact_case("lips whose edges are 1:100, of moduli 10⁻⁶ to 10⁶ times each other's",
                          "a fine lip drives its points between the coarse one's; conditioning by the moduli",
                          "p to 1e-9 for moduli alike; else 5e-6: the stiff body moves with the soft one, so "
                          "that its forces round by 2e-16 of "
                          "1e6 times what they should be, for cells 25 times as high as wide of which 200 "
                          "make the lip (1e-6); balance the "
                          "same, without the cells' shape",
                          {Fault::scaled_traction, Fault::reversed_gap});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* pairing : {"node_insertion", "mortar"})
      for (const double softer : {1.0, 1e6, 1e-6}) {
        const auto run = run_scene("pressed_joint",
                                   {{"apart", "true"},
                                    {"coarse", "2"},
                                    {"fine", "200"},
                                    {"softer", digits(softer)},
                                    {"pairing", "\"" + std::string(pairing) + "\""},
                                    {"enforce", "lagrange"}},
                                   fault);
        outcome.worst(softer == 1 ? "p" : "p, moduli apart", uneven(joint_of(run, "press")),
                      softer == 1 ? 1e-9 : 5e-6);
        outcome.worst("balance", worst_balance(run.result), softer == 1 ? 1e-9 : 1e-6);
        outcome.worst("statuses", iterations(run), 1);
      }
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> contact_rows() {
  return {closed_row(),  stiffness_row(),    opening_row(), gap_row(),
          overlap_row(), deep_overlap_row(), uneven_row()};
}

}  // namespace ashlar::stability
