#include "meshing_file/msh.hpp"

#include <cstdlib>
#include <limits>

namespace ashlar::meshing_file {

std::string MshGroups::name_of(int dimension, std::int64_t tag) const {
  const auto found = names_.find({dimension, tag});
  return found == names_.end() ? std::to_string(tag) : found->second;
}

std::vector<std::int64_t> MshGroups::groups_of(int dimension, std::int64_t entity) const {
  const auto found = entities_.find({dimension, entity});
  return found == entities_.end() ? std::vector<std::int64_t>{} : found->second;
}

void MshContents::add_node(std::int64_t tag, std::array<double, 3> x, std::size_t at) {
  if (!node_.emplace(tag, static_cast<Index>(contents_.points.size())).second) {
    cursor_.fail_at(at, "node " + std::to_string(tag) + " is there twice");
  }
  contents_.points.push_back(x);
  contents_.point_at.push_back(at);
}

std::size_t MshContents::corner_count(std::int64_t type, std::size_t at) const {
  switch (type) {
    case 15:
      return 1;
    case 1:
      return 2;
    case 2:
      return 3;
    case 3:
      return 4;
    default:
      break;
  }
  const bool solid = type == 4 || type == 5 || type == 6 || type == 7;
  cursor_.fail_at(at, solid
                          ? "element type " + std::to_string(type) + " is a solid: only plane meshes are read"
                          : "element type " + std::to_string(type) +
                                " is not read: only linear triangles, quadrilaterals, lines and points are");
}

void MshContents::add_element(std::int64_t type, const std::vector<std::int64_t>& physical,
                              const std::vector<std::int64_t>& nodes, std::size_t at) {
  std::vector<Index> points;
  for (const std::int64_t tag : nodes) {
    const auto found = node_.find(tag);
    if (found == node_.end())
      cursor_.fail_at(at, "an element has node " + std::to_string(tag) + ", which is not there");
    points.push_back(found->second);
  }
  if (type == 2 || type == 3) {
    contents_.cells.append(points);
    contents_.cell_group.push_back(physical.empty() ? unnamed_region : groups.name_of(2, physical.front()));
    contents_.cell_at.push_back(at);
  }
  for (const std::int64_t tag : physical) {
    if (type == 1) contents_.edges[groups.name_of(1, tag)].push_back({points[0], points[1]});
    if (type == 15) contents_.point_groups[groups.name_of(0, tag)].push_back(points[0]);
  }
}

namespace {

// gmsh writes a group's number negative where its entity is turned around; 0 is no group.
std::vector<std::int64_t> group_tags(std::int64_t tag) {
  if (tag == 0 || tag == std::numeric_limits<std::int64_t>::min()) return {};
  return {std::abs(tag)};
}

void read_names(Cursor& cursor, MshContents& mesh) {
  const std::size_t count = cursor.count(cursor.integer(), 6);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t dimension = cursor.integer(), tag = cursor.integer();
    if (dimension < 0 || dimension > 3) cursor.fail("a group's dimension must be 0 to 3");
    mesh.groups.name(static_cast<int>(dimension), tag, cursor.quoted());
  }
}

void read_msh2_nodes(Cursor& cursor, MshContents& mesh) {
  const std::size_t count = cursor.count(cursor.integer(), 8);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t tag = cursor.integer();
    const std::size_t at = cursor.position();
    const double x = cursor.real(), y = cursor.real(), z = cursor.real();
    mesh.add_node(tag, {x, y, z}, at);
  }
}

void read_msh2_elements(Cursor& cursor, MshContents& mesh) {
  const std::size_t count = cursor.count(cursor.integer(), 6);
  std::vector<std::int64_t> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    cursor.integer();  // the element's own number
    const std::size_t at = cursor.position();
    const std::int64_t type = cursor.integer();
    const std::size_t tags = cursor.count(cursor.integer(), 2);
    std::int64_t physical = 0;
    for (std::size_t k = 0; k < tags; ++k) {
      const std::int64_t tag = cursor.integer();
      if (k == 0) physical = tag;
    }
    nodes.resize(mesh.corner_count(type, at));
    for (auto& node : nodes) node = cursor.integer();
    mesh.add_element(type, group_tags(physical), nodes, at);
  }
}

void read_msh4_entities(Cursor& cursor, MshContents& mesh) {
  std::array<std::size_t, 4> counts{};
  for (auto& count : counts) count = cursor.count(cursor.integer(), 8);
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const std::int64_t entity = cursor.integer();
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) cursor.real();
      std::vector<std::int64_t> physical;
      const std::size_t groups = cursor.count(cursor.integer(), 2);
      for (std::size_t k = 0; k < groups; ++k) {
        for (const auto tag : group_tags(cursor.integer())) physical.push_back(tag);
      }
      const std::size_t borders = dimension == 0 ? 0 : cursor.count(cursor.integer(), 2);
      for (std::size_t k = 0; k < borders; ++k) cursor.integer();
      mesh.groups.add_entity(dimension, entity, std::move(physical));
    }
  }
}

