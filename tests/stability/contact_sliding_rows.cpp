// Finite sliding: a body pushed over many cells. sliding_block.lua has a block of 1 m by 0.5 m under 1 MPa
// that its top pushes along a rough base to 1.7 m, on to 2 m, and back to 1.4 m.

#include <algorithm>
#include <cmath>

#include "stability/scene_file.hpp"

namespace ashlar::stability {

namespace {

constexpr double weight = 1e6, mu = 0.5;  // N on the block; as the scene says

double moved_moment(const model::StageResult& stage) {
  double moment = 0;
  for (const auto& [name, load] : stage.balance.loads)
    if (name == "contact (moved)") moment = load.moment;
  return moment;
}

/// What closed forms say of a block at `far`, pushed with this sense: N, T = μ N against the push, which acts
/// 0.5 m above the base and so shifts N by 0.5 μ, and where the load stands now.
void add_closed_form(const test::SceneRun& run, const std::string& stage, double far, double sense,
                     Outcome& outcome) {
  const model::JointResult& bed = joint_of(run, stage);
  outcome.worst("N", std::abs(bed.resultant.y / weight - 1), 1e-9);
  outcome.worst("T", std::abs(bed.shear_force / (sense * mu * bed.normal_force) - 1), 1e-12);
  outcome.worst("T in N", std::abs(bed.shear_force / (sense * mu * weight) - 1), 1e-3);
  outcome.worst("N's place on the block", std::abs(bed.action_s - 0.5 - sense * 0.5 * mu), 1e-3);
  outcome.worst("N's place on the base", std::abs(moved_moment(run.stage(stage)) / weight + far), 1e-3);
  outcome.worst("slip", std::abs(bed.max_slip - far), 1e-3);
}

test::SceneRun slide(const char* pairing, const char* order, std::pair<const char*, const char*> steps,
                     Fault fault) {
  return run_scene("sliding_block",
                   {{"pairing", pairing},
                    {"order", order},
                    {"steps", steps.first},
                    {"last", steps.second},
                    {"mu", digits(mu * (fault == Fault::stronger ? 1.02 : 1))}},
                   fault);
}

Case far_row() {
  Case row;
  row.group = "Finite sliding";
  row.name = "a block pushed over ten cells to 1.7 m, on to 2 m, and back to 1.4 m, in 5 and in 24 steps";
  row.risk = "N stays where the block stood; T forgets to turn; the answer hangs on the last step's size";
  row.bound =
      "N and T = μ N against the push to 1e-9 and 1e-12; places, slip and T to 1e-3: the faces are bent by "
      "1e-4, and T acts along them. The last 0.3 m in 1 step or in 7: T and the place to 2e-4, as the lips' "
      "slope is that of the last pairing; back in the same steps nothing is left of it: u to 1e-9";
  row.plants = {Fault::stronger, Fault::scaled_traction, Fault::frozen_status, Fault::lost_history};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const char* pairing : {"mortar", "node_to_segment"})
      for (const char* order : {"1", "2"}) {
        const auto few = slide(pairing, order, {"4", "1"}, fault);
        const auto fine = slide(pairing, order, {"4", "7"}, Fault::none);
        const auto many = slide(pairing, order, {"17", "7"}, fault);
        for (const auto* run : {&few, &many}) {
          add_closed_form(*run, "push", 1.7, 1, outcome);
          add_closed_form(*run, "on", 2, 1, outcome);
          add_closed_form(*run, "back", 1.4, -1, outcome);
          outcome.worst("balance", worst_balance(run->result), 1e-8);
        }
        const model::JointResult &a = joint_of(few, "on"), &b = joint_of(fine, "on");
        outcome.worst("last step: T", std::abs(a.shear_force - b.shear_force) / (mu * weight), 2e-4);
        outcome.worst("last step: place", std::abs(a.action_s - b.action_s), 2e-4);
        outcome.worst("back: u",
                      relative_difference(values(few.stage("back"), "displacement"),
                                          values(fine.stage("back"), "displacement")),
                      1e-9);
      }
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> sliding_rows() {
  return {far_row()};
}

}  // namespace ashlar::stability
