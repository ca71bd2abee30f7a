// What the program says and leaves behind, apart from results.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "program.hpp"

namespace ashlar::test {
namespace {

const char* const sound_scene = R"(
local rock = material.elastic { E = 10*units.GPa, nu = 0.3, unit_weight = 24e3 }
return Scene {
  title = "A block", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { cells = 20 }, element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true } },
  outputs = { pictures = false },
}
)";

TEST(command_line, help_and_version_are_no_mistakes) {
  EXPECT_EQ(call("--help").code, 0);
  EXPECT_EQ(call("").code, 0);
  EXPECT_NE(call("--help").out.find("ashlar run SCENE"), std::string::npos);
  EXPECT_EQ(call("--version").out.substr(0, 7), "ashlar ");
}

TEST(command_line, wrong_words_are_answered) {
  const auto expect = [](const std::string& arguments, const std::string& message) {
    const Ended ended = call(arguments);
    EXPECT_EQ(ended.code, 2) << arguments;
    EXPECT_NE(ended.err.find(message), std::string::npos) << arguments << ": " << ended.err;
  };
  expect("rum scene", "did you mean 'run'?");
  expect("run", "takes one scene");
  expect("run a b", "takes one scene");
  expect("run a --jsn x", "did you mean '--json'?");
  expect("run a --threads many", "--threads takes a whole number");
  expect("run a --set level", "--set takes key=value");
  expect("run a --out", "--out needs a value");
  expect("describe Polygn", "did you mean 'Polygon'?");
  expect("list meshes", "did you mean 'mesh'?");
  expect("check nowhere.lua", "nowhere.lua");
}

TEST(command_line, every_word_that_list_shows_can_be_described) {
  const std::string list = call("list").out;
  for (const char* word : {"Scene", "Polygon", "Stage", "mesh.voronoi", "material.elastic", "joint"}) {
    const Ended ended = call(std::string("describe ") + word);
    EXPECT_EQ(ended.code, 0) << word;
    EXPECT_NE(list.find(word), std::string::npos) << word;
  }
  for (const char* word : {"param", "units", "dam_profiles"}) {
    EXPECT_NE(list.find(word), std::string::npos) << word;
    EXPECT_GT(call(std::string("describe ") + word).out.size(), 150u) << word;
  }
  EXPECT_NE(call("describe units").out.find("1e+06 Pa"), std::string::npos) << call("describe units").out;
  EXPECT_NE(call("describe mesh.voronoi").out.find("say exactly one of size and cells"), std::string::npos);
  EXPECT_NE(call("describe material.elastic").out.find("must be above 0 Pa"), std::string::npos);
}

TEST(command_line, check_warns_as_a_run_does) {
  const ScratchFolder folder;
  write(folder / "scene.lua", R"(
local soft = material.elastic { E = 10, nu = 0.2, unit_weight = 24e3 }
return Scene {
  title = "A block", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = soft } },
  mesh = mesh.voronoi { cells = 20 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true, pressures = { ["rock.bottom"] = 1e3 } } },
}
)");
  const Ended ended = call("check " + quoted(folder / "scene.lua"));
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.err.find("10 Pa is unusual"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("'rock.bottom' is held in x and y"), std::string::npos) << ended.err;
}

