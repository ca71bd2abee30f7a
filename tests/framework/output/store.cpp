#include "output/store.hpp"

#include <gtest/gtest.h>

#include "output/files.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

namespace fs = std::filesystem;

fs::path stored(const Sample& sample, const std::string& name) {
  const fs::path file = fresh_folder(name) / "results.h5";
  write_file(file, store_bytes(sample.record(), "2020-01-02T03:04:05Z"));
  return file;
}

TEST(store, mesh_and_fields_come_back) {
  const Sample sample = make_sample(1);
  const mesh::Mesh& mesh = sample.model.mesh;
  const fs::path file = stored(sample, "store");
  EXPECT_EQ(read_text_attribute(file, "/", "format"), "ashlar results");
  EXPECT_EQ(read_number_attribute(file, "/", "format_version"), store_format_version);
  const StoredNumbers points = read_numbers(file, "/mesh/points");
  ASSERT_EQ(points.rows, mesh.points.size());
  ASSERT_EQ(points.columns, 2u);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_EQ(points.values[2 * i], mesh.points[i].x);
    EXPECT_EQ(points.values[2 * i + 1], mesh.points[i].y);
  }
  const auto offsets = read_numbers(file, "/mesh/cell_offsets").values;
  EXPECT_TRUE(std::equal(offsets.begin(), offsets.end(), mesh.cell_points.offsets().begin(),
                         mesh.cell_points.offsets().end()));
  EXPECT_EQ(read_texts(file, "/mesh/regions"), mesh.regions);
  EXPECT_EQ(read_numbers(file, "/mesh/joints/fault/lip_1/s_to").rows, mesh.joints[0].lips[1].size());
  EXPECT_EQ(read_names(file, "/stages"), (std::vector<std::string>{"01 self-weight", "02 reservoir"}));
  const std::string stage = "/stages/02 reservoir";
  for (const auto& field : sample.result.stages[1].fields) {
    EXPECT_EQ(read_numbers(file, stage + "/fields/" + field.name).values, field.values);
    EXPECT_EQ(read_text_attribute(file, stage + "/fields/" + field.name, "unit"), field.unit);
  }
  EXPECT_EQ(read_text_attribute(file, stage + "/fields/stress", "on"), "cells");
}

TEST(store, joints_probes_balance_and_iterations_come_back) {
  const Sample sample = make_sample(1);
  const fs::path file = stored(sample, "store-rest");
  const std::string stage = "/stages/02 reservoir";
  const auto& joint = sample.result.stages[1].joints[0];
  const auto slip = read_numbers(file, stage + "/joints/fault/slip").values;
  ASSERT_EQ(slip.size(), joint.rows.size());
  for (std::size_t i = 0; i < slip.size(); ++i) EXPECT_EQ(slip[i], joint.rows[i].slip);
  EXPECT_EQ(read_number_attribute(file, stage + "/joints/fault", "normal_force"), joint.normal_force);
  EXPECT_EQ(read_texts(file, stage + "/probes/crest/quantities"), (std::vector<std::string>{"ux", "uy"}));
  EXPECT_EQ(read_numbers(file, stage + "/probes/crest/values").values[0], 1.0 / 3e5);
  const auto& section = sample.result.stages[1].sections[0];
  const auto normal = read_numbers(file, stage + "/sections/base/sn").values;
  ASSERT_EQ(normal.size(), section.rows.size());
  for (std::size_t i = 0; i < normal.size(); ++i) EXPECT_EQ(normal[i], section.rows[i].values[1]);
  EXPECT_EQ(read_texts(file, stage + "/sections/base/side")[3], "left");
  EXPECT_EQ(read_number_attribute(file, stage + "/sections/base", "difference"), section.difference);
  EXPECT_EQ(read_texts(file, stage + "/balance/loads_names"), (std::vector<std::string>{"gravity", "water"}));
  EXPECT_EQ(read_numbers(file, stage + "/balance/loads").values[1], -6.42e6);
  const auto opened = read_numbers(file, stage + "/iterations/facts/opened").values;
  EXPECT_EQ(opened[0], 3);
  EXPECT_TRUE(std::isnan(opened[1]));
}

TEST(store, provenance_tells_what_was_said_and_what_defaulted) {
  const Sample sample = make_sample(1);
  const fs::path file = stored(sample, "provenance");
  const std::string settings = "/provenance/settings/";
  EXPECT_EQ(read_texts(file, settings + "path"), (std::vector<std::string>{"title", "thickness"}));
  EXPECT_EQ(read_texts(file, settings + "value"), (std::vector<std::string>{"Dam", "1 m"}));
  EXPECT_EQ(read_texts(file, settings + "place")[0], "scene.lua:3: title");
  EXPECT_EQ(read_numbers(file, settings + "said").values, (std::vector<double>{1, 0}));
  EXPECT_EQ(read_texts(file, "/provenance/sources/value")[0], sample.record().sources[0].text);
  EXPECT_EQ(read_texts(file, "/provenance/log/value"), std::vector<std::string>{"made up"});
  EXPECT_EQ(read_text_attribute(file, "/provenance", "date"), "2020-01-02T03:04:05Z");
}

TEST(store, settings_of_objects_are_listed_below_them) {
  core::Settings material, root;
  material.kind = "material";
  material.name = "elastic";
  core::Settings::Entry stiffness, object;
  stiffness.key = "E";
  stiffness.value = core::make_value(1e10, {"s.lua", 2, "E"});
  stiffness.said = true;
  stiffness.dimension = core::parse_dimension("Pa");
  material.entries = {stiffness};
  object.key = "material";
  object.object = std::make_shared<const core::Settings>(material);
  object.said = true;
  root.entries = {object};
  const auto rows = setting_rows(root);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].value, "material.elastic");
  EXPECT_EQ(rows[1].path, "material.E");
  EXPECT_EQ(rows[1].value, "1e+10 Pa");
}

TEST(store, equal_results_give_equal_bytes) {
  Sample sample = make_sample(1);
  // Peak memory is not a result: it may grow between the two.
  const std::string first = store_bytes(sample.record(), "d"), second = store_bytes(sample.record(), "d");
  ASSERT_EQ(first.size(), second.size());
  std::size_t differing = 0;
  for (std::size_t i = 0; i < first.size(); ++i) differing += first[i] != second[i];
  EXPECT_LE(differing, sizeof(double));
}

TEST(store, what_is_no_store_is_refused_by_name) {
  const fs::path file = fresh_folder("garbage") / "results.h5";
  write_file(file, "no HDF5");
  EXPECT_THROW(read_numbers(file, "/mesh/points"), core::InputError);
  const fs::path good = stored(make_sample(1), "missing");
  try {
    read_numbers(good, "/mesh/nothing");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/mesh/nothing"), std::string::npos);
  }
}

}  // namespace
}  // namespace ashlar::output
