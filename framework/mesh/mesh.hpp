#pragma once
// The mesh: built once, then const. Cells are simple polygons of any number of corners.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/edge_arc.hpp"

namespace ashlar::mesh {

/// One mesh edge on a joint's lip. s is the arc length along the joint's path [m]; it grows from `from` to
/// `to`. Where bodies are meshed apart, the path is the first lip itself, and s on the second lip is that of
/// the projection onto the first: see face_lips.hpp.
struct LipEdge {
  Index edge = -1;
  Index cell = -1;  ///< the one cell that it borders
  Index from = -1, to = -1;
  double s_from = 0, s_to = 0;
  /// The drawn arc that the edge is a chord of, in the sense from `from` to `to`. Where bodies are meshed
  /// apart both ends lie on it, unless cells there are too thin; otherwise they may lie on a longer chord of
  /// it.
  std::optional<EdgeArc> arc = {};
};

/// A joint in the mesh: two lips that face each other, their edges ordered by s. Both run along the path, so
/// that the first body is on the left of its lip's edges and the second on the right of its own.
struct JointLips {
  std::string name;
  std::array<std::string, 2> sides;          ///< names of the lips
  std::array<std::vector<LipEdge>, 2> lips;  ///< [0]: left of the path's direction (or first region)
  /// Lips of bodies that were meshed apart: their points do not coincide, and both have edges of their own
  /// number. Otherwise edge i of one lip lies on edge i of the other.
  bool apart = false;
  /// Points of the first and the second lip that stand opposite each other, ordered along the lips; empty
  /// before match_lips. One to one where the lips are apart; otherwise a point at a crossing may have two
  /// partners.
  std::vector<std::array<Index, 2>> pairs = {};
};

struct Mesh {
  std::vector<Point> points;
  Adjacency cell_points;                          ///< corners, counter-clockwise
  Adjacency cell_edges;                           ///< edge i joins corners i and i+1
  std::vector<std::array<Index, 2>> edge_points;  ///< in the sense of the first cell (body on the left)
  std::vector<std::array<Index, 2>> edge_cells;   ///< first cell; second cell or -1 on a border
  std::vector<std::string> regions;
  std::vector<Index> cell_region;
  /// Border edges by name ("rock.bottom", "fault.upper"). Inner borders carry both regions' names.
  std::map<std::string, std::vector<Index>> edge_groups;
  std::map<std::string, std::vector<Index>> point_groups;
  std::vector<JointLips> joints;
  /// Arcs of the drawn shapes by the edges that follow them, in the sense of edge_points.
  std::map<Index, EdgeArc> arcs;
  /// What the generator says of its work: seed, iterations, collapsed edges …
  std::vector<std::pair<std::string, std::string>> notes;

  Index cell_count() const { return cell_points.size(); }
  Index point_count() const { return static_cast<Index>(points.size()); }
  Index edge_count() const { return static_cast<Index>(edge_points.size()); }
  /// Copies a cell's corners into `corners` (resized) and returns them.
  std::span<const Point> corners(Index cell, std::vector<Point>& corners) const;
};

/// What a mesh generator returns: cells that conform to the domain, joints not yet opened.
struct RawMesh {
  std::vector<Point> points;
  Adjacency cell_points;           ///< counter-clockwise
  std::vector<Index> cell_region;  ///< into Domain::regions (file meshes: into `regions`)
  /// For meshes from files, which have no domain: their own names.
  std::vector<std::string> regions;
  std::map<std::string, std::vector<std::array<Index, 2>>> edge_groups;
  std::map<std::string, std::vector<Index>> point_groups;
  /// Facts for the mesh report: seed, iterations, collapsed edges …
  std::vector<std::pair<std::string, std::string>> notes;
};

struct Domain;

/// Edges, names and joints of a conforming raw mesh: finds the mesh edges on each domain segment, cuts cells
/// that a joint crosses (meshes that do not conform to joints), opens joints by sectors around each point,
/// and names border edges. A tip inside a region stays welded. Throws InputError if a joint cannot be
/// followed.
Mesh build_mesh(RawMesh raw, const Domain& domain);

/// The arc that an edge follows, in the edge's own sense or against it; nothing if it follows none.
std::optional<EdgeArc> arc_of(const Mesh& mesh, Index edge, bool reversed);

/// Names of all edge groups, for messages.
std::vector<std::string> edge_group_names(const Mesh& mesh);

/// Connected pieces of the mesh (cells sharing an edge): a body index for each cell. Joints separate.
std::vector<Index> bodies(const Mesh& mesh, Index& count);

/// Point nearest to `p` among the points of cells; ties: the lowest index. With `lip` ("fault.upper") only
/// points of that lip count.
Index nearest_point(const Mesh& mesh, Point p, const std::string& lip = {});

struct MeshReport {
  Index cells = 0, points = 0, edges = 0;
  double area = 0;
  double size_min = 0, size_mean = 0, size_max = 0;  ///< √area of cells [m]
  int corners_min = 0, corners_max = 0;
  double corners_mean = 0;
  double shortest_edge = 0;                      ///< [m]
  double shortest_edge_ratio = 0;                ///< over its cell's diameter, the least
  double roundness_min = 0, roundness_mean = 0;  ///< 4π area / perimeter², 1 for a disc
  Point worst_cell;                              ///< centroid of the least round cell
  std::vector<std::pair<std::string, std::string>> notes;
};
MeshReport report(const Mesh& mesh);

}  // namespace ashlar::mesh
