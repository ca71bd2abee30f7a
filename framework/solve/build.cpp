#include "solve/build.hpp"

#include <algorithm>
#include <cmath>

#include "core/ledger.hpp"
#include "mesh/generator.hpp"

namespace ashlar::solve {

using geometry::Index;

namespace {

/// Chords of arcs: as long as the mesh's cells where the scene gives one size, else a fiftieth of the scene.
double arc_chord(const model::Scene& scene, double length) {
  const double coarse = length / 50;
  for (const auto& entry : scene.mesh.entries)
    if (entry.key == "size")
      if (const core::Quantity* size = entry.value.quantity()) return std::min(size->value, coarse);
  return coarse;
}

double shape_length(const geometry::Shape& shape) {
  double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
  const auto visit = [&](const auto& self, const geometry::Shape& part) -> void {
    for (const auto& ring : part.rings)
      for (const auto& edge : ring) {
        low_x = std::min(low_x, edge.start.x), high_x = std::max(high_x, edge.start.x);
        low_y = std::min(low_y, edge.start.y), high_y = std::max(high_y, edge.start.y);
      }
    for (const auto& operand : part.operands) self(self, operand);
  };
  visit(visit, shape);
  return std::max(0.0, std::hypot(high_x - low_x, high_y - low_y));
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

}  // namespace

mesh::Domain build_domain(const model::Scene& scene, core::Mistakes& mistakes) {
  std::vector<mesh::RegionShape> shapes;
  double length = 0;
  for (const auto& region : scene.regions) {
    if (!region.mesh_group.empty()) continue;
    shapes.push_back({region.name, region.shape, region.place});
    length = std::max(length, shape_length(region.shape));
  }
  std::vector<mesh::JointLine> joints;
  for (const auto& joint : scene.joints) joints.push_back(joint.line);
  mesh::Domain domain = mesh::make_domain(shapes, joints, arc_chord(scene, length), mistakes);
  for (const auto& probe : scene.probes) domain.named_points[probe.name] = probe.at;
  return domain;
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
    materials.push_back(make(region.material, scene.plane, mistakes));
  }
  return materials;
}

model::Model build_model(const model::Scene& scene, core::Registry& registry, core::Mistakes& mistakes) {
  model::Model built;
  built.plane = scene.plane;
  built.thickness = scene.thickness;
  built.materials = build_materials(scene, registry, mistakes);
  built.element =
      registry.make<model::MakeElement>("element", scene.element.name)(scene.element, scene.order, mistakes);
  const mesh::Domain domain = build_domain(scene, mistakes);
  if (!mistakes.empty()) return built;

  {
    const auto timing = core::ledger().time("mesh");
    const auto generate = registry.make<mesh::GenerateMesh>("mesh", scene.mesh.name);
    mesh::RawMesh raw = generate(domain, scene.mesh);
    if (!raw.regions.empty()) name_file_regions(scene, raw, mistakes);
    if (!mistakes.empty()) return built;
    built.mesh = mesh::build_mesh(std::move(raw), domain);
  }
  const model::NodeCounts nodes = built.element->nodes();
  built.dofs =
      fields::DofMap(built.mesh, {"displacement", "m", 2, nodes.per_point, nodes.per_edge, nodes.per_cell});
  const auto [x_low, x_high] = std::minmax_element(built.mesh.points.begin(), built.mesh.points.end(),
                                                   [](auto a, auto b) { return a.x < b.x; });
  const auto [y_low, y_high] = std::minmax_element(built.mesh.points.begin(), built.mesh.points.end(),
                                                   [](auto a, auto b) { return a.y < b.y; });
  built.length = std::hypot(x_high->x - x_low->x, y_high->y - y_low->y);
  return built;
}

}  // namespace ashlar::solve
