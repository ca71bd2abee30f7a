#include "output/pictures/pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "output/pictures/raster.hpp"
#include "output/pictures/values.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

using geometry::Point;
using mesh::Adjacency;
using mesh::Index;

double luminance(Color c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

TEST(colors, sequential_grows_lighter_evenly_and_stays_in_gamut) {
  double last = -1;
  for (int i = 0; i <= 50; ++i) {
    const Color c = sequential(i / 50.0);
    for (const double x : {c.r, c.g, c.b}) EXPECT_TRUE(x >= 0 && x <= 1);
    EXPECT_GT(luminance(c), last);
    last = luminance(c);
  }
}

TEST(colors, diverging_is_near_white_at_zero_and_blue_below) {
  const Color zero = diverging(0), below = diverging(-1), above = diverging(1);
  EXPECT_GT(luminance(zero), 0.9);
  EXPECT_GT(below.b, below.r);
  EXPECT_GT(above.r, above.b);
}

TEST(scale, units_and_numbers_are_round) {
  EXPECT_EQ(unit_scale("Pa", 2.5e5).name, "kPa");
  EXPECT_EQ(unit_scale("Pa", 1e6).name, "MPa");
  EXPECT_EQ(unit_scale("m", 3e-4).name, "µm");
  EXPECT_EQ(unit_scale("m", 0.05).name, "mm");
  EXPECT_EQ(unit_scale("", 5).name, "");
  EXPECT_DOUBLE_EQ(round_up(0.3), 0.5);
  EXPECT_DOUBLE_EQ(round_up(0.25), 0.25);
  EXPECT_DOUBLE_EQ(round_down(7.2e3), 5e3);
  EXPECT_EQ(tick_text(-0.25, 0.05), "\u22120.25");
  EXPECT_EQ(tick_text(-1e-18, 0.1), "0.0");
  EXPECT_EQ(tick_text(20, 20), "20");
  EXPECT_EQ(ticks(0.1, 9.9, 5), (std::vector<double>{2, 4, 6, 8}));
}

TEST(scale, bands_cover_the_range_and_say_what_lies_outside) {
  const Bands bands = make_bands(-3.1e5, -1e4, -3.1e5, 2e6);
  EXPECT_LE(bands.first, -3.1e5);
  EXPECT_GE(bands.edge(bands.count()), -1e4);
  EXPECT_GE(bands.count(), 6);
  EXPECT_LE(bands.count(), 14);
  EXPECT_FALSE(bands.open_below);
  EXPECT_TRUE(bands.open_above);
  EXPECT_EQ(make_bands(7, 7, 7, 7).count(), 1);
  EXPECT_EQ(make_bands(0, 0, 0, 0).count(), 1);
  // Both signs: white lies at zero.
  const Bands signs = make_bands(-10, 10, -10, 10);
  EXPECT_EQ(signs.count() % 2, 0);
  EXPECT_GT(luminance(signs.colors[signs.count() / 2]), 0.85);
}

int count_filled(const Image& image, std::uint32_t color) {
  return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), color));
}

TEST(raster, cells_fill_their_area_without_gaps) {
  const Sample sample = make_sample(2);
  const mesh::Mesh& mesh = sample.model.mesh;
  Image image(500, 300);
  fill_cells(image, {0, 15, 20}, {mesh.points, mesh.cell_points},
             std::vector<std::uint32_t>(mesh.cell_count(), 0xFF112233u));
  // 250 + 17.5 m² at 400 pixels each; borders through pixel centres may count either way.
  EXPECT_NEAR(count_filled(image, 0xFF112233u), 267.5 * 400, 120);
  for (int row = 102; row < 300; ++row)
    for (int column = 0; column < 500; ++column)
      ASSERT_NE(image.pixels[row * 500 + column], 0u) << row << " " << column;
}

TEST(raster, a_cell_that_bends_inward_keeps_its_shape) {
  const std::vector<Point> points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {8, 5}};
  Adjacency cells;
  cells.append(std::vector<Index>{0, 1, 2, 3, 4});
  Image image(100, 100);
  fill_cells(image, {0, 10, 10}, {points, cells}, std::vector<std::uint32_t>{0xFF445566u});
  EXPECT_NEAR(count_filled(image, 0xFF445566u), 6000, 60);
  EXPECT_EQ(image.pixels[50 * 100 + 20], 0u);
}

TEST(raster, bands_lie_where_the_values_are) {
  const std::vector<Point> points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Adjacency cells;
  cells.append(std::vector<Index>{0, 1, 2, 3});
  const std::vector<double> corners = {0, 10, 10, 0};  // the value is x
  Bands bands{0, 2.5, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}, false, false};
  Image image(100, 100);
  fill_bands(image, {0, 10, 10}, {points, cells}, corners, bands);
  for (const auto& [column, band] : {std::pair{10, 0}, {35, 1}, {60, 2}, {90, 3}})
    EXPECT_EQ(image.pixels[40 * 100 + column], packed(bands.colors[band])) << column;
}

