#pragma once
// What a mesh file says, before it is judged.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "meshing_file/cursor.hpp"

namespace ashlar::meshing_file {

using geometry::Index;
using geometry::Point;

struct Contents {
  std::vector<std::array<double, 3>> points;
  std::vector<std::size_t> point_at;    ///< where in the file, for messages
  mesh::Adjacency cells;                ///< into `points`, in range
  std::vector<std::string> cell_group;  ///< region names
  std::vector<std::size_t> cell_at;
  std::map<std::string, std::vector<std::array<Index, 2>>> edges;
  std::map<std::string, std::vector<Index>> point_groups;
};

constexpr const char* unnamed_region = "mesh";

Contents read_msh(Cursor& cursor);
Contents read_vtk(Cursor& cursor);
Contents read_vtu(Cursor& cursor, std::string_view text);

/// Corners of a linear VTK cell in order around it; empty for cells that are no faces (points, lines).
/// Fails at cells that are not linear or not plane.
std::vector<Index> vtk_corners(std::int64_t type, std::vector<Index> points, const Cursor& cursor);

/// Judges the contents: finite plane points, simple cells with area, turned counter-clockwise, equal points
/// merged, no overlaps, named edges that exist.
mesh::RawMesh finish(Contents contents, const Cursor& cursor);

}  // namespace ashlar::meshing_file
