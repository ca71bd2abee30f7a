#include <cstdlib>

#include "meshing_file/msh.hpp"

namespace ashlar::meshing_file {

namespace {

std::int64_t size(Cursor& cursor) {
  return static_cast<std::int64_t>(cursor.raw<std::uint64_t>());
}

std::array<double, 3> coordinates(Cursor& cursor) {
  const double x = cursor.raw<double>(), y = cursor.raw<double>(), z = cursor.raw<double>();
  return {x, y, z};
}

std::int64_t positive(std::int32_t tag) {
  return std::abs(static_cast<std::int64_t>(tag));
}

int entity_dimension(Cursor& cursor) {
  const auto dimension = cursor.raw<std::int32_t>();
  if (dimension < 0 || dimension > 3) cursor.fail("an entity's dimension must be 0 to 3");
  return dimension;
}

}  // namespace

// The count of version 2 stands as text on its own line.
void read_msh2_binary_nodes(Cursor& cursor, MshContents& mesh) {
  const std::size_t count = cursor.count(cursor.integer(), 28);
  cursor.line();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = cursor.position();
    const auto tag = cursor.raw<std::int32_t>();
    mesh.add_node(tag, coordinates(cursor), at);
  }
}

void read_msh2_binary_elements(Cursor& cursor, MshContents& mesh) {
  const std::size_t count = cursor.count(cursor.integer(), 8);
  cursor.line();
  std::vector<std::int64_t> nodes;
  for (std::size_t done = 0; done < count;) {
    const std::size_t head = cursor.position();
    const auto type = cursor.raw<std::int32_t>();
    const std::size_t following = cursor.count(cursor.raw<std::int32_t>(), 8);
    const std::size_t tags = cursor.count(cursor.raw<std::int32_t>(), 4);
    nodes.resize(mesh.corner_count(type, head));
    if (following == 0 || following > count - done)
      cursor.fail_at(head, "a block's count of elements is wrong");
    for (std::size_t i = 0; i < following; ++i) {
      const std::size_t at = cursor.position();
      cursor.raw<std::int32_t>();
      std::int64_t physical = 0;
      for (std::size_t k = 0; k < tags; ++k) {
        const auto tag = positive(cursor.raw<std::int32_t>());
        if (k == 0) physical = tag;
      }
      for (auto& node : nodes) node = cursor.raw<std::int32_t>();
      mesh.add_element(
          type, physical == 0 ? std::vector<std::int64_t>{} : std::vector<std::int64_t>{physical}, nodes, at);
    }
    done += following;
  }
}

void read_msh4_binary_entities(Cursor& cursor, MshContents& mesh) {
  std::array<std::size_t, 4> counts{};
  for (auto& count : counts) count = cursor.count(size(cursor), 36);
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const auto entity = cursor.raw<std::int32_t>();
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) cursor.raw<double>();
      std::vector<std::int64_t> physical(cursor.count(size(cursor), 4));
      for (auto& tag : physical) tag = positive(cursor.raw<std::int32_t>());
      const std::size_t borders = dimension == 0 ? 0 : cursor.count(size(cursor), 4);
      for (std::size_t k = 0; k < borders; ++k) cursor.raw<std::int32_t>();
      mesh.groups.add_entity(dimension, entity, std::move(physical));
    }
  }
}

void read_msh4_binary_nodes(Cursor& cursor, MshContents& mesh) {
  const std::size_t blocks = cursor.count(size(cursor), 20);
  for (int k = 0; k < 3; ++k) size(cursor);
  std::vector<std::int64_t> tags;
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dimension = entity_dimension(cursor);
    cursor.raw<std::int32_t>();
    const bool parametric = cursor.raw<std::int32_t>() != 0;
    tags.resize(cursor.count(size(cursor), 32));
    for (auto& tag : tags) tag = size(cursor);
    for (const std::int64_t tag : tags) {
      const std::size_t at = cursor.position();
      const auto x = coordinates(cursor);
      for (int k = 0; parametric && k < dimension; ++k) cursor.raw<double>();
      mesh.add_node(tag, x, at);
    }
  }
}

void read_msh4_binary_elements(Cursor& cursor, MshContents& mesh) {
  const std::size_t blocks = cursor.count(size(cursor), 20);
  for (int k = 0; k < 3; ++k) size(cursor);
  std::vector<std::int64_t> nodes;
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dimension = entity_dimension(cursor);
    const auto physical = mesh.groups.groups_of(dimension, cursor.raw<std::int32_t>());
    const std::size_t head = cursor.position();
    const auto type = cursor.raw<std::int32_t>();
    nodes.resize(mesh.corner_count(type, head));
    const std::size_t count = cursor.count(size(cursor), 16);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = cursor.position();
      size(cursor);
      for (auto& node : nodes) node = size(cursor);
      mesh.add_element(type, physical, nodes, at);
    }
  }
}

}  // namespace ashlar::meshing_file
