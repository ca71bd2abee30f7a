// Bodies that are barely held, or not at all.

#include <algorithm>
#include <cmath>

#include "stability/hard_meshes.hpp"
#include "stability/scene_file.hpp"
#include "testing/meshes.hpp"

namespace ashlar::stability {

namespace {

/// Squares of a block, the first column squeezed to `apart`.
mesh::RawMesh standing_block(double apart) {
  const int n = 4;
  return mapped(testing::structured_square(n), [&](Point p) {
    if (p.x < 0.1) return p;
    return Point{apart + (1 - apart) * (p.x - 1.0 / n) / (1 - 1.0 / n), p.y};
  });
}

test::ParameterValues on_points(const MeshFile& file, double apart, int order) {
  return {{"order", std::to_string(order)}, {"path", "\"" + file.path() + "\""}, {"apart", digits(apart)}};
}

/// What the foot at (apart, 0) carries, against W/2/apart.
double foot_error(const test::SceneRun& run, double apart) {
  for (const auto& [name, reaction] : run.stage("weight").balance.reactions)
    if (name == "other") return std::abs(reaction.y * apart / 12e3 - 1);
  return INFINITY;
}

Case two_points_row() {
  Case row;
  row.group = "Supports";
  row.name = "a block on two points 10⁻¹ to 10⁻³ of its size apart, on a column as thin";
  row.risk = "a rotation that next to nothing resists";
  row.bound =
      "the feet carry W/2/apart to 1e-13/apart³: they resist a rotation by apart² of the block's stiffness, "
      "the "
      "thin column is 1/apart stiffer, and round-off is felt as much more; moments of the feet balance as "
      "well";
  row.plants = {Fault::wrong_sign, Fault::upward_weight};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order)
      for (const double apart : {1e-1, 1e-2, 1e-3}) {
        const MeshFile file(standing_block(apart));
        const auto run = run_scene("on_two_points", on_points(file, apart, order), fault);
        const std::string name = "order " + std::to_string(order);
        const double bound = 1e-13 / std::pow(apart, 3);
        outcome.worst(name + " foot", foot_error(run, apart), bound);
        outcome.worst(name + " balance", worst_balance(run.result), bound);
      }
    return outcome;
  };
  return row;
}

/// Nearer feet than double precision bears: a right answer or none.
Case nearer_points_row() {
  Case row;
  row.group = "Supports";
  row.name = "the same 10⁻⁴ to 10⁻⁶ apart";
  row.risk = "a wrong number that looks like an answer";
  row.bound =
      "the feet to 1e-3, as round-off may change displacements by 1e-4 before they are refused; or stops, "
      "and "
      "names the place and the cure";
  row.plants = {Fault::cured, Fault::upward_weight};
  row.run = [](Fault fault) {
    Outcome outcome;
    int stopped = 0;
    for (int order = 1; order <= 3; ++order)
      for (const double distance : {1e-4, 1e-5, 1e-6}) {
        const double apart = fault == Fault::cured ? 0.1 : distance;
        const MeshFile file(standing_block(apart));
        const std::string said = stopped_by("on_two_points", on_points(file, apart, order), fault);
        if (said.empty()) {
          const auto run = run_scene("on_two_points", on_points(file, apart, order), fault);
          outcome.worst("order " + std::to_string(order) + " foot", foot_error(run, apart), 1e-3);
          continue;
        }
        ++stopped;
        outcome.must_say(said, {"stage 'weight'", " (", "support"});
      }
    if (stopped == 0) outcome.missing.push_back("nothing stopped");
    return outcome;
  };
  return row;
}

Case message_row(std::string name, std::string risk, const std::function<std::string(Fault)>& said,
                 std::vector<std::string> words) {
  return must_stop(make_case("Supports", std::move(name), std::move(risk),
                             "stops, and names the place and the cure", {Fault::cured}),
                   said, std::move(words));
}

std::string too_near(Fault fault) {
  const double apart = fault == Fault::cured ? 0.1 : 1e-7;
  const MeshFile file(standing_block(apart));
  return stopped_by("on_two_points", on_points(file, apart, 1), Fault::none);
}

