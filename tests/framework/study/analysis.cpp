// Made-up outcomes: what the analysis, the sentences and the page make of them.

#include "study/analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/cases.hpp"
#include "study/page/page.hpp"
#include "study/tables.hpp"

namespace ashlar::study {
namespace {

core::Value text(const char* word) {
  return core::make_value(std::string(word));
}

/// Two kinds of mesh by four sizes; errors of 0.32 h and 0.08 h², cost 1/h² and 4/h² seconds.
class MadeUp : public ::testing::Test {
 protected:
  MadeUp() {
    study.title = "Made up";
    study.refine = "cells";
    study.cases = combinations(
        {{"mesh", {text("coarse"), text("fine")}},
         {"cells",
          {core::make_value(1.0), core::make_value(4.0), core::make_value(16.0), core::make_value(64.0)}}});
    study.measures.resize(1);
    study.measures[0].name = "tip";
    study.measures[0].title = "the tip";
    study.measures[0].quantity = "uy";
    study.measures[0].probe = "tip";
    study.measures[0].reference = text("richardson");
    for (const Case& one : study.cases) {
      const double h = 1 / std::sqrt(find(one, "cells")->quantity()->value);
      const bool fine = *find(one, "mesh")->text() == "fine";
      outcomes.push_back(outcome(h, 2 * (1 + (fine ? 0.08 * h * h : 0.32 * h)), (fine ? 4 : 1) / (h * h)));
    }
  }

  static Outcome outcome(double h, double value, double wall) {
    Outcome made;
    made.name = "case-" + std::to_string(wall);
    made.ok = true;
    made.h = h;
    made.cells = 1 / (h * h);
    made.unknowns = 2 / (h * h);
    made.values = {value};
    study::Run run;
    run.record = {0, "", wall, wall, 1 << 20};
    run.wall = {wall / 2, 0, wall / 4, 0, 0, wall / 4};
    run.effects = {{"weight", wall / 8}};
    made.runs = {run};
    return made;
  }

  Finding only() { return analyse(study, outcomes, exact).findings.at(0); }

