// How a run may end, and what each end leaves on the disk and on the terminal.

#include <gtest/gtest.h>

#include <algorithm>

#include "output/store.hpp"
#include "program.hpp"

namespace ashlar::test {
namespace {

/// A block that rests on a smooth incline against a wall; in the second stage, if there is one, nothing holds
/// it back. Its first stage converges.
const char* const block_on_incline = R"(
local slide = param { "slide", default = false, doc = "take the wall away" }
local rock = material.elastic { E = 1e9, nu = 0.25, unit_weight = 24e3 }
local stages = { Stage { "rest", gravity = true } }
if slide then
  stages[2] = Stage { "slide", supports = { ["block.bottom"] = "xy" } }
  stages[3] = Stage { "after" }
end
return Scene {
  title = "A block on an incline", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {2,4}, material = rock } },
  joints = { incline = Joint { path = { {0,2}, {2,1} }, friction = "none", enforce = contact.penalty { factor = 100 } } },
  mesh = mesh.voronoi { cells = 60 }, element = "vem",
  supports = { ["block.bottom"] = "xy", ["block.right"] = "x" },
  stages = stages,
  outputs = { pictures = false, probes = { top = { "displacement", at = {0,4} } } },
}
)";

/// Two stages of weight on about as many cells as said.
std::string weighed_block(int cells) {
  return R"(
local rock = material.elastic { E = 1e9, nu = 0.25, unit_weight = 24e3 }
return Scene {
  title = "A block", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {1,1}, material = rock } },
  mesh = mesh.structured { size = )" +
         std::to_string(cells) + R"(^-0.5 }, element = "vem",
  supports = { ["block.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true }, Stage { "half", gravity = 5 } },
  outputs = { pictures = false },
}
)";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(endings, no_convergence_is_code_3_and_keeps_the_last_good_stage_apart) {
  const ScratchFolder folder;
  write(folder / "scene.lua", block_on_incline);
  const Ran good = run(folder / "scene.lua", folder / "out");
  ASSERT_EQ(good.code, 0) << good.err;
  const auto before = contents(folder / "out");
  const Ran failed = run(folder / "scene.lua", folder / "out", "--set slide=true");
  EXPECT_EQ(failed.code, 3) << failed.err;
  EXPECT_TRUE(has(failed.err,
                  "Stage 'slide' did not converge: the joints do not hold a body that nothing else "
                  "holds (open 0, closed 8): 'block' slides along ("))
      << failed.err;
  for (const char* words :
       {"what to try: hold the body by a support", "the last good stage is 'rest': see ", "/unconverged"})
    EXPECT_TRUE(has(failed.err, words)) << words << failed.err;
  for (const char* words : {"Not converged: stage slide", "slide: did not converge", "after: not run",
                            "Extreme values, stage rest"})
    EXPECT_TRUE(has(failed.out, words)) << words << failed.out;
  EXPECT_FALSE(has(failed.out, "slide      linear")) << failed.out;

  // The older results are the same bytes; what is new is in its own folder.
  auto after = contents(folder / "out");
  std::erase_if(after, [](const auto& file) { return file.first.starts_with("unconverged/"); });
  EXPECT_EQ(before == after, true) << "earlier results were touched";
  const fs::path store = folder / "out" / "unconverged/results.h5";
  ASSERT_TRUE(fs::exists(store));
  const std::string field = "/fields/displacement";
  const auto stages = output::read_names(store, "/stages");
  ASSERT_EQ(stages.size(), 2u);
  const auto earlier = output::read_numbers(folder / "out/results.h5", "/stages/" + stages[0] + field);
  EXPECT_GT(earlier.values.size(), 100u);
  EXPECT_EQ(output::read_numbers(store, "/stages/" + stages[0] + field).values, earlier.values);
  EXPECT_EQ(output::read_names(store, "/stages/" + stages[1]), std::vector<std::string>{"iterations"});
  const auto& slide = failed.json.at("stages")[1];
  EXPECT_FALSE(slide.at("converged").get<bool>());
  EXPECT_TRUE(has(slide.at("advice").get<std::string>(), "hold the body"));
  EXPECT_FALSE(slide.contains("balance"));
  EXPECT_FALSE(has(read(folder / "out/unconverged/results.pvd"), "slide"));

  // A run that converges takes the remains away.
  EXPECT_EQ(run(folder / "scene.lua", folder / "out").code, 0);
  EXPECT_FALSE(fs::exists(folder / "out" / "unconverged"));
}

TEST(endings, too_little_memory_is_code_1_and_leaves_earlier_results) {
  const ScratchFolder folder;
  write(folder / "scene.lua", weighed_block(100));
  ASSERT_EQ(run(folder / "scene.lua", folder / "out").code, 0);
  const auto before = contents(folder.path());
  // Not even the mesh fits.
  write(folder / "scene.lua", weighed_block(4000000));
  const Ran failed = run(folder / "scene.lua", folder / "out", "--threads 1", "ulimit -v 300000;");
  EXPECT_EQ(failed.code, 1) << failed.err;
  EXPECT_TRUE(has(failed.err, "not enough memory")) << failed.err;
  write(folder / "scene.lua", weighed_block(100));
  EXPECT_EQ(before == contents(folder.path()), true) << "earlier results were touched, or something was left";
}

