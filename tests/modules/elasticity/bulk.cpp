#include "elasticity/bulk.hpp"

#include <gtest/gtest.h>

#include "core/parallel.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/vem.hpp"
#include "model/results.hpp"
#include "testing/meshes.hpp"

namespace ashlar::elasticity {
namespace {

using mesh::Index;

model::Model square(const mesh::RawMesh& raw) {
  model::Model model;
  model.mesh = testing::square_mesh(raw);
  model.materials = {std::make_shared<Elastic>(1e9, 0.25, model::Plane::strain)};
  model.element = std::make_shared<VemElement>(std::make_shared<BendingStabilisation>());
  model.dofs = fields::DofMap(model.mesh, {"displacement", "m"});
  return model;
}

core::Settings outputs(const std::vector<std::string>& fields) {
  core::Table words;
  for (const std::string& field : fields) words.items.push_back(core::make_value(field));
  core::Settings settings;
  core::Settings::Entry entry;
  entry.key = "fields";
  entry.value = core::make_value(std::move(words));
  entry.said = true;
  settings.entries.push_back(entry);
  return settings;
}

std::vector<model::FieldResult> results(const model::Model& model, const model::Scene& scene) {
  fields::State state;
  const auto id = state.add("displacement", static_cast<std::size_t>(model.dofs.size()));
  // Uniaxial strain along x: u = (1e-3 x, 0).
  for (Index p = 0; p < model.mesh.point_count(); ++p)
    state.trial(id)[model.dofs.of_point(p)] = 1e-3 * model.mesh.points[p].x;
  state.commit();
  core::Mistakes mistakes;
  Elasticity effect;
  model::Terms first, second;
  const model::StageData stage;
  effect.contribute({scene, stage, model, state, mistakes}, first);
  effect.contribute({scene, stage, model, state, mistakes}, second);
  EXPECT_EQ(first.stiffness, second.stiffness) << "one object serves all stages";
  model::StageResult result;
  first.stiffness.at(0)->add_results(state, result);
  return result.fields;
}

TEST(bulk, gives_all_fields_when_the_scene_does_not_say) {
  const model::Model model = square(testing::structured_square(3));
  std::set<std::string> names;
  for (const auto& field : results(model, {})) {
    names.insert(field.name);
    const auto entities =
        field.on == model::FieldResult::On::points ? model.mesh.point_count() : model.mesh.cell_count();
    EXPECT_EQ(field.values.size(), static_cast<std::size_t>(entities * field.width)) << field.name;
    EXPECT_EQ(field.components.size(), static_cast<std::size_t>(field.width)) << field.name;
    EXPECT_EQ(field.on == model::FieldResult::On::points,
              field.name == "displacement" || field.name.ends_with("_nodes"));
    // λ = μ = 0.4 GPa at ν = 0.25: stress 1.2, 0.4, 0, 0.4 MPa.
    std::vector<double> exact;
    if (field.name.starts_with("stress")) exact = {1.2e6, 0.4e6, 0, 0.4e6};
    if (field.name.starts_with("principal_stress")) exact = {1.2e6, 0.4e6};
    if (field.name.starts_with("von_mises")) exact = {0.8e6};
    for (std::size_t i = 0; i < field.values.size() && !exact.empty(); ++i)
      EXPECT_NEAR(field.values[i], exact[i % exact.size()], 1e-6) << field.name;
  }
  std::set<std::string> expected = all_fields;  // without those of a strength, which this material has not
  expected.erase("utilisation");
  expected.erase("utilisation_nodes");
  EXPECT_EQ(names, expected);
}

TEST(bulk, gives_what_outputs_and_probes_ask_for_and_nothing_else) {
  const model::Model model = square(testing::structured_square(2));
  model::Scene scene;
  scene.outputs = outputs({"displacement", "joint_pressure"});
  const auto names = [&] {
    std::set<std::string> found;
    for (const auto& field : results(model, scene)) found.insert(field.name);
    return found;
  };
  EXPECT_EQ(names(), (std::set<std::string>{"displacement"}));
  scene.probes.push_back({"crest", {}, "", {"displacement", "stress"}, {}});
  EXPECT_EQ(names(), (std::set<std::string>{"displacement", "stress_nodes"}));
  scene.outputs = outputs({"strain"});
  scene.probes.clear();
  EXPECT_EQ(names(), (std::set<std::string>{"strain"}));
}

TEST(bulk, results_do_not_depend_on_the_number_of_threads) {
  const model::Model model = square(testing::distorted_square(100));
  const Bulk bulk(model, all_fields);
  const algebra::Adjacency* lists[] = {&bulk.groups()};
  const algebra::SymmetricPattern pattern = algebra::make_pattern(model.dofs.size(), lists);
  fields::State state;
  const auto id = state.add("displacement", static_cast<std::size_t>(model.dofs.size()));
  for (std::size_t i = 0; i < state.trial(id).size(); ++i) state.trial(id)[i] = std::sin(1.0 + 0.1 * i);
  state.commit();

  std::vector<std::vector<double>> on_one;
  for (const int threads : {1, 2, 5}) {
    core::set_thread_count(threads);
    std::vector<std::vector<double>> found(2);
    found[0].resize(pattern.entries());
    bulk.add_tangent(algebra::ScatterMap(pattern, bulk.groups()), found[0]);
    found[1].resize(state.trial(id).size());
    bulk.add_internal_force(state.committed(id), found[1]);
    model::StageResult result;
    bulk.add_results(state, result);
    for (auto& field : result.fields) found.push_back(std::move(field.values));
    if (threads == 1) on_one = found;
    EXPECT_EQ(found, on_one) << threads << " threads";
  }
  core::set_thread_count(1);
}

}  // namespace
}  // namespace ashlar::elasticity
