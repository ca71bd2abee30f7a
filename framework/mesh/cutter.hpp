#pragma once
// The mesh while it is being cut: cells as lists that grow, and what surrounds each point.

#include <map>

#include "mesh/mesh.hpp"

namespace ashlar::mesh {

class Cutter {
 public:
  /// `tolerance`: points nearer to the path lie on it [m].
  Cutter(RawMesh& raw, double tolerance);

  /// Makes the path a chain of mesh edges. False if it leaves the mesh or a cell cannot be cut.
  bool follow(const std::vector<Point>& path);
  /// The points on this segment keep their places from now on.
  void fix(Index point) { fixed_[point] = true; }
  /// Where the last failure happened.
  Point failed_at() const { return failed_at_; }
  /// Writes cells, regions and groups back into the raw mesh.
  void finish();

 private:
  struct Box {
    Point low, high;
  };
  /// A point of the path: a mesh point, or (-1) still inside a cell.
  struct Station {
    Index point = -1;
    Point at;
  };

  // cutter.cpp: the mesh
  void fix_geometry();
  Box box_of(const std::vector<Index>& cell) const;
  std::vector<Index> cells_near(Point a, Point b, double margin) const;
  std::vector<Point> corners(Index cell) const;
  double shortest_edge_at(Index point) const;
  bool move(Index point, Point to);
  Index split_edge(Index a, Index b, Point at);
  bool has_edge(Index a, Index b) const;
  bool split_cell(Index cell, Index a, const std::vector<Index>& between, Index b);

  // cutter_path.cpp: the path
  Station locate(Point p);
  void attract(Point a, Point b);
  void cross_edges(Point a, Point b);
  std::vector<Index> points_between(const Station& a, const Station& b) const;
  Index common_cell(Index a, Index b, Point inside) const;
  Index cell_around(Point p) const;
  Index extend(Index cell, Point from, Point towards, Index avoid);
  bool visible(Index cell, Point from, Index corner) const;
  bool cut_stations(const std::vector<Station>& stations);
  bool cut_run(const Station* before, std::vector<Station> inside, const Station* after);
  bool fail(Point p);

  RawMesh& raw_;
  double tolerance_;
  std::vector<Point>& points_;
  std::vector<std::vector<Index>> cells_;
  std::vector<std::vector<Index>> point_cells_;
  std::vector<Box> boxes_;
  std::vector<bool> fixed_;
  std::map<std::array<Index, 2>, std::vector<std::string>> edge_names_;
  Point failed_at_;
};

}  // namespace ashlar::mesh
