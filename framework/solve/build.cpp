#include "solve/build.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/ledger.hpp"
#include "core/log.hpp"
#include "geometry/polygon.hpp"
#include "mesh/face_lips.hpp"
#include "mesh/generator.hpp"
#include "mesh/groups.hpp"
#include "mesh/near_lines.hpp"
#include "solve/sections.hpp"

namespace ashlar::solve {

using geometry::Index;

namespace {

/// The smallest cell size that the scene names [m]; nothing if it names none.
std::optional<double> cell_size(const model::Scene& scene, double area) {
  std::optional<double> size;
  const auto take = [&](double each) { size = std::min(each, size.value_or(each)); };
  for (const auto& entry : scene.mesh.entries) {
    const core::Quantity* number = entry.value.quantity();
    if (entry.key == "cells" && number) take(std::sqrt(area / number->value));
    if (entry.key == "refine")
      for (const auto& [name, refinement] : entry.objects)
        if (refinement.has("size")) take(refinement.number("size"));
    if (entry.key != "size") continue;
    if (number) take(number->value);
    if (const core::Table* by_region = entry.value.table())
      for (const auto& [region, value] : by_region->entries)
        if (value.quantity()) take(value.quantity()->value);
  }
  return size;
}

double shape_length(const geometry::Shape& shape) {
  double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
  const auto visit = [&](const auto& self, const geometry::Shape& part) -> void {
    for (const auto& ring : part.rings)
      for (const auto& edge : ring) {
        // An arc may reach all round its centre; a disk is one edge.
        const geometry::Point middle = edge.arc ? edge.arc->center : edge.start;
        const double reach = geometry::distance(middle, edge.start);
        low_x = std::min(low_x, middle.x - reach), high_x = std::max(high_x, middle.x + reach);
        low_y = std::min(low_y, middle.y - reach), high_y = std::max(high_y, middle.y + reach);
      }
    for (const auto& operand : part.operands) self(self, operand);
  };
  visit(visit, shape);
  return std::max(0.0, std::hypot(high_x - low_x, high_y - low_y));
}

bool has_arcs(const geometry::Shape& shape) {
  for (const auto& ring : shape.rings)
    for (const auto& edge : ring)
      if (edge.arc) return true;
  return std::any_of(shape.operands.begin(), shape.operands.end(), has_arcs);
}

/// A mesh from a file names its own regions: cells are renumbered to the scene's regions.
void name_file_regions(const model::Scene& scene, mesh::RawMesh& raw, core::Mistakes& mistakes) {
  std::vector<Index> to_scene(raw.regions.size(), -1);
  for (std::size_t r = 0; r < scene.regions.size(); ++r) {
    const auto found = std::find(raw.regions.begin(), raw.regions.end(), scene.regions[r].mesh_group);
    if (found == raw.regions.end())
      mistakes.add(scene.regions[r].place,
                   "the mesh file has no cells in a group '" + scene.regions[r].mesh_group + "'",
                   core::did_you_mean(scene.regions[r].mesh_group, raw.regions));
    else
      to_scene[found - raw.regions.begin()] = static_cast<Index>(r);
  }
  for (std::size_t g = 0; g < raw.regions.size(); ++g)
    if (to_scene[g] < 0)
      mistakes.add(
          scene.mesh.place, "no region of the scene takes the mesh file's group '" + raw.regions[g] + "'",
          "give it a material: geometry = { name = MeshGroup { \"" + raw.regions[g] + "\", material = … } }");
  if (!mistakes.empty()) return;
  for (Index& region : raw.cell_region) region = to_scene[region];
  raw.regions.clear();
  for (const auto& region : scene.regions) raw.regions.push_back(region.name);
}

/// The first cell that the element cannot take.
void check_cells(const model::Model& model, const model::Scene& scene, core::Mistakes& mistakes) {
  std::vector<geometry::Point> corners;
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    model.mesh.corners(cell, corners);
    const std::string why = model.element->refuses(model.cell(corners));
    if (why.empty()) continue;
    const geometry::Point at = geometry::centroid(corners);
    mistakes.add(scene.element.place,
                 why + "; the cell at (" + core::format_quantity(at.x, {1, 0, 0}) + ", " +
                     core::format_quantity(at.y, {1, 0, 0}) + ") has " + std::to_string(corners.size()) +
                     " corners",
                 "element = \"vem\" takes any polygon");
    return;
  }
}

}  // namespace

