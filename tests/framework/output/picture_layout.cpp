// What stands where on a page, and what is drawn as a field at all.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "output/pictures/chart.hpp"
#include "output/pictures/labels.hpp"
#include "output/pictures/legend.hpp"
#include "output/pictures/pictures.hpp"
#include "output/pictures/values.hpp"
#include "output/tables.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

using geometry::Point;
using model::FieldResult;

/// The sample's mesh stretched to a body of this size; its joint and values go with it.
Sample stretched(double width, double height, double from = 0) {
  Sample sample = make_sample(1);
  for (Point& p : sample.model.mesh.points) p = {from + p.x * width / 25, from + p.y * height / 15};
  sample.model.length = std::hypot(width, height);
  return sample;
}

void expect_tidy(const Picture& picture, const std::string& which) {
  const std::vector<TextBox> texts = page_texts(picture.draw);
  ASSERT_FALSE(texts.empty());
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Box& box = texts[i].box;
    EXPECT_TRUE(box.corner.x >= 0 && box.corner.y >= 0 && box.corner.x + box.width <= page_width &&
                box.corner.y + box.height <= picture.height)
        << which << " " << picture.name << ": '" << texts[i].markup << "' leaves the page";
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_LT(overlap(box, texts[k].box), 0.3)
          << which << " " << picture.name << ": '" << texts[i].markup << "' on '" << texts[k].markup << "'";
  }
}

TEST(layout, texts_keep_apart_on_bodies_of_any_shape_and_size) {
  struct Shape {
    const char* name;
    double width, height, from = 0;
  };
  for (const Shape& shape : {Shape{"square", 10, 10},
                             {"wide", 100, 10},
                             {"very wide", 60, 3},
                             {"tall", 5, 100},
                             {"needle", 0.5, 200},
                             {"tiny", 1e-3, 6e-4},
                             {"small", 0.2, 0.1},
                             {"huge", 1e4, 3e3},
                             {"country", 4e5, 9e4},
                             {"surveyed", 11, 60, 4561230}}) {
    const Sample sample = stretched(shape.width, shape.height, shape.from);
    for (const Picture& picture : chosen_pictures(sample.scene, sample.model, sample.result))
      expect_tidy(picture, shape.name);
    expect_tidy(cross_picture({sample.scene, sample.model, sample.result.stages[1]}), shape.name);
  }
}

TEST(layout, texts_keep_apart_whatever_the_values) {
  for (const double factor : {1e-13, 1e-7, 1.0, 3.7e3, 1e9}) {
    Sample sample = make_sample(1);
    for (FieldResult& field : sample.result.stages.back().fields)
      for (double& value : field.values) value *= factor;
    for (const Picture& picture : chosen_pictures(sample.scene, sample.model, sample.result))
      expect_tidy(picture, std::to_string(factor));
  }
}

TEST(layout, labels_at_one_place_part_and_stay_in_the_plot) {
  const Frame frame = make_frame({0, 1, 0, 1}, {});
  const Image image = frame.image();
  Labels labels(frame, image);
  std::vector<Box> boxes;
  const Point corner = frame.corner + Point{frame.width, 0};
  for (int i = 0; i < 4; ++i) boxes.push_back(labels.beside(corner, 6, 60, 6.5));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].corner.x, frame.corner.x);
    EXPECT_LE(boxes[i].corner.x + boxes[i].width, frame.corner.x + frame.width);
    EXPECT_GE(boxes[i].corner.y, frame.corner.y);
    for (std::size_t k = 0; k < i && i < 2; ++k) EXPECT_EQ(overlap(boxes[i], boxes[k]), 0);
  }
}

TEST(roundoff, is_told_from_values_by_the_whole_field) {
  Sample sample = make_sample(1);
  FieldResult& u = sample.result.stages[1].fields[0];
  const auto kind = [&](double ux_change, double ux_mean) {
    for (std::size_t i = 0; i < u.values.size(); i += 2) {
      u.values[i] = ux_mean + ux_change * (i % 4 == 0 ? 1 : -1);
      u.values[i + 1] = -1e-3 * static_cast<double>(i) / static_cast<double>(u.values.size());
    }
    return drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "ux")->kind;
  };
  using Kind = DrawnField::Kind;
  EXPECT_EQ(kind(1e-16, 0), Kind::zero);
  EXPECT_EQ(kind(0, 0), Kind::zero);
  EXPECT_EQ(kind(1e-16, 5e-4), Kind::uniform);
  EXPECT_EQ(kind(1e-10, 0), Kind::varied);
}

