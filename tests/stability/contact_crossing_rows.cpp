// Joints that meet, end and cut whole cells, and bodies that joints alone hold. crossed_joints.lua is a
// square under 1 MPa from all sides: the pressure is even on every joint, and nothing slides.

#include <algorithm>
#include <cmath>

#include "stability/scene_file.hpp"

namespace ashlar::stability {

namespace {

Case joint_case(std::string name, std::string risk, std::string bound, std::vector<Fault> plants) {
  return make_case("Joints that meet", std::move(name), std::move(risk), std::move(bound), std::move(plants));
}

test::SceneRun cut(const char* how, const char* pairing, const char* order, Fault fault,
                   const char* edges = "false") {
  return run_scene(
      "crossed_joints",
      {{"cut", how}, {"pairing", "\"" + std::string(pairing) + "\""}, {"order", order}, {"edges", edges}},
      fault);
}

/// Tractions against the even pressure.
void add_tractions(const test::SceneRun& run, double bound, Outcome& outcome) {
  for (const model::JointResult& joint : run.stage("press").joints)
    for (const auto& row : joint.rows) {
      outcome.worst("p", std::abs(row.pressure / 1e6 - 1), bound);
      outcome.worst("shear", std::abs(row.shear / 1e6), bound);
    }
  outcome.worst("statuses", static_cast<double>(run.stage("press").iterations.size()), 2);
}

Case ends_row() {
  Case row = joint_case("joints with both ends inside, one at the border, both; a tip inside a cell",
                        "points at a tip belong to both lips; half an edge there has no contact",
                        "tractions to 1e-10 with multipliers, whatever carries the half edge: the even "
                        "pressure is a polynomial "
                        "that "
                        "the elements hold",
                        {Fault::reversed_gap, Fault::scaled_traction, Fault::wrong_sign});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* how : {"inner", "mouth", "through", "cell"})
      for (const char* pairing : {"node_to_segment", "mortar"})
        for (const char* order : {"1", "2"}) add_tractions(cut(how, pairing, order, fault), 1e-10, outcome);
    return outcome;
  };
  return row;
}

Case crossing_row() {
  Case row = joint_case(
      "X and T of smooth, soft and rough joints, a bend of a rough one; multipliers",
      "more multipliers than movements where lips meet: singular, or tractions that are any number there",
      "tractions to 1e-10, at the meetings too: who repeats what others hold has one multiplier less; sums "
      "to "
      "1e-10",
      {Fault::reversed_gap, Fault::scaled_traction});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* pairing : {"node_to_segment", "node_insertion", "mortar"})
      for (const char* how : {"X", "rough X", "T", "rough T", "bent"})
        add_tractions(cut(how, pairing, "1", fault), 1e-10, outcome);
    for (const char* how : {"rough X", "rough T", "bent"})
      add_tractions(cut(how, "mortar", "2", fault), 1e-10, outcome);
    const double length = std::hypot(2, 0.5);
    const auto tee = cut("rough T", "mortar", "1", fault);
    outcome.worst("sum along the T", std::abs(joint_of(tee, "press").normal_force / (1e6 * length) - 1),
                  1e-10);
    return outcome;
  };
  return row;
}

Case wall_row() {
  Case row = joint_case(
      "a wall of 3×3 cells, every corner of each on joints, rough and smooth, held at corners or edges",
      "bodies without an inner point; four lips in a point; supports that repeat what joints hold",
      "tractions to 1e-10, as above", {Fault::scaled_traction, Fault::reversed_gap});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* edges : {"false", "true"})
      for (const char* order : {"1", "2"})
        add_tractions(cut("wall", "node_to_segment", order, fault, edges), 1e-10, outcome);
    return outcome;
  };
  return row;
}

constexpr double weight = 25e3;  // of the block

std::string squeezed_text(double share, Fault fault) {
  // 2 μ 100 kN bears share of the weight.
  const double mu = share * weight / 2 / 100e3 * (fault == Fault::stronger ? 1.02 : 1);
  return digits(mu);
}

Case squeezed_row() {
  Case row = joint_case(
      "a block between two walls that only friction holds, at 1.001 and 0.999 of what it bears",
      "an invisible spring holds it, or it is refused although it stands",
      "the joints' shear carries the weight to 1e-10; below it stops, and names the body, its motion and the "
      "cure",
      {Fault::stronger, Fault::scaled_traction, Fault::frozen_status});
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* enforce : {"lagrange", "penalty"}) {
      const auto run =
          run_scene("floating_block", {{"mu", squeezed_text(1.001, fault)}, {"enforce", enforce}}, fault);
      double shear = 0;
      for (const auto& joint : run.stage("weight").joints) shear += std::abs(joint.shear_force);
      outcome.worst("weight", std::abs(shear / weight - 1), 1e-10);
      outcome.worst("balance", worst_balance(run.result), 1e-10);
    }
    outcome.must_say(
        stopped_by("floating_block", {{"mu", squeezed_text(0.999, fault)}}, fault),
        {"do not hold a body", "'block' slides along (0.00, -1.00)", "hold the body by a support"});
    return outcome;
  };
  return row;
}

Case fallen_row() {
  Case row = joint_case(
      "a block that nothing holds until it has come down by 1 cm", "a singular matrix before it touches",
      "the ground carries its weight, and the foot both, to 1e-10; it came down by its gap: what is left "
      "open is 1e-15 of the "
      "block with multipliers; "
      "two statuses",
      {Fault::upward_weight, Fault::scaled_traction});
  row.run = [](Fault fault) {
    Outcome outcome;
    const auto run = run_scene("floating_block", {{"held", "fallen"}}, fault);
    const auto& joint = joint_of(run, "weight");
    outcome.add("weight", std::abs(joint.normal_force / weight - 1), 1e-10);
    outcome.add("reaction", std::abs(run.stage("weight").balance.reaction.y / (4 * weight) - 1), 1e-10);
    double opening = 0;
    for (const auto& each : joint.rows) opening = std::max(opening, std::abs(each.opening));
    outcome.add("left open", opening, 1e-15);
    outcome.add("statuses", static_cast<double>(run.stage("weight").iterations.size()), 2);
    return outcome;
  };
  return row;
}

Case free_row(std::string name, const char* held, std::vector<std::string> words) {
  const auto said = [held](Fault fault) {
    return stopped_by("floating_block", {{"held", fault == Fault::cured ? "fallen" : held}}, Fault::none);
  };
  return must_stop(joint_case(std::move(name), "a solution that drifts by round-off",
                              "stops, and names the body, its free motion and the cure", {Fault::cured}),
                   said, std::move(words));
}

}  // namespace

std::vector<Case> crossing_rows() {
  return {
      ends_row(),
      crossing_row(),
      wall_row(),
      squeezed_row(),
      fallen_row(),
      free_row("a block on smooth ground, pushed", "sliding",
               {"do not hold a body", "'block' slides along (1.00, 0.00)", "hold the body by a support"}),
      free_row("a block pulled off the ground", "pulled",
               {"open 5", "'block' slides along (0.00, 1.00)", "so that its joints close"}),
  };
}

}  // namespace ashlar::stability