namespace {

std::vector<mesh::JointLine> joint_lines(const model::Scene& scene) {
  std::vector<mesh::JointLine> lines;
  for (const auto& joint : scene.joints) lines.push_back(joint.line);
  return lines;
}

/// One domain for each group of bodies that are meshed together.
std::vector<mesh::Domain> build_domains(const model::Scene& scene, core::Mistakes& mistakes) {
  std::vector<mesh::RegionShape> shapes;
  double length = 0;
  bool arcs = false;
  for (const auto& region : scene.regions) {
    if (!region.mesh_group.empty()) continue;
    shapes.push_back({region.name, region.shape, region.place});
    length = std::max(length, shape_length(region.shape));
    arcs = arcs || has_arcs(region.shape);
  }
  // Chords of arcs are as long as cells, so that refining the mesh refines the arcs with it.
  const double chord = std::min(cell_size(scene, length * length / 2).value_or(length / 50), length / 4);
  std::vector<mesh::Domain> domains = mesh::make_domains(shapes, joint_lines(scene), chord, mistakes);
  if (arcs)
    core::log().info("arcs are drawn with chords of at most " + core::format_quantity(chord, {1, 0, 0}) +
                     " and 7.5°: smaller cells follow them closer");
  for (mesh::Domain& domain : domains)
    for (const auto& probe : scene.probes) domain.named_points[probe.name] = probe.at;
  return domains;
}

/// A wished number of cells is that of all bodies: each has its share by area.
core::Settings share_of(core::Settings settings, double share) {
  for (auto& entry : settings.entries)
    if (const core::Quantity* number = entry.value.quantity(); entry.key == "cells" && number)
      entry.value = core::make_value(std::max(1.0, std::round(number->value * share)), entry.value.place);
  return settings;
}

/// The mesh of one body among several: what goes wrong is said of it.
mesh::RawMesh generate_part(const std::function<mesh::GenerateMesh>& generate, const mesh::Domain& domain,
                            const core::Settings& settings) {
  try {
    return generate(domain, settings);
  } catch (const core::InputError& error) {
    std::vector<core::Mistake> mistakes = error.mistakes();
    for (auto& mistake : mistakes)
      mistake.what = "'" + domain.regions.front() + "', meshed by itself: " + mistake.what;
    throw core::InputError(std::move(mistakes));
  }
}

mesh::Mesh build_mesh(const model::Scene& scene, const std::vector<mesh::Domain>& domains,
                      core::Registry& registry, core::Mistakes& mistakes) {
  const auto timing = core::ledger().time("mesh");
  const auto generate = registry.make<mesh::GenerateMesh>("mesh", scene.mesh.name);
  if (domains.size() == 1) {
    mesh::RawMesh raw = generate(domains.front(), scene.mesh);
    if (!raw.regions.empty()) name_file_regions(scene, raw, mistakes);
    return mistakes.empty() ? mesh::build_mesh(std::move(raw), domains.front()) : mesh::Mesh{};
  }
  double area = 0;
  for (const mesh::Domain& domain : domains) area += domain.area();
  std::vector<mesh::Mesh> parts;
  for (const mesh::Domain& domain : domains) {
    const core::Settings settings = share_of(scene.mesh, domain.area() / area);
    parts.push_back(mesh::build_mesh(generate_part(generate, domain, settings), domain));
  }
  std::vector<std::string> regions;
  for (const auto& region : scene.regions) regions.push_back(region.name);
  return mesh::merge(std::move(parts), regions);
}

void check_axis(const mesh::Mesh& mesh, double length, const model::Scene& scene, core::Mistakes& mistakes) {
  if (std::ranges::all_of(mesh.points, [&](geometry::Point p) { return p.x >= -1e-9 * length; })) return;
  mistakes.add(scene.mesh.place, "the mesh crosses the axis of revolution x = 0",
               "an axisymmetric mesh is a half section with x >= 0");
}

}  // namespace

mesh::Domain build_domain(const model::Scene& scene, core::Mistakes& mistakes) {
  return mesh::together(build_domains(scene, mistakes));
}

std::vector<std::shared_ptr<const model::Material>> build_materials(const model::Scene& scene,
                                                                    core::Registry& registry,
                                                                    core::Mistakes& mistakes) {
  std::vector<std::shared_ptr<const model::Material>> materials;
  for (const auto& region : scene.regions) {
    const core::Registry::Entry* law = registry.find("material", region.material.name);
    if (!law || !region.material.complete(law->schema)) {  // reported when the scene was read
      materials.push_back(nullptr);
      continue;
    }
    const auto make = registry.make<model::MakeMaterial>("material", region.material.name);
    materials.push_back(make(region.material, model::law_plane(scene.plane), mistakes));
  }
  return materials;
}

model::Model build_model(const model::Scene& scene, const model::Effects& effects, core::Registry& registry,
                         core::Mistakes& mistakes) {
  model::Model built;
  built.plane = scene.plane;
  built.thickness = scene.thickness;
  built.materials = build_materials(scene, registry, mistakes);
  const bool yielding =
      std::ranges::any_of(built.materials, [](const auto& law) { return law && !law->linear(); });
  built.element = registry.make<model::MakeElement>("element", scene.element.name)(
      scene.element, {scene.order, scene.plane, yielding}, mistakes);
  const std::vector<mesh::Domain> domains = build_domains(scene, mistakes);
  if (!mistakes.empty()) return built;
  built.mesh = build_mesh(scene, domains, registry, mistakes);
  if (!mistakes.empty()) return built;
  mesh::add_face_joints(built.mesh, joint_lines(scene));
  mesh::require_lines_apart(built.mesh, joint_lines(scene));
  for (const auto& [name, effect] : effects) effect->shape_mesh(scene, built.mesh, mistakes);
  if (built.axisymmetric()) check_axis(built.mesh, mesh::together(domains).length, scene, mistakes);
  if (!mistakes.empty()) return built;
  check_cells(built, scene, mistakes);
  const model::NodeCounts nodes = built.element->nodes();
  built.dofs =
      fields::DofMap(built.mesh, {"displacement", "m", 2, nodes.per_point, nodes.per_edge, nodes.per_cell});
  const auto [x_low, x_high] = std::minmax_element(built.mesh.points.begin(), built.mesh.points.end(),
                                                   [](auto a, auto b) { return a.x < b.x; });
  const auto [y_low, y_high] = std::minmax_element(built.mesh.points.begin(), built.mesh.points.end(),
                                                   [](auto a, auto b) { return a.y < b.y; });
  built.length = std::hypot(x_high->x - x_low->x, y_high->y - y_low->y);
  built.sections = section_lines(scene, built, mistakes);
  return built;
}

}  // namespace ashlar::solve
