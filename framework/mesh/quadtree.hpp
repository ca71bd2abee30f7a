#pragma once
// The way down a quadtree whose nodes keep their four children side by side: lower left, lower right, upper
// left, upper right.

#include <vector>

#include "geometry/point.hpp"

namespace ashlar::mesh {

/// Number of the leaf that p falls into. `center` and `half` are those of the root's square; a node without
/// children has `child` < 0.
template <class Node>
geometry::Index leaf_at(const std::vector<Node>& nodes, geometry::Point center, double half,
                        geometry::Point p) {
  geometry::Index node = 0;
  while (nodes[node].child >= 0) {
    half *= 0.5;
    const bool right = p.x > center.x, up = p.y > center.y;
    center = center + geometry::Point{right ? half : -half, up ? half : -half};
    node = nodes[node].child + (right ? 1 : 0) + (up ? 2 : 0);
  }
  return node;
}

}  // namespace ashlar::mesh
