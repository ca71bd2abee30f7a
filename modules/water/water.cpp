#include "water/water.hpp"

#include <algorithm>

#include "core/log.hpp"

namespace ashlar::water {

namespace {

constexpr double usual_unit_weight = 9810;  // N/m³: γ_w of the source paper's dam

const core::Dimension metre{1, 0, 0};

/// The `Water { … }` of a stage: one, a list, or none.
std::vector<const core::Settings*> waters(const model::StageData& stage) {
  const core::Settings::Entry& entry = stage.settings.entry("water");
  if (entry.object) return {entry.object.get()};
  std::vector<const core::Settings*> list;
  for (const auto& [name, water] : entry.objects) list.push_back(&water);
  return list;
}

/// Names of the wet edges with the places that say so: both lips of a joint.
std::vector<std::pair<std::string, core::Place>> wet_names(const core::Settings& water,
                                                           const model::Scene& scene) {
  std::vector<std::pair<std::string, core::Place>> names;
  if (water.has("on"))
    for (const core::Value& name : water.value("on").table()->items)
      names.emplace_back(*name.text(), name.place);
  if (!water.has("joints")) return names;
  for (const core::Value& name : water.value("joints").table()->items)
    for (const model::JointData& joint : scene.joints)
      if (joint.line.name == *name.text())
        for (const std::string& side : joint.line.sides)
          names.emplace_back(joint.line.name + "." + side, name.place);
  return names;
}

double lowest(const mesh::Mesh& mesh, const std::vector<mesh::Index>& edges) {
  double y = std::numeric_limits<double>::infinity();
  for (const mesh::Index edge : edges)
    for (const mesh::Index point : mesh.edge_points[edge]) y = std::min(y, mesh.points[point].y);
  return y;
}

}  // namespace

double unit_weight(const core::Settings& water) {
  if (water.has("density")) return water.number("density") * core::standard_gravity;
  return water.number("unit_weight", usual_unit_weight);
}

model::EdgeTraction pressure(double unit_weight, double level) {
  const auto at = [=](mesh::Point point, mesh::Point outward) {
    return -unit_weight * std::max(0.0, level - point.y) * outward;
  };
  return {at, 1, {level}};
}

void Water::check(const model::Scene& scene, core::Mistakes& mistakes) const {
  for (const model::StageData& stage : scene.stages) {
    const core::Value& said = stage.settings.value("water");
    if (said.boolean() && *said.boolean())
      mistakes.add(said.place, "water = true says neither level nor face",
                   "Water { level = …, on = { … } }, a list of them, or false");
    for (const core::Settings* water : waters(stage)) {
      if (!water->has("density") && !water->has("unit_weight"))
        core::log().info(core::to_string(water->place) + ": unit weight of water 9.81 kN/m^3, the default");
    }
  }
}

std::vector<mesh::Index> Water::wet_edges(const core::Settings& water, const model::StageContext& context) {
  const mesh::Mesh& mesh = context.model.mesh;
  const double level = water.number("level");
  std::vector<mesh::Index> edges;
  for (const auto& [name, place] : wet_names(water, context.scene)) {
    const std::vector<mesh::Index> face = model::border_edges(mesh, name, place, context.mistakes);
    const double bottom = lowest(mesh, face);
    if (!face.empty() && level <= bottom && warned_.insert({context.stage.name, name}).second)
      core::log().warning(core::to_string(water.place_of("level")) + ": stage '" + context.stage.name +
                          "': the water level " + core::format_quantity(level, metre) +
                          " is below the whole of edge '" + name + "', whose lowest point is at " +
                          core::format_quantity(bottom, metre));
    edges.insert(edges.end(), face.begin(), face.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void Water::contribute(const model::StageContext& context, model::Terms& terms) {
  std::vector<double> force(context.model.dofs.size());
  model::LoadOrigin origin;
  for (const core::Settings* water : waters(context.stage)) {
    const model::EdgeTraction traction = pressure(unit_weight(*water), water->number("level"));
    std::vector<mesh::Index> edges = wet_edges(*water, context);
    for (const mesh::Index edge : edges) model::add_traction(context.model, edge, traction, force);
    origin.tractions.emplace_back(std::move(edges), traction);
  }
  terms.loads.push_back(std::make_shared<model::ForceVector>("water", force, std::move(origin)));
}

}  // namespace ashlar::water

ASHLAR_MODULE(registry) {
  registry.add_make("effect", "water", std::function<ashlar::model::MakeEffect>([](ashlar::core::Registry&) {
                      return std::make_unique<ashlar::water::Water>();
                    }));
}