  Study study;
  std::vector<Outcome> outcomes;
  Exact exact = [](const Measure& measure, const Case&) { return measure.reference.quantity()->value; };
};

TEST_F(MadeUp, reference_is_the_surest_limit) {
  const Finding finding = only();
  EXPECT_NEAR(finding.reference.value, 2, 1e-9);
  EXPECT_NEAR(finding.reference.uncertainty, 1.25 * 0.16 / 64, 1e-7);
  EXPECT_NE(finding.reference.how.find("mesh = fine, order 2.00"), std::string::npos)
      << finding.reference.how;
  ASSERT_EQ(finding.limits.size(), 2u);
  EXPECT_NEAR(finding.limits[0].observed, 1, 1e-6);
  EXPECT_NEAR(finding.limits[1].observed, 2, 1e-6);
}

TEST_F(MadeUp, errors_front_and_sentence_are_those_of_the_formulas) {
  study.measures[0].reference = core::make_value(2.0);
  const Finding finding = only();
  EXPECT_NEAR(finding.readings[0].relative, 0.32, 1e-12);
  EXPECT_NEAR(finding.readings[7].relative, 0.08 / 64, 1e-12);
  std::vector<std::size_t> front;
  for (const std::size_t r : finding.front) front.push_back(finding.readings[r].one);
  // wall 1: 32 %; 4: 8 % (16 % is beaten); 16: 2 %; 64: 0.5 %; 256: 0.125 %
  EXPECT_EQ(front, (std::vector<std::size_t>{0, 4, 5, 6, 7}));
  // Error falls with 1/wall: 1 % costs 16 s · 2, 0.1 % costs 256 s · 1.25.
  ASSERT_EQ(finding.sentences.size(), 1u);
  EXPECT_EQ(
      finding.sentences[0],
      "1 % of the tip costs 32 s with mesh = fine (interpolated between cells = 4 and cells = 16); the next "
      "factor of ten costs 5 min (extrapolated beyond cells = 64).");
}

TEST_F(MadeUp, a_lucky_run_counts_with_the_error_of_a_finer_one) {
  study.measures[0].reference = core::make_value(2.0);
  outcomes[1].values[0] = 2.0;
  const Finding finding = only();
  EXPECT_EQ(finding.readings[1].relative, 0);
  EXPECT_NEAR(finding.readings[1].sure, 0.08, 1e-12);
}

TEST_F(MadeUp, finest_run_has_no_error_of_its_own) {
  study.measures[0].reference = text("finest");
  outcomes[7].unknowns = 1e6;
  const Finding finding = only();
  EXPECT_EQ(finding.reference.itself, 7u);
  EXPECT_TRUE(std::isnan(finding.readings[7].relative));
  EXPECT_EQ(finding.reference.value, *outcomes[7].values[0]);
  EXPECT_GT(finding.reference.uncertainty, std::abs(finding.reference.value - 2));
}

TEST_F(MadeUp, limits_that_disagree_widen_the_reference) {
  for (std::size_t c = 4; c < 8; ++c) *outcomes[c].values[0] += 0.2;
  const Finding finding = only();
  EXPECT_NEAR(finding.reference.uncertainty, 0.2, 1e-6);
  EXPECT_NE(finding.reference.how.find("outside both brackets"), std::string::npos);
  EXPECT_EQ(finding.sentences.size(), 2u) << "the reader is told to take it with care";
}

TEST_F(MadeUp, a_finest_run_that_stands_for_the_limit_is_not_called_exact) {
  for (std::size_t c = 0; c < 8; ++c)
    outcomes[c].values[0] =
        2 + (c % 2 == 0 ? 0.1 : -0.1) / static_cast<double>(1 + c % 4) + (c > 3 ? 0.01 : 0);
  const Finding finding = only();
  ASSERT_TRUE(finding.reference.itself.has_value());
  EXPECT_TRUE(std::isnan(finding.readings[*finding.reference.itself].relative));
  for (const std::string& sentence : finding.sentences)
    EXPECT_EQ(sentence.find("exact"), std::string::npos) << sentence;
}

TEST_F(MadeUp, no_accuracy_is_claimed_that_the_reference_does_not_have) {
  for (std::size_t c = 0; c < 8; ++c)
    outcomes[c].values[0] = 2 + (c % 2 == 0 ? 1 : -1) / static_cast<double>(1 + c % 4) + (c > 3 ? 0.01 : 0);
  const Finding finding = only();
  ASSERT_EQ(finding.sentences.size(), 1u);
  EXPECT_TRUE(finding.sentences[0].starts_with("What an accuracy of the tip costs cannot be told"))
      << finding.sentences[0];
}

TEST_F(MadeUp, problems_have_references_of_their_own) {
  study.problem = {"mesh"};
  for (std::size_t c = 4; c < 8; ++c) *outcomes[c].values[0] *= 10;
  const Analysis analysis = analyse(study, outcomes, exact);
  ASSERT_EQ(analysis.findings.size(), 2u);
  EXPECT_EQ(analysis.findings[0].problem, "mesh = coarse");
  EXPECT_NEAR(analysis.findings[0].reference.value, 2, 1e-9);
  EXPECT_NEAR(analysis.findings[1].reference.value, 20, 1e-8);
  EXPECT_TRUE(analysis.findings[1].sentences[0].starts_with("For mesh = fine: "));
}

TEST_F(MadeUp, failures_stay_and_do_not_disturb) {
  outcomes[2] = {};
  outcomes[2].name = "bad";
  outcomes[2].reason = "exit code 3: it <slides>";
  const Analysis analysis = analyse(study, outcomes, exact);
  EXPECT_EQ(analysis.findings[0].readings.size(), 7u);
  const std::string page = study_page(study, outcomes, analysis, "ashlar study x");
  EXPECT_NE(page.find("exit code 3: it &lt;slides&gt;"), std::string::npos);
  EXPECT_NE(page.find("1 case failed"), std::string::npos);
  const std::string csv = study_csv(study, outcomes, analysis);
  EXPECT_NE(csv.find("bad,failed,exit code 3"), std::string::npos);
}

TEST_F(MadeUp, every_row_of_the_table_has_every_column) {
  outcomes[3] = {};
  const std::string csv = study_csv(study, outcomes, analyse(study, outcomes, exact));
  std::size_t commas = 0;
  for (std::size_t begin = 0; begin < csv.size();) {
    const std::size_t end = csv.find('\n', begin);
    const auto count =
        static_cast<std::size_t>(std::count(csv.begin() + static_cast<std::ptrdiff_t>(begin),
                                            csv.begin() + static_cast<std::ptrdiff_t>(end), ','));
    if (begin == 0) commas = count;
    EXPECT_EQ(count, commas) << csv.substr(begin, end - begin);
    begin = end + 1;
  }
}

TEST(settings, read_back_as_they_were) {
  const core::Value level{{}, core::Quantity{12.5, {1, 0, 0}, false}};
  EXPECT_EQ(set_text(level), "12.5*u.m^1");
  EXPECT_EQ(set_text(core::make_value(0.1)), "0.1");
  EXPECT_EQ(set_text(text("quads")), "\"quads\"");
  EXPECT_EQ(set_text(core::make_value(true)), "true");
}

TEST(settings, folders_differ_where_texts_are_alike) {
  const auto cases = combinations({{"x", {core::make_value(1.0), text("1"), text("a/b")}}});
  const auto names = folder_names(cases);
  EXPECT_NE(names[0], names[1]);
  EXPECT_EQ(names[2], "x-a_b");
}

}  // namespace
}  // namespace ashlar::study
