// `ashlar study` as a whole: what it runs, keeps, runs again, and writes.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ashlar::test {
namespace {

using nlohmann::json;

/// A column under its own weight: settlement of the top γ H² / (2 E) exactly, at any number of cells.
const char* const column = R"(
local cells = param { "cells", default = 16 }
local slide = param { "slide", default = false }
local rock = material.elastic { E = 1e9, nu = 0, unit_weight = 24e3 }
return Scene {
  title = "A column", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {2,4}, material = rock } },
  joints = slide and { cut = Joint { path = { {0,3}, {2,2.5} }, friction = "none", enforce = contact.penalty { factor = 100 } } } or nil,
  mesh = mesh.structured { size = (8/cells)^0.5 }, element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true } },
  outputs = { pictures = false, probes = { top = { "displacement", at = {0,4} }, middle = { "displacement", at = {0,2} } } },
}
)";

std::string study_of(const std::string& vary, const std::string& more = "") {
  return "return Study { title = \"A column\", scene = \"scene.lua\", vary = { " + vary + R"( },
  measure = {
    top  = { title = "settlement", stage = "weight", probe = "top", quantity = "uy", reference = -24e3*16/2e9 },
    half = { probe = "top", minus = "middle", quantity = "u", reference = function(case) return (case.cells > 0 and 24e3*4/2e9)*units.m end },
    load = { at = "stages.weight.balance.load.y", reference = "finest" },
  }, )" + more +
         " }";
}

struct Studied : Ended {
  json results;
};

Studied study(const fs::path& folder, const std::string& words = {}) {
  Studied done{call("study " + quoted(folder) + " --out " + quoted(folder / "out") + " " + words), {}};
  if (done.code == 0) done.results = json::parse(read(folder / "out/study.json"));
  return done;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Times a run began: the program tells each one.
std::size_t begun(const Ended& ended) {
  return count(ended.err, " of ");
}

}  // namespace

TEST(study, measures_all_cases_and_writes_table_json_and_page) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32, 128, 512 }", "repeats = 2"));
  const Studied done = study(folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(begun(done), 6u) << done.err;
  ASSERT_EQ(done.results.at("cases").size(), 3u);
  for (const json& one : done.results.at("cases")) {
    EXPECT_EQ(one.at("runs").size(), 2u);
    EXPECT_NEAR(one.at("values").at("load").get<double>(), -8 * 24e3, 1e-6);
    for (const json& run : one.at("runs")) {
      EXPECT_GT(run.at("wall").get<double>(), 0);
      EXPECT_GT(run.at("memory").get<double>(), 1e6);
      double parts = 0;
      for (const auto& [part, cost] : run.at("parts").items()) parts += cost.at("wall").get<double>();
      EXPECT_NEAR(parts, run.at("wall").get<double>(), 1e-9);
    }
  }
  EXPECT_EQ(done.results.at("cases")[2].at("cells"), 512);
  EXPECT_EQ(count(read(folder / "out/study.csv"), "\n"), 4u);
  for (const json& finding : done.results.at("findings"))
    EXPECT_FALSE(finding.at("reference").at("value").is_null()) << finding;
}

TEST(study, effects_cost_what_a_run_without_them_saves) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32, 128, 512 }", "without = { detail = { cells = 128 } }"));
  const Studied done = study(folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  ASSERT_EQ(done.results.at("cases").size(), 4u);
  const json& last = done.results.at("cases")[3];
  EXPECT_EQ(last.at("without"), "detail");
  EXPECT_EQ(last.at("cells"), 128);
  for (const json& finding : done.results.at("findings")) EXPECT_EQ(finding.at("readings").size(), 3u);
  EXPECT_NE(read(folder / "out/study.html").find("once more without each"), std::string::npos);
}

