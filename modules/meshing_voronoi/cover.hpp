#pragma once
// Where interior sites may go: a quadtree over the domain, cut as fine as the wished size, that knows its
// balls, its faces and the number of cells that fit (∫ 1/h²).

#include <cstdint>

#include "border.hpp"

namespace ashlar::meshing_voronoi {

/// Finds the face of a point by a ray; segments are kept in horizontal bands.
class FaceLocator {
 public:
  explicit FaceLocator(const mesh::Domain& domain);
  /// -1 outside every region.
  Index at(Point p) const;

 private:
  const mesh::Domain& domain_;
  double low_ = 0, step_ = 1;
  std::vector<std::vector<Index>> bands_;
};

class Cover {
 public:
  Cover(const mesh::Domain& domain, const mesh::SizeField& sizes, const Border& border);

  /// ∫ 1/h² over all faces: the number of cells of the wished size.
  double cells() const { return cells_; }
  const std::vector<Ball>& balls() const { return balls_; }
  /// The ball that p is in (or nearly touches), or -1.
  Index ball_at(Point p) const;
  /// `count` sites spread by 1/h² outside all balls, in the order of a Hilbert curve.
  std::vector<Site> sample(Index count, std::uint64_t seed) const;

 private:
  struct Node {
    Index child = -1;
    Index begin = 0, end = 0;  ///< balls of a leaf
  };
  struct Leaf {
    Point center;
    double half = 0;
    double mass = 0;  ///< up to and with this leaf
    Index node = -1;
    Index face = -1;  ///< -1: differs inside the leaf
  };
  struct Turn;  ///< how the Hilbert curve runs through a node
  void build(Index node, Point center, double half, const std::vector<Index>& balls, Turn turn);
  void add_leaf(Index node, Point center, double half, const std::vector<Index>& balls);
  double size_at(Point p, Index face) const;
  bool near_balls(const Node& node, Point p) const;

  const mesh::Domain& domain_;
  const mesh::SizeField& sizes_;
  const std::vector<Ball>& balls_;
  FaceLocator locator_;
  Point center_;
  double half_ = 0;
  double cells_ = 0, mass_ = 0;
  std::vector<Node> nodes_;
  std::vector<Index> lists_;
  std::vector<Leaf> leaves_;
};

}  // namespace ashlar::meshing_voronoi
