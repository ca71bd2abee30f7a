#include "output/write_all.hpp"

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "output/files.hpp"
#include "output/store.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

namespace fs = std::filesystem;

TEST(write_all, writes_everything_and_twice_the_same) {
  const Sample sample = make_sample(1);
  const fs::path out = fresh_folder("all");
  const auto files = write_results(sample.record(), out);
  for (const char* name : {"results.h5", "results.pvd", "vtu/01_self-weight.vtu",
                           "vtu/02_reservoir_joints.vtu", "probes.csv", "joint_fault.csv", "section_base.csv",
                           "sections.csv", "section_base.png", "iterations.csv", "mesh.png", "s1.png"})
    EXPECT_GT(slurp(out / name).size(), 100u) << name;
  std::vector<std::string> first;
  for (const fs::path& file : files) first.push_back(slurp(file));
  write_results(sample.record(), out);
  // results.h5 comes first and holds date and memory.
  for (std::size_t i = 1; i < files.size(); ++i) EXPECT_EQ(slurp(files[i]), first[i]) << files[i];
}

TEST(write_all, a_run_that_did_not_converge_spares_earlier_results) {
  Sample sample = make_sample(1);
  const fs::path out = fresh_folder("unconverged");
  write_results(sample.record(), out);
  const std::string earlier = slurp(out / "probes.csv");
  sample.result.converged = false;
  sample.result.stages.back().converged = false;  // with fields, which no march would give it
  sample.result.stages.back().joints.clear();
  sample.result.stages.back().probes.clear();
  const auto files = write_results(sample.record(), out);
  EXPECT_TRUE(fs::exists(out / "unconverged/vtu/01_self-weight.vtu"));
  EXPECT_FALSE(fs::exists(out / "unconverged/vtu/02_reservoir.vtu"));
  EXPECT_EQ(slurp(out / "unconverged/results.pvd").find("reservoir"), std::string::npos);
  EXPECT_FALSE(read_names(out / "unconverged/results.h5", "/stages/01 self-weight/fields").empty());
  EXPECT_EQ(read_names(out / "unconverged/results.h5", "/stages/02 reservoir"),
            std::vector<std::string>{"iterations"});
  EXPECT_EQ(slurp(out / "probes.csv"), earlier);
  EXPECT_EQ(files[0], out / "unconverged" / "results.h5");
  EXPECT_NE(slurp(out / "unconverged" / "probes.csv"), earlier);
  // The next run that converges takes the failed one's files away.
  sample.result.converged = sample.result.stages.back().converged = true;
  write_results(sample.record(), out);
  EXPECT_FALSE(fs::exists(out / "unconverged"));
}

TEST(write_all, warns_of_a_picture_that_cannot_be_drawn) {
  Sample sample = make_sample(1);
  core::Settings::Entry entry;
  entry.key = "pictures";
  entry.said = true;
  entry.value =
      core::make_value(core::Table{"", {core::make_value(std::string("stres"))}, {}}, {"a.lua", 7, "p"});
  sample.scene.outputs.entries = {entry};
  core::log().clear();
  write_results(sample.record(), fresh_folder("pictures"));
  ASSERT_EQ(core::log().lines().size(), 1u);
  EXPECT_EQ(core::log().lines()[0].second.rfind(
                "a.lua:7: p: there is nothing to draw for 'stres'; did you mean 'stress'?", 0),
            0u)
      << core::log().lines()[0].second;
}

TEST(write_all, formats_choose) {
  Sample sample = make_sample(1);
  core::Settings::Entry entry;
  entry.key = "formats";
  entry.value = core::make_value(core::Table{"", {core::make_value(std::string("csv"))}, {}});
  sample.scene.outputs.entries = {entry};
  const auto files = write_results(sample.record(), fresh_folder("formats"));
  for (const fs::path& file : files) EXPECT_EQ(file.extension(), ".csv");
  EXPECT_EQ(files.size(), 5u);
}

}  // namespace
}  // namespace ashlar::output
