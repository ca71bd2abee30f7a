#include "elasticity/utilisation.hpp"

#include <algorithm>
#include <cmath>

#include "core/log.hpp"
#include "core/parallel.hpp"
#include "elasticity/materials/common.hpp"
#include "elasticity/materials/principal.hpp"

namespace ashlar::elasticity {

using model::FieldResult;
using model::Model;

double share(double shear, double limit) {
  if (shear <= 0) return 0;
  return shear < most_utilisation * limit ? shear / limit : most_utilisation;
}

double utilisation(const CoulombLimit& limit, const model::Voigt& stress) {
  const Eigen::Vector3d principal = principal_axes(stress).stress;
  const double s1 = principal.maxCoeff(), s3 = principal.minCoeff();
  double used = std::isfinite(limit.tension) ? share(s1, limit.tension) : 0;
  if (std::isfinite(limit.cohesion)) {
    const double left = limit.cohesion * limit.cos_friction - 0.5 * (s1 + s3) * limit.sin_friction;
    used = std::max(used, share(0.5 * (s1 - s3), left));
  }
  return used;
}

std::optional<CoulombLimit> read_strength(const core::Settings& settings, core::Mistakes& mistakes) {
  const bool cohesion = settings.said("cohesion"), friction = settings.said("friction");
  if (cohesion != friction) {
    mistakes.add(settings.place_of(cohesion ? "cohesion" : "friction"),
                 "a strength needs both cohesion and friction",
                 "friction = 0 is a strength of cohesion alone, cohesion = 0 one of friction alone");
    return {};
  }
  CoulombLimit limit;
  if (cohesion) {
    const auto angle = read_angle(settings, "friction", {0, 90, true}, mistakes);
    if (!angle || !settings.has("cohesion")) return {};
    limit.cohesion = settings.number("cohesion");
    if (limit.cohesion == 0 && *angle == 0) {
      mistakes.add(settings.place_of("cohesion"), "without cohesion and friction there is no strength at all",
                   "give one of them a value above 0");
      return {};
    }
    limit.sin_friction = std::sin(*angle);
    limit.cos_friction = std::cos(*angle);
    if (limit.sin_friction > 0) limit.tension = limit.cohesion * limit.cos_friction / limit.sin_friction;
  }
  if (!settings.has("tensile_strength")) return cohesion ? std::optional(limit) : std::nullopt;
  const double tension = settings.number("tensile_strength");
  // The user may have computed c/tan φ himself.
  if (tension > limit.tension * (1 + 1e-9)) {
    mistakes.add(settings.place_of("tensile_strength"),
                 "exceeds cohesion/tan(friction) = " +
                     core::format_quantity(limit.tension, core::parse_dimension("Pa")) +
                     ", the most that cohesion and friction leave",
                 "a smaller value, or none to take just that");
    return {};
  }
  limit.tension = std::min(tension, limit.tension);
  return limit;
}

namespace {

double used_by(const model::Material& law, const Stress& stress) {
  const auto* strength = dynamic_cast<const WithStrength*>(&law);
  return strength ? strength->utilisation(stress) : 0;
}

/// At a mesh point, from the stress of each law's side.
double greatest_at(const Model& model, Index point, std::span<const Index> around, Recovery& recovery) {
  double greatest = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const model::Material& law = model.material(around[i]);
    const auto before = around.first(i);
    if (std::ranges::any_of(before, [&](Index c) { return &model.material(c) == &law; })) continue;
    const Stress stress = recovery.on_side(model.mesh.points[point], around, around[i]);
    greatest = std::max(greatest, used_by(law, stress));
  }
  return greatest;
}

bool has_strength(const model::Material& law) {
  return dynamic_cast<const WithStrength*>(&law) != nullptr;
}

}  // namespace

void warn_of_no_strength(const model::Scene& scene, const Model& model) {
  const core::Settings::Entry* fields = scene.outputs.find("fields");
  const core::Table* words = fields ? fields->value.table() : nullptr;
  std::string regions;
  for (std::size_t r = 0; r < scene.regions.size(); ++r)
    if (!has_strength(*model.materials[r]))
      regions += (regions.empty() ? "'" : "', '") + scene.regions[r].name;
  if (!words || regions.empty()) return;
  for (const core::Value& item : words->items)
    if (item.text() && item.text()->starts_with("utilisation"))
      core::log().warning(core::to_string(item.place) + ": the materials of " + regions +
                          "' have no strength: their utilisation is 0; give them cohesion and friction");
}

void add_utilisation(const Model& model, const CellStresses& cells, const std::set<std::string>& wanted,
                     model::StageResult& result) {
  if (std::ranges::none_of(model.materials, [](const auto& law) { return has_strength(*law); })) return;
  if (wanted.contains("utilisation")) {
    FieldResult field{"utilisation", "", FieldResult::On::cells, 1, {"utilisation"}, {}};
    for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
      field.values.push_back(used_by(model.material(cell), cells.stress[static_cast<std::size_t>(cell)]));
    result.fields.push_back(std::move(field));
  }
  if (!wanted.contains("utilisation_nodes")) return;
  FieldResult field{"utilisation_nodes", "", FieldResult::On::points, 1, {"utilisation"}, {}};
  field.values.resize(static_cast<std::size_t>(model.mesh.point_count()));
  const mesh::Adjacency cells_of_point = model.mesh.cell_points.transposed(model.mesh.point_count());
  core::parallel_for(field.values.size(), 256, [&](std::size_t begin, std::size_t end) {
    Recovery recovery(model, cells, cells_of_point);
    for (std::size_t p = begin; p < end; ++p) {
      const auto point = static_cast<Index>(p);
      field.values[p] = greatest_at(model, point, cells_of_point[point], recovery);
    }
  });
  result.fields.push_back(std::move(field));
}

}  // namespace ashlar::elasticity
