#include "gravity/gravity.hpp"

#include <cassert>
#include <set>

#include "core/log.hpp"
#include "model/edge_load.hpp"

namespace ashlar::gravity {

double acceleration(const core::Settings& stage) {
  const core::Value& said = stage.value("gravity");
  if (const core::Quantity* number = said.quantity()) return number->value;
  return said.boolean() && *said.boolean() ? core::standard_gravity : 0;
}

std::shared_ptr<const model::Load> self_weight(const model::Model& model, double g) {
  const mesh::Mesh& mesh = model.mesh;
  std::vector<double> force(model.dofs.size()), local;
  std::vector<mesh::Index> dofs;
  std::vector<mesh::Point> corners;
  for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const double weight = model.material(cell).unit_weight(g);
    assert(weight >= 0);
    if (weight == 0) continue;
    dofs.clear();
    model.dofs.append_cell(mesh, cell, dofs);
    local.assign(dofs.size(), 0.0);
    model.element->add_body_force(model.cell(mesh.corners(cell, corners)), {0, -weight}, local);
    for (std::size_t i = 0; i < dofs.size(); ++i) force[dofs[i]] += local[i];
  }
  const auto weight = [&model, g](mesh::Index cell) {
    return mesh::Point{0, -model.material(cell).unit_weight(g)};
  };
  return std::make_shared<model::ForceVector>("gravity", force, model::LoadOrigin{weight, {}});
}

void Gravity::check(const model::Scene& scene, core::Mistakes& mistakes) const {
  std::set<double> seen;
  for (const model::StageData& stage : scene.stages) {
    const double g = acceleration(stage.settings);
    if (g == 0 || !seen.insert(g).second) continue;
    for (const model::RegionData& region : scene.regions) check_region(scene, region, g, mistakes);
  }
}

void Gravity::check_region(const model::Scene& scene, const model::RegionData& region, double g,
                           core::Mistakes& mistakes) const {
  // Mistakes of the law itself are reported by whoever builds the model.
  core::Mistakes others;
  const auto make = registry_.make<model::MakeMaterial>("material", region.material.name);
  const auto material = make(region.material, model::law_plane(scene.plane), others);
  if (!material) return;
  if (material->unit_weight(g) < 0)
    mistakes.add(region.material.place,
                 "region '" + region.name + "' has no weight, but a stage says gravity",
                 "give its material unit_weight or density (0 for a region without weight)");
  const bool fixed = material->unit_weight(g) > 0 && material->unit_weight(2 * g) == material->unit_weight(g);
  if (fixed && g != core::standard_gravity)
    core::log().warning("region '" + region.name + "' is given by its unit weight: gravity = " +
                        core::format_quantity(g, core::parse_dimension("m/s^2")) + " does not change it");
}

void Gravity::contribute(const model::StageContext& context, model::Terms& terms) {
  const double g = acceleration(context.stage.settings);
  if (g == 0) return;
  if (!load_ || model_ != &context.model || g_ != g) load_ = self_weight(context.model, g);
  model_ = &context.model;
  g_ = g;
  terms.loads.push_back(load_);
}

}  // namespace ashlar::gravity

ASHLAR_MODULE(registry) {
  registry.add_make("effect", "gravity",
                    std::function<ashlar::model::MakeEffect>([](ashlar::core::Registry& all) {
                      return std::make_unique<ashlar::gravity::Gravity>(all);
                    }));
}