TEST(roundoff, is_said_in_the_title_and_has_no_bar) {
  Sample sample = make_sample(1);
  FieldResult& u = sample.result.stages[1].fields[0];
  for (std::size_t i = 0; i < u.values.size(); i += 2) u.values[i] = 1e-19 * static_cast<double>(i % 7);
  const auto texts =
      page_texts(field_picture({sample.scene, sample.model, sample.result.stages[1]}, "ux").draw);
  EXPECT_NE(texts[0].markup.find("zero to round-off"), std::string::npos);
  for (const TextBox& text : texts) EXPECT_EQ(text.markup.find("e-1"), std::string::npos) << text.markup;
}

TEST(roundoff, extremes_within_it_are_zero) {
  Sample sample = make_sample(1);
  FieldResult& u = sample.result.stages[1].fields[0];
  for (std::size_t i = 0; i < u.values.size(); i += 2) u.values[i] = i == 0 ? -3e-20 : 1e-3;
  EXPECT_EQ(drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "ux")->least, 0);
}

TEST(range, few_cells_are_spread_over_their_corners) {
  Sample sample;
  mesh::Mesh& mesh = sample.model.mesh;
  mesh.points = {{0, 0}, {20, 0}, {40, 0}, {0, 8}, {20, 8}, {40, 8}};
  for (const auto& ring : {std::vector<mesh::Index>{0, 1, 4, 3}, {1, 2, 5, 4}}) mesh.cell_points.append(ring);
  mesh.cell_region = {0, 0};
  mesh.regions = {"beam"};
  model::StageResult stage;
  stage.fields = {{"displacement", "m", FieldResult::On::points, 2, {"x", "y"}, {}}};
  for (const Point& p : mesh.points) stage.fields[0].values.insert(stage.fields[0].values.end(), {p.x, p.y});
  const auto field = drawn_field({sample.scene, sample.model, stage}, "ux");
  EXPECT_EQ(field->low, 0);
  EXPECT_EQ(field->high, 40);
}

std::vector<std::string> names_of(const Sample& sample) {
  std::vector<std::string> names;
  for (const Picture& picture : chosen_pictures(sample.scene, sample.model, sample.result))
    names.push_back(picture.name);
  return names;
}

core::Settings::Entry outputs_entry(const std::string& key, std::vector<std::string> words) {
  core::Settings::Entry entry;
  entry.key = key;
  core::Table list;
  for (const std::string& word : words) list.items.push_back(core::make_value(word));
  entry.value = core::make_value(list);
  return entry;
}

TEST(choice, what_follows_from_the_stress_is_reached_by_name) {
  Sample sample = make_sample(1);
  for (auto& stage : sample.result.stages) stage.fields.erase(stage.fields.begin());
  EXPECT_EQ(names_of(sample), (std::vector<std::string>{"mesh", "sxx", "syy", "sxy", "s1", "s3",
                                                        "joint_fault", "section_base"}));
  sample.scene.outputs.entries = {
      outputs_entry("pictures", {"stress", "principal_stress", "tmax", "von_mises"})};
  EXPECT_EQ(names_of(sample),
            (std::vector<std::string>{"sxx", "syy", "sxy", "szz", "s1", "s3", "tmax", "von_mises"}));
}

