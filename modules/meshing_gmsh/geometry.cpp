#include <gmsh.h>

#include <algorithm>
#include <map>

#include "gmsh_mesh.hpp"

namespace ashlar::meshing_gmsh {

namespace {

using mesh::Domain;
using mesh::Index;

Index segment_of(Index entry) {
  return entry < 0 ? -1 - entry : entry;
}
Index start_of(const Domain& domain, Index entry) {
  return entry < 0 ? domain.segments[-1 - entry].to : domain.segments[entry].from;
}
Index end_of(const Domain& domain, Index entry) {
  return entry < 0 ? domain.segments[-1 - entry].from : domain.segments[entry].to;
}

/// A face's border as Gmsh wants it: loops that pass no point twice, and segments with the face on both
/// sides.
struct Wires {
  std::vector<std::vector<int>> loops;
  std::vector<int> embedded;
};

// Cuts a closed walk into simple loops where it comes back to a point.
void split_walk(const Domain& domain, const std::vector<Index>& walk, Wires& wires) {
  std::vector<Index> open;
  for (const Index entry : walk) {
    open.push_back(entry);
    const Index end = end_of(domain, entry);
    for (std::size_t k = open.size(); k-- > 0;) {
      if (start_of(domain, open[k]) != end) continue;
      std::vector<int> loop;
      for (std::size_t i = k; i < open.size(); ++i) {
        const int tag = segment_of(open[i]) + 1;
        loop.push_back(open[i] < 0 ? -tag : tag);
      }
      wires.loops.push_back(std::move(loop));
      open.resize(k);
      break;
    }
  }
}

double area_of(const Domain& domain, const std::vector<int>& loop) {
  double area = 0;
  const mesh::Point origin = domain.points.front();
  for (const int tag : loop) {
    const auto& segment = domain.segments[std::abs(tag) - 1];
    const double part =
        0.5 * geometry::cross(domain.points[segment.from] - origin, domain.points[segment.to] - origin);
    area += tag > 0 ? part : -part;
  }
  return area;
}

// Segments passed in both directions part nothing: they leave the walk and are embedded instead.
void take_ring(const Domain& domain, const std::vector<Index>& ring, Wires& wires) {
  std::vector<Index> walk;
  for (const Index entry : ring) {
    const auto& segment = domain.segments[segment_of(entry)];
    if (segment.left != segment.right) {
      walk.push_back(entry);
    } else if (entry >= 0) {
      wires.embedded.push_back(entry + 1);
    }
  }
  split_walk(domain, walk, wires);
}

}  // namespace

void give_geometry(const Domain& domain) {
  for (std::size_t p = 0; p < domain.points.size(); ++p) {
    gmsh::model::geo::addPoint(domain.points[p].x, domain.points[p].y, 0, 0, static_cast<int>(p) + 1);
  }
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const auto& segment = domain.segments[s];
    gmsh::model::geo::addLine(segment.from + 1, segment.to + 1, static_cast<int>(s) + 1);
  }
  std::map<int, std::vector<int>> embedded;
  for (std::size_t f = 0; f < domain.faces.size(); ++f) {
    const auto& face = domain.faces[f];
    if (face.region < 0) continue;
    Wires wires;
    take_ring(domain, face.outer, wires);
    for (const auto& ring : face.inner) take_ring(domain, ring, wires);
    // Gmsh takes the first loop for the outer one; holes turn clockwise and have negative areas.
    std::sort(wires.loops.begin(), wires.loops.end(),
              [&](const auto& a, const auto& b) { return area_of(domain, a) > area_of(domain, b); });
    std::vector<int> loops;
    for (const auto& loop : wires.loops) loops.push_back(gmsh::model::geo::addCurveLoop(loop));
    const int tag = static_cast<int>(f) + 1;
    gmsh::model::geo::addPlaneSurface(loops, tag);
    if (!wires.embedded.empty()) embedded[tag] = wires.embedded;
  }
  gmsh::model::geo::synchronize();
  for (const auto& [surface, curves] : embedded) gmsh::model::mesh::embed(1, curves, 2, surface);
}

}  // namespace ashlar::meshing_gmsh
