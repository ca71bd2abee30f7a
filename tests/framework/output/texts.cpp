// Tables, JSON and the summary: what people and machines read of a run.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output/json.hpp"
#include "output/summary.hpp"
#include "output/tables.hpp"
#include "output/text_table.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) list.push_back(line);
  return list;
}

TEST(tables, probes_have_one_row_a_stage_and_probe) {
  const auto rows = lines(probes_csv(make_sample(1).result));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0], "stage,probe,x [m],y [m],sxx [Pa],ux [m],uy [m]");
  EXPECT_EQ(rows[3], "reservoir,crest,10,15,,3.3333333333333333e-06,-1e-04");
  EXPECT_EQ(rows[4], "reservoir,\"heel, left\",10,10,125000,0.1,-8e-05");
}

TEST(tables, joints_list_every_stage_and_point) {
  const Sample sample = make_sample(1);
  const auto rows = lines(joint_csv(sample.result, "fault"));
  EXPECT_EQ(rows.size(), 1 + 2 * sample.result.stages[0].joints[0].rows.size());
  EXPECT_EQ(rows[0],
            "stage,s [m],x [m],y [m],opening [m],slip [m],pressure [Pa],shear_stress [Pa],"
            "water_pressure [Pa],utilisation,state,piece,welded");
  EXPECT_EQ(joint_csv(sample.result, "unknown"), "");
}

TEST(tables, sections_have_a_row_a_place_and_side) {
  const Sample sample = make_sample(1);
  const auto rows = lines(section_csv(sample.result, "base"));
  ASSERT_EQ(rows.size(), 1 + 2 * sample.result.stages[0].sections[0].rows.size());
  EXPECT_EQ(rows[0], "stage,s [m],x [m],y [m],side,region,piece,ux [m],sn [Pa],tau [Pa]");
  EXPECT_EQ(rows[2], "self-weight,1,11,10,both,dam,0,,-1100000,0");
  EXPECT_EQ(rows[11], "self-weight,5,15,10,right,rock,2,2e-04,-9e+05,0");
  EXPECT_EQ(section_csv(sample.result, "unknown"), "");
  const auto forces = lines(sections_csv(sample.result));
  ASSERT_EQ(forces.size(), 3u);
  EXPECT_EQ(forces[1], "self-weight,base,10,10,15,10,-6420000,0,330000,-6400000,0,320000,0.0312");
}

TEST(tables, iterations_leave_empty_what_they_do_not_know) {
  const auto rows = lines(iterations_csv(make_sample(1).result));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0], "stage,step,iteration,residual,closed,opened");
  EXPECT_EQ(rows[2], "self-weight,1,2,1e-14,18,");
}

TEST(json, holds_the_promised_paths) {
  const Sample sample = make_sample(1);
  const auto json = nlohmann::json::parse(results_json(sample.record()));
  const auto& stage = json["stages"][1];
  EXPECT_EQ(stage["name"], "reservoir");
  EXPECT_EQ(stage["probes"]["crest"]["ux"].get<double>(), 1.0 / 3e5);
  EXPECT_EQ(stage["probes"]["crest"]["y"], 15);
  EXPECT_EQ(stage["joints"]["fault"]["max_slip"].get<double>(), sample.result.stages[1].joints[0].max_slip);
  EXPECT_EQ(stage["joints"]["fault"]["profile"].size(), sample.result.stages[1].joints[0].rows.size());
  EXPECT_EQ(stage["balance"]["loads"]["water"]["x"], 1.226e5);
  EXPECT_EQ(stage["sections"]["base"]["N"], -6.42e6);
  EXPECT_EQ(stage["sections"]["base"]["integral"]["M"], 3.2e5);
  EXPECT_EQ(stage["sections"]["base"]["end"]["sn"], -1.9e6);
  EXPECT_EQ(stage["sections"]["base"]["profile"].size(), sample.result.stages[1].sections[0].rows.size());
  EXPECT_TRUE(stage["sections"]["base"]["profile"][1]["ux"].is_null());
  EXPECT_EQ(stage["iterations"][0]["closed"], 20);
  EXPECT_EQ(json["mesh"]["cells"], sample.report.cells);
  EXPECT_EQ(json["effects"]["simulated"]["self-weight"]["gravity"]["called_by"],
            "scene.lua:20: stages[1].gravity");
  EXPECT_EQ(json["timings"][0]["phase"], "mesh");
  EXPECT_GT(json["memory"]["peak_bytes"].get<double>(), 0);
}