TEST(command_line, probes_warn_where_they_read_no_true_value) {
  const ScratchFolder folder;
  write(folder / "scene.lua", R"(
local function rock(E) return material.elastic { E = E, nu = 0.2, unit_weight = 24e3 } end
return Scene {
  title = "Two blocks", plane = "strain",
  geometry = { a = Rectangle { from = {0,0}, to = {1,1}, material = rock(1e9) },
               b = Rectangle { from = {1,0}, to = {2,1}, material = rock(2e9) },
               c = Rectangle { from = {2,0}, to = {3,1}, material = rock(2e9) } },
  mesh = mesh.structured { size = 0.25 },
  supports = { ["a.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true } },
  outputs = { pictures = false, probes = {
    mixed = { "stress", at = {1, 0.5} }, moved = { "displacement", at = {1, 0.5} },
    alike = { "stress", "von_mises", at = {2, 0.5} }, cells = { "strain", at = {2, 0.5} } } },
}
)");
  const Ran ran = run(folder / "scene.lua", folder / "out");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("probes.mixed: the probe lies where the materials of 'a' and 'b' meet"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("probes.cells: 'strain' is known in cells only"), std::string::npos) << ran.err;
  for (const char* name : {"probes.moved", "probes.alike"})
    EXPECT_EQ(ran.err.find(name), std::string::npos) << name << ran.err;
  EXPECT_TRUE(ran.json.at("stages")[0].at("probes").at("alike").contains("von_mises"));
  bool wrote = false;
  for (const auto& row : ran.json.at("timings"))
    wrote = wrote || (row.at("phase") == "write" && row.at("wall") > 0);
  EXPECT_TRUE(wrote);
}

TEST(command_line, plan_names_the_line_that_calls_for_an_effect) {
  const ScratchFolder folder;
  write(folder / "scene.lua", sound_scene);
  const Ended ended = call("plan " + quoted(folder / "scene.lua"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("scene.lua:8: stages[1].gravity"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("not simulated"), std::string::npos);
  EXPECT_NE(ended.out.find("Contact in joints"), std::string::npos);
}

TEST(command_line, a_failed_run_keeps_earlier_results) {
  const ScratchFolder folder;
  write(folder / "scene.lua", sound_scene);
  const std::string run =
      "run " + quoted(folder / "scene.lua") + " --quiet --json " + quoted(folder / "r.json");
  ASSERT_EQ(call(run).code, 0);
  const std::string store = read(folder / "results/results.h5"), json = read(folder / "r.json");
  ASSERT_FALSE(store.empty());
  ASSERT_FALSE(json.empty());
  write(folder / "scene.lua", std::string(sound_scene).replace(1, 5, "lokal"));
  EXPECT_EQ(call(run).code, 2);
  EXPECT_EQ(read(folder / "results/results.h5"), store);
  EXPECT_EQ(read(folder / "r.json"), json);
}

TEST(command_line, a_folder_that_cannot_be_written_is_a_mistake) {
  const ScratchFolder folder;
  write(folder / "scene.lua", sound_scene);
  write(folder / "taken", "a file, not a folder");
  const Ended ended = call("run " + quoted(folder / "scene.lua") + " --out " + quoted(folder / "taken"));
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_NE(ended.err.find("taken"), std::string::npos) << ended.err;
  EXPECT_EQ(read(folder / "taken"), "a file, not a folder");
  if (geteuid() == 0) return;  // root may write everywhere
  fs::create_directory(folder / "closed");
  chmod((folder / "closed").c_str(), 0500);
  EXPECT_EQ(call("run " + quoted(folder / "scene.lua") + " --out " + quoted(folder / "closed")).code, 2);
}

TEST(command_line, a_full_disk_leaves_earlier_results) {
  const ScratchFolder folder;
  write(folder / "scene.lua", sound_scene);
  const std::string run = "run " + quoted(folder / "scene.lua") + " --quiet";
  ASSERT_EQ(call(run).code, 0);
  const std::string store = read(folder / "results/results.h5");
  // A limit on the size of files fails a write halfway, as a full disk does.
  const Ended ended = call(run, source_folder, "ulimit -f 8;");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_NE(ended.err.find("results"), std::string::npos) << ended.err;
  EXPECT_EQ(read(folder / "results/results.h5"), store);
}

TEST(command_line, scripts_reach_files_only_with_trust) {
  const ScratchFolder folder;
  const std::string steal =
      "local f = io.open(" + ("\"" + (folder / "stolen").string()) + "\", \"w\") f:write(\"x\") f:close()";
  write(folder / "scene.lua", steal + sound_scene);
  const std::string check = "check " + quoted(folder / "scene.lua");
  EXPECT_EQ(call(check).code, 2);
  EXPECT_FALSE(fs::exists(folder / "stolen"));
  EXPECT_EQ(call(check + " --trust").code, 0);
  EXPECT_TRUE(fs::exists(folder / "stolen"));
}

}  // namespace
}  // namespace ashlar::test