TEST(raster, many_edges_add_up_to_a_tint_and_no_more) {
  Image image(40, 40);
  std::fill(image.pixels.begin(), image.pixels.end(), 0xFFFFFFFFu);
  const std::vector<Point> points = {{0, 20}, {40, 20}};
  const std::vector<std::array<Index, 2>> edges(1000, {0, 1});
  draw_edges(image, {0, 40, 1}, points, edges, 1, 0.5);
  const std::uint32_t level = image.pixels[20 * 40 + 20] & 0xFF;
  EXPECT_GT(level, 0x80u);
  EXPECT_LT(level, 0xA0u);
}

TEST(values, nodal_fields_jump_at_joints) {
  const Sample sample = make_sample(2);
  const mesh::Mesh& mesh = sample.model.mesh;
  const auto field = drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "ux");
  ASSERT_TRUE(field);
  double least = 1e300, greatest = -1e300;
  for (std::size_t i = 0; i < field->corners.size(); ++i) {
    const Point p = mesh.points[mesh.cell_points.values()[i]];
    if (geometry::distance(p, {4, 10}) > 1e-9) continue;
    least = std::min(least, field->corners[i]);
    greatest = std::max(greatest, field->corners[i]);
  }
  EXPECT_GT(greatest - least, 1e-5);
}

TEST(values, cell_fields_keep_their_jump_between_materials) {
  Sample sample = make_sample(2);
  auto& stress = sample.result.stages[1].fields[1];
  for (Index c = 0; c < sample.model.mesh.cell_count(); ++c)
    for (int k = 0; k < 4; ++k) stress.values[4 * c + k] = sample.model.mesh.cell_region[c] == 0 ? 1e3 : 5e3;
  const auto field = drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "syy");
  ASSERT_TRUE(field);
  for (Index c = 0; c < sample.model.mesh.cell_count(); ++c)
    for (Index i = sample.model.mesh.cell_points.offsets()[c];
         i < sample.model.mesh.cell_points.offsets()[c + 1]; ++i)
      ASSERT_EQ(field->corners[i], sample.model.mesh.cell_region[c] == 0 ? 1e3 : 5e3);
}

TEST(values, extremes_are_those_of_the_field_and_peaks_do_not_take_the_scale) {
  Sample sample = make_sample(4);
  auto& stress = sample.result.stages[1].fields[1];
  stress.values[4 * 7 + 1] = 9e9;
  const auto field = drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "syy");
  ASSERT_TRUE(field);
  EXPECT_EQ(field->greatest, 9e9);
  EXPECT_LT(field->high, 1e8);
  EXPECT_GT(field->high, field->low);
}

TEST(values, principal_stresses_follow_from_the_stress) {
  const Sample sample = make_sample(1);
  const auto s1 = drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "s1");
  const auto s3 = drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "s3");
  ASSERT_TRUE(s1 && s3);
  EXPECT_GE(s1->least, s3->least);
  EXPECT_FALSE(drawn_field({sample.scene, sample.model, sample.result.stages[1]}, "temperature"));
}

TEST(pictures, the_default_set_is_made) {
  const Sample sample = make_sample(1);
  const auto pictures = chosen_pictures(sample.scene, sample.model, sample.result);
  std::vector<std::string> names;
  for (const Picture& picture : pictures) names.push_back(picture.name);
  EXPECT_EQ(names, (std::vector<std::string>{"mesh", "deformed", "displacement", "ux", "uy", "sxx", "syy",
                                             "sxy", "s1", "s3", "joint_fault", "section_base"}));
  for (const Picture& picture : pictures) {
    const std::string png = png_bytes(picture);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << picture.name;
    EXPECT_EQ(png, png_bytes(picture)) << picture.name;
    const std::string svg = svg_bytes(picture);
    EXPECT_NE(svg.find("<svg"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
  }
}

TEST(pictures, crosses_are_thinned_on_fine_meshes) {
  const auto arms = [](int fineness) {
    const Sample sample = make_sample(fineness);
    const std::string svg = svg_bytes(cross_picture({sample.scene, sample.model, sample.result.stages[1]}));
    std::size_t count = 0;
    for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++count;
    return count;
  };
  const std::size_t coarse = arms(1), fine = arms(3), finer = arms(6);
  EXPECT_GT(fine, coarse);
  EXPECT_LT(finer, 1.5 * static_cast<double>(fine));
}

TEST(pictures, crosses_need_stresses_of_cells) {
  Sample sample = make_sample(1);
  auto& fields = sample.result.stages[1].fields;
  std::erase_if(fields, [](const model::FieldResult& field) { return field.name == "stress"; });
  EXPECT_TRUE(cross_picture({sample.scene, sample.model, sample.result.stages[1]}).name.empty());
}

TEST(pictures, the_scene_chooses) {
  Sample sample = make_sample(1);
  core::Settings::Entry entry;
  entry.key = "pictures";
  entry.value = core::make_value(core::Table{"", {core::make_value(std::string("stress"))}, {}});
  sample.scene.outputs.entries = {entry};
  EXPECT_EQ(chosen_pictures(sample.scene, sample.model, sample.result).size(), 4u);
  sample.scene.outputs.entries[0].value = core::make_value(false);
  EXPECT_TRUE(chosen_pictures(sample.scene, sample.model, sample.result).empty());
}

}  // namespace
}  // namespace ashlar::output
