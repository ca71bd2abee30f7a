#pragma once
// Ordering of directed links into chains.

#include <vector>

#include "mesh/adjacency.hpp"

namespace ashlar::mesh {

struct Link {
  Index number = -1;           ///< the caller's own
  Index start = -1, end = -1;  ///< points
};

/// Links end to start. Chains without a link before them come first (by x, then y of their start), then
/// loops.
std::vector<Link> chained(std::vector<Link> links, const std::vector<Point>& points);

}  // namespace ashlar::mesh