/// Two squares and a neck of a width between them, 0.1 long: three cells.
mesh::RawMesh necked(double width) {
  mesh::RawMesh raw;
  const double low = 0.5 - width / 2, high = 0.5 + width / 2;
  raw.points = {{0, 0},     {1, 0},   {1, low}, {1, high}, {1, 1},   {0, 1},
                {1.1, low}, {1.1, 0}, {2.1, 0}, {2.1, 1},  {1.1, 1}, {1.1, high}};
  for (const auto& cell : {std::vector<Index>{0, 1, 2, 3, 4, 5}, {2, 6, 11, 3}, {7, 8, 9, 10, 11, 6}}) {
    raw.cell_points.append(cell);
    raw.cell_region.push_back(0);
  }
  return raw;
}

test::ParameterValues neck_values(const MeshFile& file, int order) {
  return {{"order", std::to_string(order)}, {"path", "\"" + file.path() + "\""}};
}

Case neck_row() {
  Case row;
  row.group = "Supports";
  row.name = "two blocks joined by a neck, 10⁻¹ to 10⁻³ of their size";
  row.risk = "the pulled block can nearly turn: the neck resists by the third power of its width";
  row.bound =
      "balance 1e-14/width³, as round-off is felt; the neck stretches by F/(E width), to what the blocks "
      "give "
      "(their corners' log(1/width)/width, a third at most)";
  row.plants = {Fault::lost_unknown};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (int order = 1; order <= 3; ++order)
      for (const double width : {1e-1, 1e-2, 1e-3}) {
        const MeshFile file(necked(width));
        const auto run = run_scene("two_blocks", neck_values(file, order), fault);
        const std::string name = "order " + std::to_string(order);
        outcome.worst(name + " balance", worst_balance(run.result),
                      std::max(1e-14, 1e-14 / std::pow(width, 3)));
        const double stretch = 1000 * 0.1 / (10e9 * width);
        outcome.worst(name + " turned", std::abs(run.value("pull", "far", "uy")) / stretch, 1.0);
      }
    return outcome;
  };
  return row;
}

std::string too_thin(Fault fault) {
  const MeshFile file(necked(fault == Fault::cured ? 0.1 : 1e-6));
  return stopped_by("two_blocks", neck_values(file, 1), Fault::none);
}

Case resting_row() {
  Case row;
  row.group = "Supports";
  row.name = "a block held by smooth contact alone";
  row.risk = "its matrix is singular without the contact; an invisible spring would hold it";
  row.bound =
      "balance 1e-9, and the ground carries the weight, 192 kN, to 1e-9: a penalty of 100 E'/h on top of "
      "1e-12, "
      "ten times over";
  row.plants = {Fault::upward_weight};
  row.run = [](Fault fault) {
    Outcome outcome;
    const auto run = run_scene("loose_block", {{"held", "wall"}}, fault);
    outcome.add("balance", worst_balance(run.result), 1e-9);
    outcome.add("weight", std::abs(run.stage("weight").balance.reaction.y / 192e3 - 1), 1e-9);
    return outcome;
  };
  return row;
}

std::string loose(Fault fault, const char* held) {
  return stopped_by("loose_block", {{"held", fault == Fault::cured ? "wall" : held}}, Fault::none);
}

}  // namespace

std::vector<Case> support_rows() {
  return {
      two_points_row(),
      nearer_points_row(),
      message_row("two points nearer than a millionth of the size", "a rotation that nothing resists",
                  too_near, {"nothing holds", "'block'", "rotate", "hold it"}),
      neck_row(),
      message_row("a neck of a millionth", "the pulled block turns freely in working accuracy", too_thin,
                  {"free to move", "at (", "supports"}),
      resting_row(),
      message_row("a block on a smooth slope with no wall", "contact closes, yet nothing stops the slide",
                  [](Fault fault) { return loose(fault, "slope"); },
                  {"'block'", "slide", "hold the body by a support"}),
      message_row("a block free to slide", "a solution that drifts by round-off",
                  [](Fault fault) { return loose(fault, "nothing"); },
                  {"nothing holds 'block' in stage 'weight'", "slide in x", "\"block.bottom\"", "supports"}),
  };
}

}  // namespace ashlar::stability