TEST(choice, von_mises_and_the_greatest_shear_are_those_of_the_tensor) {
  Sample sample = make_sample(1);
  FieldResult& stress = sample.result.stages[1].fields[1];
  for (std::size_t i = 0; i < stress.values.size(); i += 4) {
    const double tensor[] = {3e6, -1e6, 1.5e6, 0.6e6};
    std::copy(std::begin(tensor), std::end(tensor), stress.values.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const PictureSource source{sample.scene, sample.model, sample.result.stages[1]};
  EXPECT_NEAR(drawn_field(source, "tmax")->greatest, 2.5e6, 1);
  EXPECT_NEAR(drawn_field(source, "s1")->greatest, 3.5e6, 1);
  // √(½((3+1)² + (−1−0.6)² + (0.6−3)²) + 3·1.5²)
  EXPECT_NEAR(drawn_field(source, "von_mises")->greatest, std::sqrt(0.5 * (16 + 2.56 + 5.76) + 6.75) * 1e6,
              1);
}

TEST(choice, stages_other_than_the_last_have_a_folder) {
  Sample sample = make_sample(1);
  sample.scene.outputs.entries = {outputs_entry("pictures", {"uy", "joints"}), {}};
  core::Settings::Entry& stages = sample.scene.outputs.entries[1];
  stages = outputs_entry("picture_stages", {"self-weight"});
  EXPECT_EQ(names_of(sample), (std::vector<std::string>{"01_self-weight/uy", "joint_fault"}));
  stages.value = core::make_value(true);
  EXPECT_EQ(names_of(sample), (std::vector<std::string>{"01_self-weight/uy", "uy", "joint_fault"}));
  stages.value = core::make_value(false);
  EXPECT_EQ(names_of(sample), (std::vector<std::string>{"uy", "joint_fault"}));
}

TEST(profile, welded_tips_close_it_without_a_pressure) {
  model::JointResult joint;
  joint.rows = {{.s = 1, .at = {}, .opening = -1e-9, .slip = 2e-5, .pressure = 1e5, .closed = true},
                {.s = 2, .at = {}, .opening = 1e-9, .slip = 1e-5, .piece = 1}};
  joint.tips = {{0, {7, 7}}, {3, {9, 9}}};
  const auto rows = rows_and_tips(joint);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows.front().at.x, 7);
  EXPECT_EQ(rows.front().slip, 0);
  EXPECT_TRUE(std::isnan(rows.back().pressure));
  EXPECT_EQ(rows.back().piece, 1);
  model::RunResult result;
  result.stages.resize(1);
  joint.name = "fault";
  result.stages[0].joints = {joint};
  EXPECT_NE(joint_csv(result, "fault").find(",3,9,9,0,0,,,,,,1,1\n"), std::string::npos);
}

TEST(profile, a_peak_does_not_take_the_axis_and_is_told) {
  Sample sample = make_sample(40);
  model::JointResult& joint = sample.result.stages[1].joints[0];
  ASSERT_GT(joint.rows.size(), 210u);
  joint.rows[100].pressure = 6e7;
  bool told = false;
  for (const TextBox& text : page_texts(joint_picture(sample.scene, sample.result, "fault").draw)) {
    told = told || text.markup.starts_with("peak 60 MPa");
    EXPECT_EQ(text.markup.find("[MPa]"), std::string::npos);
  }
  EXPECT_TRUE(told);
}

Chart chart_of(int curves) {
  Chart chart{"*x*", "*y*", {1, "m"}, {1, "Pa"}, {}};
  for (int i = 0; i < curves; ++i)
    chart.curves.push_back({"curve with the number " + std::to_string(i), {{0, 1.0 * i}, {1, 50.0}}});
  return chart;
}

TEST(chart, its_legend_takes_the_rows_that_it_needs) {
  const Chart chart = chart_of(7);
  expect_tidy({"chart", page_height(chart), [&](Canvas& canvas) { draw_chart(canvas, chart, 0); }},
              "seven curves");
  EXPECT_DOUBLE_EQ(page_height(chart), page_height(chart_of(1)) + 3 * legend_row) << "two curves a row";
}

TEST(chart, axes_are_as_long_as_asked) {
  Chart chart = chart_of(1);
  chart.y_range = {{-2, 2}};
  std::vector<std::string> texts;
  for (const TextBox& text : page_texts([&](Canvas& canvas) { draw_chart(canvas, chart, 0); }))
    texts.push_back(text.markup);
  EXPECT_NE(std::ranges::find(texts, "−2"), texts.end());
  EXPECT_EQ(std::ranges::find(texts, "50"), texts.end()) << "the curve goes there";
}

}  // namespace
}  // namespace ashlar::output