int entity_dimension(Cursor& cursor) {
  const std::int64_t dimension = cursor.integer();
  if (dimension < 0 || dimension > 3) cursor.fail("an entity's dimension must be 0 to 3");
  return static_cast<int>(dimension);
}

void read_msh4_nodes(Cursor& cursor, MshContents& mesh) {
  const std::size_t blocks = cursor.count(cursor.integer(), 8);
  for (int k = 0; k < 3; ++k) cursor.integer();
  std::vector<std::int64_t> tags;
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dimension = entity_dimension(cursor);
    cursor.integer();
    const bool parametric = cursor.integer() != 0;
    tags.resize(cursor.count(cursor.integer(), 8));
    for (auto& tag : tags) tag = cursor.integer();
    for (const std::int64_t tag : tags) {
      const std::size_t at = cursor.position();
      const double x = cursor.real(), y = cursor.real(), z = cursor.real();
      for (int k = 0; parametric && k < dimension; ++k) cursor.real();
      mesh.add_node(tag, {x, y, z}, at);
    }
  }
}

void read_msh4_elements(Cursor& cursor, MshContents& mesh) {
  const std::size_t blocks = cursor.count(cursor.integer(), 8);
  for (int k = 0; k < 3; ++k) cursor.integer();
  std::vector<std::int64_t> nodes;
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dimension = entity_dimension(cursor);
    const auto physical = mesh.groups.groups_of(dimension, cursor.integer());
    const std::int64_t type = cursor.integer();
    nodes.resize(mesh.corner_count(type, cursor.position()));
    const std::size_t count = cursor.count(cursor.integer(), 4);
    for (std::size_t i = 0; i < count; ++i) {
      cursor.integer();
      const std::size_t at = cursor.position();
      for (auto& node : nodes) node = cursor.integer();
      mesh.add_element(type, physical, nodes, at);
    }
  }
}

struct Format {
  int version = 0;  // 2 or 4
  bool binary = false;
};

Format read_format(Cursor& cursor) {
  const double version = cursor.real();
  Format format;
  if (version >= 2 && version < 3) format.version = 2;
  if (version >= 4.1 && version < 5) format.version = 4;
  if (format.version == 0) cursor.fail("this version of the format is not read: only 2.2 and 4.1 are");
  format.binary = cursor.integer() != 0;
  const std::int64_t size = cursor.integer();
  cursor.line();
  if (!format.binary) return format;
  if (size != 8)
    cursor.fail("binary files must have a data size of 8 bytes, this one has " + std::to_string(size));
  if (cursor.raw<std::int32_t>() != 1)
    cursor.fail("the file was written on a machine with another order of bytes");
  return format;
}

using Read = void (*)(Cursor&, MshContents&);

Read reader_of(const std::string& section, const Format& format) {
  const bool two = format.version == 2;
  if (section == "$PhysicalNames") return read_names;
  if (section == "$Entities")
    return two ? nullptr : format.binary ? read_msh4_binary_entities : read_msh4_entities;
  if (section == "$Nodes") {
    if (two) return format.binary ? read_msh2_binary_nodes : read_msh2_nodes;
    return format.binary ? read_msh4_binary_nodes : read_msh4_nodes;
  }
  if (section == "$Elements") {
    if (two) return format.binary ? read_msh2_binary_elements : read_msh2_elements;
    return format.binary ? read_msh4_binary_elements : read_msh4_elements;
  }
  return nullptr;
}

}  // namespace

Contents read_msh(Cursor& cursor) {
  if (cursor.at_end() || cursor.word() != "$MeshFormat")
    cursor.fail("this is no gmsh file: $MeshFormat is missing");
  const Format format = read_format(cursor);
  cursor.skip_behind("$EndMeshFormat");
  MshContents mesh(cursor);
  bool nodes = false, elements = false;
  while (!cursor.at_end()) {
    const std::string section(cursor.word());
    if (!section.starts_with('$')) cursor.fail("a section such as $Nodes is expected");
    nodes |= section == "$Nodes";
    elements |= section == "$Elements";
    if (const Read read = reader_of(section, format)) {
      cursor.line();
      cursor.set_binary(format.binary && section != "$PhysicalNames");
      read(cursor, mesh);
      if (cursor.word() != "$End" + section.substr(1))
        cursor.fail("the end of section " + section + " is expected");
      cursor.set_binary(false);
    } else {
      cursor.skip_behind("$End" + section.substr(1));
    }
  }
  if (!nodes || !elements)
    cursor.fail(nodes ? "there is no section $Elements" : "there is no section $Nodes");
  return mesh.take();
}

}  // namespace ashlar::meshing_file
