#pragma once
// The parts that gmsh's formats 2.2 and 4.1, text and binary, have in common.

#include <unordered_map>

#include "meshing_file/contents.hpp"

namespace ashlar::meshing_file {

/// Names of physical groups: by dimension and number.
class MshGroups {
 public:
  void name(int dimension, std::int64_t tag, std::string text) { names_[{dimension, tag}] = std::move(text); }
  void add_entity(int dimension, std::int64_t entity, std::vector<std::int64_t> physical) {
    entities_[{dimension, entity}] = std::move(physical);
  }
  std::string name_of(int dimension, std::int64_t tag) const;
  /// Groups of an entity of format 4.1.
  std::vector<std::int64_t> groups_of(int dimension, std::int64_t entity) const;

 private:
  std::map<std::pair<int, std::int64_t>, std::string> names_;
  std::map<std::pair<int, std::int64_t>, std::vector<std::int64_t>> entities_;
};

/// Collects nodes and elements of either format.
class MshContents {
 public:
  explicit MshContents(Cursor& cursor) : cursor_(cursor) {}
  MshGroups groups;

  void add_node(std::int64_t tag, std::array<double, 3> x, std::size_t at);
  /// Corners of an element type; fails for types that are not linear points, lines, triangles or
  /// quadrilaterals.
  std::size_t corner_count(std::int64_t type, std::size_t at) const;
  /// `nodes` are tags; groups of physical tags.
  void add_element(std::int64_t type, const std::vector<std::int64_t>& groups,
                   const std::vector<std::int64_t>& nodes, std::size_t at);
  Contents take() { return std::move(contents_); }

 private:
  Cursor& cursor_;
  Contents contents_;
  std::unordered_map<std::int64_t, Index> node_;
};

void read_msh2_binary_nodes(Cursor& cursor, MshContents& mesh);
void read_msh2_binary_elements(Cursor& cursor, MshContents& mesh);
void read_msh4_binary_entities(Cursor& cursor, MshContents& mesh);
void read_msh4_binary_nodes(Cursor& cursor, MshContents& mesh);
void read_msh4_binary_elements(Cursor& cursor, MshContents& mesh);

}  // namespace ashlar::meshing_file
