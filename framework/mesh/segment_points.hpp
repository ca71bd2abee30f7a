#pragma once
// Which mesh points lie on which segments of the domain.

#include <vector>

#include "mesh/domain.hpp"

namespace ashlar::mesh {

struct PointOnSegment {
  double t = 0;  ///< 0 at the segment's `from`, 1 at its `to`
  Index point = -1;
};

/// For each segment the points nearer than `tolerance`, ordered along it.
std::vector<std::vector<PointOnSegment>> points_on_segments(const Domain& domain,
                                                            const std::vector<Point>& points,
                                                            double tolerance);

}  // namespace ashlar::mesh