TEST(study, measures_what_runs_cost) {
  const ScratchFolder scratch;
  std::string scene = column;  // its joint ends inside: no part comes off
  const std::string through = "{0,3}, {2,2.5}";
  scene.replace(scene.find(through), through.size(), "{0.5,2}, {1.5,2}");
  const std::string stage = "Stage { \"weight\", gravity = true }";
  scene.replace(scene.find(stage), stage.size(), stage + ", Stage { \"more\", gravity = 20 }");
  write(scratch / "scene.lua", scene);
  write(scratch / "study.lua", R"(return Study { title = "Costs", scene = "scene.lua", repeats = 2,
    cases = { { slide = true }, { slide = true, cells = 64 } }, refine = false,
    measure = {
      all = { title = "iterations", cost = "iterations" },
      bulk = { title = "time of elasticity", cost = "wall", effect = "elasticity" },
      none = { cost = "cpu", effect = "water" },
      one = { cost = "iterations", stage = "weight", reference = 1 },
      run = { cost = "cpu" },
    } })");
  const Studied done = study(scratch.path());
  ASSERT_EQ(done.code, 0) << done.err;
  for (std::size_t c = 0; c < 2; ++c) {
    const json& one = done.results.at("cases").at(c);
    const json& values = one.at("values");
    const std::string folder = "out/cases/" + one.at("case").get<std::string>();
    double iterations = 0, more = 0, bulk = 1e300, cpu = 1e300;
    for (const char* number : {"1", "2"}) {
      const json run = json::parse(read(scratch / (folder + "/run_" + number + ".json")));
      iterations = static_cast<double>(run.at("stages").at(0).at("iterations").size());
      more = static_cast<double>(run.at("stages").at(1).at("iterations").size());
      double sum = 0;
      for (const json& row : run.at("timings"))
        if (row.at("effect") == "elasticity") sum += row.at("wall").get<double>();
      bulk = std::min(bulk, sum);
    }
    for (const json& run : one.at("runs")) cpu = std::min(cpu, run.at("cpu").get<double>());
    EXPECT_GT(std::min(iterations, more), 0);
    EXPECT_EQ(values.at("all"), iterations + more);
    EXPECT_EQ(values.at("one"), iterations);
    EXPECT_EQ(values.at("bulk"), bulk);
    EXPECT_EQ(values.at("run"), cpu);
    EXPECT_TRUE(values.at("none").is_null());
  }
  EXPECT_NE(done.out.find("its results lack the measure 'none'"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("Iterations: "), std::string::npos) << done.out;
  const std::string table = read(scratch / "out/study.md");
  EXPECT_TRUE(table.starts_with("| cells | iterations | time of elasticity |")) << table;
  EXPECT_EQ(count(table, "\n"), 4u);
}

TEST(study, page_needs_nothing_else) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32, 128, 512 }"));
  ASSERT_EQ(study(folder.path()).code, 0);
  const std::string page = read(folder / "out/study.html");
  for (const char* outside : {"<script", "<link", "<img", "src=", "http:", "https:", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_GE(count(page, "<svg"), 5u);
  EXPECT_EQ(count(page, "<svg"), count(page, "</svg>"));
  EXPECT_EQ(count(page, "<table"), count(page, "</table>"));
  EXPECT_EQ(page.find("nan"), std::string::npos);
  EXPECT_NE(page.find("costs"), std::string::npos);
}

TEST(study, runs_again_only_what_has_changed) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32, 128 }"));
  EXPECT_EQ(begun(study(folder.path())), 2u);
  const auto before = contents(folder / "out/cases");
  EXPECT_EQ(begun(study(folder.path())), 0u);
  EXPECT_EQ(contents(folder / "out/cases") == before, true) << "a finished run was touched";
  write(folder / "study.lua", study_of("cells = { 32, 128, 200 }"));
  EXPECT_EQ(begun(study(folder.path())), 1u) << "only the new case";
  write(folder / "study.lua", study_of("cells = { 32, 128, 200 }", "repeats = 2"));
  EXPECT_EQ(begun(study(folder.path())), 3u) << "one more of each";
  fs::remove(folder / "out/cases/cells-32/run_1.json");
  EXPECT_EQ(begun(study(folder.path())), 2u) << "results that are lost are made again";
  EXPECT_EQ(begun(study(folder.path(), "--resume none")), 6u);
  write(folder / "scene.lua", std::string(column) + "-- another scene\n");
  EXPECT_EQ(begun(study(folder.path())), 6u) << "all of another scene";
  write(folder / "out/study.state", "{ noise");
  EXPECT_EQ(begun(study(folder.path())), 6u) << "a state that cannot be read counts as none";
}

TEST(study, stops_at_ctrl_c_and_goes_on_from_there) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32, 40000, 40001, 40002 }"));
  const std::string words = "study " + quoted(folder.path()) + " --jobs 1 --out " + quoted(folder / "out");
  const Ended stopped = call_and_interrupt(words, "2 of 4");
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("the same command goes on from there"), std::string::npos) << stopped.err;
  EXPECT_FALSE(fs::exists(folder / "out/study.html"));
  const json state = json::parse(read(folder / "out/study.state"));
  EXPECT_EQ(state.at("cases").at("cells-32").at("runs").size(), 1u);
  EXPECT_TRUE(state.at("cases").at("cells-40002").at("runs").empty());
  const std::string first = read(folder / "out/cases/cells-32/run_1.json");
  const Studied done = study(folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_LE(begun(done), 3u) << done.err;
  EXPECT_EQ(read(folder / "out/cases/cells-32/run_1.json"), first) << "the finished case was run again";
  for (const json& one : done.results.at("cases")) EXPECT_TRUE(one.at("ok").get<bool>());
}