TEST(json, stays_valid_whatever_comes) {
  Sample sample = make_sample(1);
  sample.scene.title = "a \"quote\" \\ \n and bytes \xff\xfe";
  sample.result.stages[0].balance.relative_error = std::numeric_limits<double>::quiet_NaN();
  sample.result.stages[0].backward_error = std::numeric_limits<double>::infinity();
  const auto json = nlohmann::json::parse(results_json(sample.record()));
  EXPECT_TRUE(json["stages"][0]["balance"]["relative_error"].is_null());
  EXPECT_TRUE(json["stages"][0]["solve"]["backward_error"].is_null());
}

TEST(summary, fits_the_terminal_and_names_what_matters) {
  const Sample sample = make_sample(1);
  const std::string text = summary(sample.record(), {"/tmp/out/results.h5", "/tmp/out/vtu/01_a.vtu"});
  for (const std::string& line : lines(text)) EXPECT_LE(columns(line), 100u) << line;
  for (const char* word : {"water: it matters when", "reaction rock.bottom", "122.6 kN", "fault", "(10, 15)",
                           "-6.42 MN", "3.1 %", "Files in /tmp/out", "vtu/01_a.vtu"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
}

TEST(summary, round_off_reads_as_zero) {
  Sample sample = make_sample(1);
  sample.result.stages.resize(1);
  sample.result.stages[0].balance.load.x = 1e-9;
  const auto rows = lines(balance_text(sample.result, model::Plane::strain));
  EXPECT_NE(rows.back().find("sum                   0         0 "), std::string::npos) << rows.back();
}

TEST(summary, says_what_contact_points_do_not_stand_for) {
  Sample sample = make_sample(1);
  model::JointResult& joint = sample.result.stages.back().joints.at(0);
  const auto says = [&](double contact, bool tips, const std::string& words) {
    joint.length = 4, joint.contact_length = contact;
    joint.tips.clear();
    if (tips) joint.tips.push_back({});
    return summary(sample.record(), {}).find(words) != std::string::npos;
  };
  EXPECT_TRUE(says(2, false, "stand for 2 m of 4 m; the rest faces no part"));
  EXPECT_TRUE(says(3, true, "stand for 3 m of 4 m; what the rest carries"));
  EXPECT_FALSE(says(3.9999, true, "stand for"));
}

TEST(summary, says_why_a_stage_failed) {
  Sample sample = make_sample(1);
  sample.result.stages[1].converged = false;
  sample.result.stages[1].reason = "the contact state repeats";
  sample.result.stages[1].advice = "smaller cells";
  sample.plan.stages.push_back({"reservoir", {}});
  sample.plan.stages.push_back({"flood", {}});
  const std::string text = summary(sample.record(), {});
  for (const char* words :
       {"Not converged: stage reservoir\n  the contact state repeats\n  What to try: smaller cells\n",
        "the stages before it, the last one self-weight.", "self-weight: gravity\n",
        "reservoir: did not converge\n", "flood: not run\n", "Extreme values, stage self-weight",
        "step  iteration  residual  closed  opened\n", "3.0e-02      20       3\n"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\nin\n" << text;
  // Nothing of the failed stage looks like a result.
  EXPECT_EQ(balance_text(sample.result, model::Plane::strain).find("reservoir"), std::string::npos);
  EXPECT_EQ(iterations_text(sample.result).find("reservoir"), std::string::npos);
}

TEST(summary, says_so_if_no_stage_was_completed) {
  Sample sample = make_sample(1);
  sample.result.stages.resize(1);
  sample.result.stages[0].converged = false;
  sample.result.stages[0].iterations.assign(40, {1, 1, 0.5, {}});
  const std::string text = summary(sample.record(), {});
  EXPECT_NE(text.find("No stage was completed."), std::string::npos) << text;
  EXPECT_NE(text.find("the last 12 of 40 iterations"), std::string::npos) << text;
  EXPECT_EQ(text.find("Loads and reactions"), std::string::npos) << text;
}

TEST(text_table, wraps_and_counts_characters) {
  EXPECT_EQ(columns("√area µm"), 8u);
  EXPECT_EQ(wrapped("one two three", 8, 2), "one two\n  three\n");
  EXPECT_EQ(short_quantity(123456, "Pa"), "123.5 kPa");
  EXPECT_EQ(short_quantity(0.5, "apples"), "0.5 apples");
}

}  // namespace
}  // namespace ashlar::output
