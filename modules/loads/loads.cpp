#include "loads/loads.hpp"

#include <algorithm>
#include <optional>

#include "loads/edge_values.hpp"
#include "loads/point_loads.hpp"

namespace ashlar::loads {

namespace {

constexpr core::Dimension metre{1, 0, 0};

/// `key = true` says nothing that could act; false takes the load away.
void check_flag(const core::Settings& stage, const std::string& key, core::Mistakes& mistakes) {
  const core::Value& said = stage.value(key);
  if (said.boolean() && *said.boolean())
    mistakes.add(said.place, key + " = true says no load", "a table of " + key + ", or false for none");
}

void check_couple(const core::Settings& couple, core::Mistakes& mistakes) {
  const core::Table* between = couple.value("between").table();
  if (between && between->items.size() != 2)
    mistakes.add(couple.place_of("between"),
                 "a couple acts between two places, got " + std::to_string(between->items.size()));
}

/// Entries of a map, or nothing if it was not said or turned off.
const std::vector<std::pair<std::string, core::Value>>& named(const core::Settings& stage,
                                                              const std::string& key) {
  static const std::vector<std::pair<std::string, core::Value>> none;
  const core::Table* table = stage.value(key).table();
  return table ? table->entries : none;
}

/// Reports an edge that reaches beyond the heights of its table.
bool covers(const Table& table, const std::string& edge, const model::StageContext& context) {
  const mesh::Mesh& mesh = context.model.mesh;
  double low = table.y.back(), high = table.y.front();
  const auto group = mesh.edge_groups.find(edge);
  if (group == mesh.edge_groups.end()) return true;  // reported where the load is added
  for (const geometry::Index each : group->second)
    for (const geometry::Index point : mesh.edge_points[each]) {
      low = std::min(low, mesh.points[point].y);
      high = std::max(high, mesh.points[point].y);
    }
  if (table.holds(low) && table.holds(high)) return true;
  context.mistakes.add(table.place,
                       "the table covers heights from " + core::format_quantity(table.y.front(), metre) +
                           " to " + core::format_quantity(table.y.back(), metre) + ", but edge '" + edge +
                           "' goes from " + core::format_quantity(low, metre) + " to " +
                           core::format_quantity(high, metre),
                       "add rows, also where the pressure is 0");
  return false;
}

void add_edge_loads(const model::StageContext& context, std::span<double> force, model::LoadOrigin& origin) {
  const core::Settings& stage = context.stage.settings;
  const auto add = [&](const std::string& name, const core::Place& place, const model::EdgeTraction& load) {
    auto edges = model::border_edges(context.model.mesh, name, place, context.mistakes);
    for (const geometry::Index edge : edges) model::add_traction(context.model, edge, load, force);
    origin.tractions.emplace_back(std::move(edges), load);
  };
  for (const auto& [name, components] : stage.objects("tractions"))
    add(name, components.place, traction(components));
  for (const auto& [name, value] : named(stage, "pressures")) {
    const auto table = value.table() ? std::optional(read_table(value, context.mistakes)) : std::nullopt;
    if (!table || covers(*table, name, context)) add(name, value.place, pressure(value));
  }
}

}  // namespace

void Loads::check(const model::Scene& scene, core::Mistakes& mistakes) const {
  for (const model::StageData& stage : scene.stages) {
    for (const char* key : {"tractions", "pressures", "forces", "couples"})
      check_flag(stage.settings, key, mistakes);
    for (const auto& [name, value] : named(stage.settings, "pressures"))
      if (value.table()) read_table(value, mistakes);
    for (const auto& [name, said] : stage.settings.objects("couples")) check_couple(said, mistakes);
  }
}

void Loads::contribute(const model::StageContext& context, model::Terms& terms) {
  std::vector<double> force(context.model.dofs.size());
  model::LoadOrigin origin;
  const core::Settings& stage = context.stage.settings;
  try {
    add_edge_loads(context, force, origin);
    for (const auto& [name, said] : stage.objects("forces"))
      add_force(said, context.model, force, context.mistakes);
    for (const auto& [name, said] : stage.objects("couples"))
      add_couple(said, context.model, force, context.mistakes);
  } catch (const core::InputError& error) {
    context.mistakes.add(error);
  }
  terms.loads.push_back(std::make_shared<model::ForceVector>("loads", force, std::move(origin)));
}

}  // namespace ashlar::loads

ASHLAR_MODULE(registry) {
  registry.add_make("effect", "loads", std::function<ashlar::model::MakeEffect>([](ashlar::core::Registry&) {
                      return std::make_unique<ashlar::loads::Loads>();
                    }));
}