TEST(study, keeps_failures_with_their_reason) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32, 128 }, slide = { false, true }", "repeats = 2"));
  const Studied done = study(folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(begun(done), 2u * 2 + 2) << "a failed case is not repeated";
  int failed = 0;
  for (const json& one : done.results.at("cases")) {
    if (one.at("ok").get<bool>()) continue;
    ++failed;
    const std::string reason = one.at("reason");
    EXPECT_TRUE(reason.starts_with("exit code 3: Stage 'weight' did not converge: the joints do not hold"))
        << reason;
    EXPECT_EQ(one.at("parameters").at("slide"), true);
  }
  EXPECT_EQ(failed, 2);
  EXPECT_NE(read(folder / "out/study.html").find("2 cases failed"), std::string::npos);
  EXPECT_NE(done.out.find("failed: cells = 32, slide = true: exit code 3"), std::string::npos) << done.out;
  EXPECT_EQ(begun(study(folder.path())), 0u) << "a failure is a result";
  EXPECT_EQ(begun(study(folder.path(), "--resume good")), 2u);
}

TEST(study, where_every_run_fails_says_so) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua", study_of("cells = { 32 }, slide = { true }"));
  const Studied done = study(folder.path());
  EXPECT_EQ(done.code, 3);
  EXPECT_NE(done.err.find("Every run failed: exit code 3"), std::string::npos) << done.err;
  EXPECT_TRUE(fs::exists(folder / "out/study.html"));
}

TEST(study, tells_what_results_lack_and_takes_its_own_parameters) {
  const ScratchFolder folder;
  write(folder / "scene.lua", column);
  write(folder / "study.lua",
        "local most = param { \"most\", default = 5000 }\nreturn Study { title = \"x\", vary = { cells = { "
        "8, most } }, "
        "measure = { a = { at = \"stages.weight.balance.lod.y\", reference = 1 } } }");
  const Studied done = study(folder.path(), "--set most=32");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("cells = 32: its results lack the measure 'a'"), std::string::npos) << done.out;
  EXPECT_EQ(call("study " + quoted(folder.path()) + " --set mst=32").code, 2);
}

TEST(study, words_are_checked) {
  const auto expect = [](const std::string& arguments, const std::string& message) {
    const Ended ended = call(arguments);
    EXPECT_EQ(ended.code, 2) << arguments;
    EXPECT_NE(ended.err.find(message), std::string::npos) << arguments << ": " << ended.err;
  };
  expect("study", "takes one study");
  expect("study a --resume som", "--resume takes all, good or none");
  expect("study a --jobs 0", "--jobs takes a whole number");
  expect("study a --json x", "it always writes study.json");
  expect("run a --jobs 2", "are for `ashlar study`");
  expect("run examples/cantilever/study.lua",
         "it is a study: `ashlar study examples/cantilever/study.lua` runs it");
  EXPECT_NE(call("describe Study").out.find("vary"), std::string::npos);
  EXPECT_NE(call("describe measure").out.find("richardson"), std::string::npos);
  EXPECT_NE(call("list").out.find("Study { … }"), std::string::npos);
}

TEST(study, of_examples_are_sound) {
  const ScratchFolder folder;
  const Ended ended = call("study examples/cantilever --out " + quoted(folder / "out") + " --quiet");
  EXPECT_EQ(ended.code, 0) << ended.err;
  const json results = json::parse(read(folder / "out/study.json"));
  // Order 2 holds bending on any cells; order 1 of rectangles only.
  std::size_t exact = 0;
  for (const json& reading : results.at("findings")[0].at("readings")) {
    const auto name = reading.at("case").get<std::string>();
    const double error = reading.at("relative_error").get<double>();
    exact += error < 1e-9 ? 1 : 0;
    if (name.find("element-vem_order-2") != std::string::npos) {
      EXPECT_LT(error, 1e-9) << name;
    }
    if (name.find("stabilisation-shear") != std::string::npos) {
      EXPECT_GT(error, 0.4) << name;
    }
  }
  EXPECT_EQ(exact, 8u + 3u);
}

}  // namespace ashlar::test