// Whatever does not fit, the run ends by itself and says so.
TEST(endings, no_limit_on_memory_makes_a_run_hang) {
  const ScratchFolder folder;
  write(folder / "scene.lua", weighed_block(20000));
  for (const int megabytes : {100, 150, 200, 250, 300, 350, 400, 500, 700}) {
    const std::string limit = "ulimit -v " + std::to_string(megabytes * 1000) + "; timeout -s KILL 60";
    const Ran ran = run(folder / "scene.lua", folder / "out", "", limit);
    EXPECT_LE(ran.code, 3) << megabytes << " MB";
    const bool told = has(ran.err, "memory") || has(ran.err, "module suitesparse cannot be opened");
    EXPECT_EQ(told, ran.code != 0) << megabytes << " MB, code " << ran.code << ": " << ran.err;
  }
}

TEST(endings, a_body_whose_every_point_is_given_is_solved_without_a_solver) {
  const ScratchFolder folder;
  write(folder / "scene.lua", R"(
local rock = material.elastic { E = 1e9, nu = 0.25, unit_weight = 24e3 }
return Scene {
  title = "All given", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {2,2}, material = rock } },
  mesh = mesh.structured { size = 2 }, element = "vem",
  supports = { ["block.bottom"] = "xy", ["block.top"] = { ux = 0, uy = -0.001 } },
  stages = { Stage { "press", gravity = true } },
  outputs = { pictures = false, probes = { top = { at = {0,2} } } },
}
)");
  const Ran ran = run(folder / "scene.lua", folder / "out");
  ASSERT_EQ(ran.code, 0) << ran.err;
  // Uniaxial strain: σ_yy = −(λ + 2μ)·0.0005 = −6e5 Pa on 2 m, and half of the weight on either edge.
  const auto& stage = ran.json.at("stages")[0];
  EXPECT_NEAR(stage.at("probes").at("top").at("uy").get<double>(), -0.001, 1e-18);
  EXPECT_NEAR(stage.at("balance").at("reaction").at("y").get<double>(), 96e3, 1e-6);
}

TEST(endings, an_endless_script_stops_at_ctrl_c) {
  const ScratchFolder folder;
  write(folder / "scene.lua", "print('ready') while true do end\n");
  const Ended ended = call_and_interrupt("run " + quoted(folder / "scene.lua"), "ready");
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_TRUE(has(ended.err, "scene.lua:1: the script was interrupted")) << ended.err;
}

TEST(endings, a_large_run_stops_at_ctrl_c_and_leaves_earlier_results) {
  const ScratchFolder folder;
  write(folder / "scene.lua", weighed_block(100));
  ASSERT_EQ(run(folder / "scene.lua", folder / "out").code, 0);
  const std::string large = weighed_block(100000);
  write(folder / "scene.lua", large);
  const auto before = contents(folder.path());
  const std::string words = "run " + quoted(folder / "scene.lua") + " --out " + quoted(folder / "out") +
                            " --json " + quoted(folder / "out.json");
  for (const char* moment : {"meshing", "stage 1 of 2"}) {
    const Ended ended = call_and_interrupt(words, moment);
    EXPECT_EQ(ended.code, 130) << moment << ": " << ended.err;
    EXPECT_TRUE(has(ended.err, "Stopped by Ctrl-C. Earlier results are untouched.")) << moment << ended.err;
    EXPECT_EQ(before == contents(folder.path()), true)
        << moment << ": earlier results were touched, or something was left";
  }
}

TEST(endings, json_has_the_terminal_for_itself) {
  const ScratchFolder folder;
  write(folder / "scene.lua", block_on_incline);
  const std::string words = "run " + quoted(folder / "scene.lua") + " --out " + quoted(folder / "out");
  for (const auto& [more, code] :
       {std::pair{"", 0}, std::pair{" --quiet", 0}, std::pair{" --set slide=true", 3}}) {
    const Ended ended = call(words + " --json -" + more);
    EXPECT_EQ(ended.code, code) << ended.err;
    const auto json = nlohmann::json::parse(ended.out, nullptr, false);
    ASSERT_TRUE(json.is_object()) << ended.out.substr(0, 200);
    EXPECT_EQ(json.at("stages")[0].at("name"), "rest");
    EXPECT_EQ(has(ended.err, "Loads and reactions"), std::string(more) != " --quiet");
  }
}

TEST(endings, quiet_says_nothing_but_mistakes) {
  const ScratchFolder folder;
  write(folder / "scene.lua", block_on_incline);
  const std::string words =
      "run " + quoted(folder / "scene.lua") + " --quiet --out " + quoted(folder / "out");
  const Ended good = call(words);
  EXPECT_EQ(good.code, 0);
  EXPECT_EQ(good.out + good.err, "");
  const Ended failed = call(words + " --set slide=true");
  EXPECT_EQ(failed.out, "");
  EXPECT_EQ(std::count(failed.err.begin(), failed.err.end(), '\n'), 3) << failed.err;
  EXPECT_TRUE(failed.err.starts_with("Stage 'slide' did not converge")) << failed.err;
}

TEST(endings, progress_is_plain_lines_where_there_is_no_terminal) {
  const ScratchFolder folder;
  write(folder / "scene.lua", weighed_block(100));
  const Ended ended = call("run " + quoted(folder / "scene.lua") + " --out " + quoted(folder / "out"));
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err.find_first_of("\r\033"), std::string::npos) << ended.err;
  for (const char* line : {"meshing\n", "stage 1 of 2: weight\n", "stage 2 of 2: half\n", "writing\n"})
    EXPECT_TRUE(has(ended.err, line)) << line << ended.err;
}

}  // namespace ashlar::test
