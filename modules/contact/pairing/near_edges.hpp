#pragma once
// Broad phase: which edges of a lip are near a place, without asking them all.

#include <cstdint>
#include <unordered_map>

#include "mesh/mesh.hpp"

namespace ashlar::contact {

/// A grid of squares with the edges that reach into each.
class NearEdges {
 public:
  /// Keeps references to both.
  NearEdges(const std::vector<mesh::Point>& points, const std::vector<mesh::LipEdge>& edges);

  /// Numbers of all edges that may reach within `radius` of a place, ascending; some that do not may be among
  /// them.
  std::vector<std::size_t> within(mesh::Point place, double radius) const;
  /// The distance to the nearest edge; infinite if there are none.
  double nearest_distance(mesh::Point place) const;

 private:
  using Square = std::pair<std::int64_t, std::int64_t>;
  struct Hash {
    std::size_t operator()(const Square& s) const {
      return static_cast<std::size_t>(s.first * 73856093) ^ static_cast<std::size_t>(s.second * 19349663);
    }
  };
  Square square_of(mesh::Point p) const;
  /// Calls visit(edge) for those in squares from low to high; in a small grid for all of them.
  void visit(Square low, Square high, const auto& visit) const;

  const std::vector<mesh::Point>& points_;
  const std::vector<mesh::LipEdge>& edges_;
  double side_ = 1;  ///< of a square [m]
  std::unordered_map<Square, std::vector<std::size_t>, Hash> grid_;
};

}  // namespace ashlar::contact
