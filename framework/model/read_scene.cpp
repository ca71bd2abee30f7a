// The script's table → Scene, with every mistake that shows without a mesh.

#include <algorithm>

#include "model/read_sections.hpp"
#include "model/read_shape.hpp"
#include "model/read_stages.hpp"
#include "model/scene.hpp"
#include "model/scene_names.hpp"

namespace ashlar::model {

namespace {

using core::Mistakes;
using core::Settings;

// Map entries with their objects; `place` is the entry's own, also where its object is missing.
void check_entry_names(const Settings::Entry& entry, Mistakes& mistakes) {
  const core::Table* table = entry.value.table();
  if (!table) return;
  for (const auto& [name, value] : table->entries) {
    const std::string why = bad_name(name);
    if (!why.empty()) mistakes.add(value.place, why);
  }
}

std::vector<RegionData> read_regions(const Settings& root, const core::Registry& registry,
                                     Mistakes& mistakes) {
  std::vector<RegionData> regions;
  const Settings::Entry& geometry = root.entry("geometry");
  check_entry_names(geometry, mistakes);
  bool drawn = false, groups = false;
  for (const auto& [name, settings] : geometry.objects) {
    RegionData region;
    region.name = name;
    region.place = settings.place;
    region.shape = read_shape(settings, registry, mistakes);
    const bool group = settings.name == "mesh_group";
    (group ? groups : drawn) = true;
    if (group) {
      const std::string* word = settings.items.empty() ? nullptr : settings.items[0].text();
      region.mesh_group = word ? *word : name;
    }
    if (settings.entry("material").object)
      region.material = settings.object("material");
    else if (!settings.said("material"))
      mistakes.add({region.place.file, region.place.line, region.place.path + ".material"},
                   "is missing: what the region is made of",
                   core::did_you_mean("", registry.names("material")));
    regions.push_back(std::move(region));
  }
  if (geometry.said && geometry.value.table() && geometry.value.table()->entries.empty())
    mistakes.add(geometry.value.place, "needs at least one region");
  if (drawn && groups)
    mistakes.add(root.place_of("geometry"), "drawn regions and groups of a mesh file cannot be mixed");
  return regions;
}

std::vector<std::string> texts(const core::Value& list) {
  std::vector<std::string> words;
  if (const core::Table* table = list.table())
    for (const core::Value& item : table->items)
      if (item.text()) words.push_back(*item.text());
  return words;
}

void read_path(const Settings& joint, mesh::JointLine& line, Mistakes& mistakes) {
  const core::Table* path = joint.value("path").table();
  if (!path) return;
  for (const core::Value& item : path->items) {
    if (item.is_nothing()) return;  // reported by its schema
    const auto point = core::read_point(item, {1, 0, 0}, mistakes);
    if (!point) return;
    const Point p{point->first, point->second};
    if (!line.path.empty() && line.path.back() == p)
      mistakes.add(item.place, "two neighbouring points of the path coincide");
    line.path.push_back(p);
  }
  if (line.path.size() < 2)
    mistakes.add(joint.place_of("path"), "needs at least 2 points, got " + std::to_string(line.path.size()));
}

// The words of a list that must have two entries; nothing if it has not.
std::vector<std::string> pair_of(const Settings& joint, const std::string& key, Mistakes& mistakes) {
  std::vector<std::string> words = texts(joint.value(key));
  if (words.size() == 2 && (words[0] != words[1] || key == "ends")) return words;
  if (joint.said(key) && joint.has(key))
    mistakes.add(joint.place_of(key), words.size() == 2
                                          ? "must be two different names"
                                          : "needs 2 entries, got " + std::to_string(words.size()));
  return {};
}

// "disc.rim" → "disc"; edge groups of a mesh file may have no region in their names.
std::string region_of(const std::string& edge) {
  return edge.substr(0, edge.find('.'));
}

// Words that name no edge at all are reported where all names are.
void check_faces(const Settings& joint, const mesh::JointLine& line, const std::vector<RegionData>& regions,
                 Mistakes& mistakes) {
  if (line.faces.empty()) return;
  const core::Place place = joint.place_of("faces");
  if (joint.said("ends"))
    mistakes.add(joint.place_of("ends"), "bodies that are meshed apart have no ends to weld", "leave it out");
  const bool drawn = std::ranges::all_of(regions, &std::string::empty, &RegionData::mesh_group);
  if (!drawn) return;
  const std::array<std::string, 2> bodies = {region_of(line.faces[0]), region_of(line.faces[1])};
  if (bodies[0] == bodies[1])
    mistakes.add(place, "both edges belong to region '" + bodies[0] + "'",
                 "give edges of two regions, or use `path` inside one");
  for (const std::string& face : line.faces)
    if (std::ranges::find(regions, region_of(face), &RegionData::name) == regions.end())
      mistakes.add(place, "'" + face + "' is no edge of a region", "give two edges as region.edge");
}

JointData read_joint(const std::string& name, const Settings& joint, const std::vector<RegionData>& regions,
                     Mistakes& mistakes) {
  JointData data{{}, joint};
  mesh::JointLine& line = data.line;
  line.name = name;
  line.place = joint.place;
  read_path(joint, line, mistakes);
  line.between = pair_of(joint, "between", mistakes);
  line.faces = pair_of(joint, "faces", mistakes);
  check_faces(joint, line, regions, mistakes);
  std::vector<std::string> sides = pair_of(joint, "sides", mistakes);
  if (sides.empty()) sides = line.between;
  if (sides.empty() && !line.faces.empty()) sides = {region_of(line.faces[0]), region_of(line.faces[1])};
  if (!sides.empty()) line.sides = {sides[0], sides[1]};
  for (const std::string& side : line.sides) {
    const std::string why = bad_name(side);
    if (!why.empty()) mistakes.add(joint.place_of("sides"), why);
  }
  const std::vector<std::string> ends = pair_of(joint, "ends", mistakes);
  if (!ends.empty()) line.weld = {ends[0] == "welded", ends[1] == "welded"};
  return data;
}

std::vector<JointData> read_joints(const Settings& root, const std::vector<RegionData>& regions,
                                   Mistakes& mistakes) {
  std::vector<JointData> joints;
  check_entry_names(root.entry("joints"), mistakes);
  for (const auto& [name, settings] : root.objects("joints")) {
    for (const RegionData& region : regions)
      if (region.name == name)
        mistakes.add(settings.place,
                     "a region is called '" + name + "' already; joints need their own names");
    joints.push_back(read_joint(name, settings, regions, mistakes));
  }
  return joints;
}

std::vector<ProbeData> read_probes(const Settings& root, Mistakes& mistakes) {
  std::vector<ProbeData> probes;
  if (!root.entry("outputs").object) return probes;
  const Settings::Entry& entry = root.object("outputs").entry("probes");
  check_entry_names(entry, mistakes);
  for (const auto& [name, settings] : entry.objects) {
    ProbeData probe;
    probe.name = name;
    probe.place = settings.place;
    probe.lip = settings.text("lip");
    if (settings.has("at")) {
      const auto [x, y] = settings.point("at");
      probe.at = {x, y};
    }
    for (const auto& [number, field] : settings.objects("")) probe.quantities.push_back(field.name);
    if (probe.quantities.empty()) probe.quantities = {"displacement"};
    probes.push_back(std::move(probe));
  }
  return probes;
}

// What a schema cannot say of a size by region, which mesh::SizeField reads.
void check_sizes(const Scene& scene, Mistakes& mistakes) {
  const Settings::Entry* size = scene.mesh.find("size");
  const core::Table* table = size ? size->value.table() : nullptr;
  for (const RegionData& region : scene.regions)
    if (table && !table->find(region.name))
      mistakes.add(size->value.place, "region '" + region.name + "' has no size",
                   "give one for every region");
}

// Materials do not count: regions can be arranged whatever they are made of.
bool any_mistake_in(const std::string& part, const Mistakes& mistakes) {
  return std::any_of(mistakes.list().begin(), mistakes.list().end(), [&](const core::Mistake& mistake) {
    const std::string& path = mistake.place.path;
    return path.starts_with(part) && path.find(".material") == std::string::npos;
  });
}

// Parts that hold an undefined value are not whole, although their own place holds no mistake.
bool is_whole_joint(const JointData& joint) {
  const core::Table* path = joint.settings.value("path").table();
  return path ? joint.line.path.size() == path->items.size()
              : joint.line.between.size() == 2 || joint.line.faces.size() == 2;
}

bool can_be_arranged(const Scene& scene, const Mistakes& mistakes) {
  const auto whole = [](const RegionData& region) {
    return !region.mesh_group.empty() || is_whole(region.shape);
  };
  return std::all_of(scene.regions.begin(), scene.regions.end(), whole) &&
         std::all_of(scene.joints.begin(), scene.joints.end(),
                     [](const JointData& joint) { return is_whole_joint(joint); }) &&
         !any_mistake_in("geometry", mistakes) && !any_mistake_in("joints", mistakes);
}

// A kind of which only one entry exists need not be said.
Settings chosen(const std::string& kind, Settings& root, core::Registry& registry, Mistakes& mistakes) {
  for (Settings::Entry& entry : root.entries) {
    if (entry.key != kind || entry.said) continue;
    const std::vector<std::string> names = registry.names(kind);
    const auto usual = std::ranges::find_if(
        names, [&](const std::string& name) { return registry.find(kind, name)->schema.usual; });
    if (names.size() != 1 && usual == names.end()) {
      mistakes.add({root.place.file, root.place.line, kind}, "is missing: which " + kind + "?",
                   names.empty() ? "no module provides one: is the modules folder complete?"
                                 : core::did_you_mean("", names));
      return {};
    }
    const std::string& name = usual != names.end() ? *usual : names.front();
    entry.value = core::make_value(name, {root.place.file, root.place.line, kind});
    entry.object = std::make_shared<const Settings>(
        core::check(entry.value, registry.find(kind, name)->schema, registry, mistakes));
  }
  return root.entry(kind).object ? root.object(kind) : Settings{};
}

}  // namespace

const RegionData* Scene::find_region(const std::string& name) const {
  for (const RegionData& region : regions)
    if (region.name == name) return &region;
  return nullptr;
}

Scene read_scene(const core::Value& value, core::Registry& registry, Mistakes& mistakes) {
  Scene scene;
  const core::Schema& schema = registry.find("scene", "scene")->schema;
  scene.root = core::check(without_ends(value, registry), schema, registry, mistakes);
  Settings& root = scene.root;
  scene.title = root.text("title");
  const std::string plane = root.text("plane");
  scene.plane = plane == "stress"         ? Plane::stress
                : plane == "axisymmetric" ? Plane::axisymmetric
                                          : Plane::strain;
  scene.thickness = root.number("thickness", 1);
  if (scene.plane == Plane::axisymmetric && root.said("thickness"))
    mistakes.add(root.place_of("thickness"), "a body of revolution has no thickness", "leave it out");
  scene.order = static_cast<int>(root.number("order", 1));
  if (root.entry("mesh").object) scene.mesh = root.object("mesh");
  scene.element = chosen("element", root, registry, mistakes);
  scene.solver = chosen("solver", root, registry, mistakes);
  if (root.entry("outputs").object) scene.outputs = root.object("outputs");
  const std::size_t before = mistakes.list().size();
  scene.regions = read_regions(root, registry, mistakes);
  const core::Table* geometry = root.value("geometry").table();
  // Edges of a region that could not be read cannot be missed either.
  const bool complete =
      geometry && geometry->entries.size() == scene.regions.size() && mistakes.list().size() == before;
  scene.joints = read_joints(root, scene.regions, mistakes);
  scene.stages = read_stage_names(root, mistakes);
  scene.probes = read_probes(root, mistakes);
  if (root.entry("outputs").object) {
    check_entry_names(scene.outputs.entry("sections"), mistakes);
    scene.sections = read_sections(scene.outputs, mistakes);
  }
  check_sizes(scene, mistakes);
  Names names = collect_names(scene);
  names.edges_unknown = names.edges_unknown || !complete || any_mistake_in("geometry", mistakes);
  names.known["picture"] = picture_words(registry);
  read_stages(value, root, names, scene.stages, mistakes);
  check_names(root, registry, names, mistakes);
  scene.drawn = complete && can_be_arranged(scene, mistakes);
  return scene;
}

}  // namespace ashlar::model
