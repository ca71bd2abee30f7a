#pragma once
// Whether a raw mesh fills a domain: found independently of the generators' own checks.

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "geometry/polygon.hpp"
#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

class Conformity {
 public:
  Conformity(const Domain& domain, const RawMesh& mesh) : domain_(domain), mesh_(mesh) {
    check_cells();
    check_areas();
    check_segments();
    check_borders();
  }
  /// What is wrong; empty if all is well.
  std::string faults() const { return faults_.str(); }

 private:
  using Edge = std::pair<Index, Index>;

  void check_cells() {
    std::set<Index> used;
    std::vector<Point> ring;
    for (Index c = 0; c < mesh_.cell_points.size(); ++c) {
      const auto corners = mesh_.cell_points[c];
      ring.clear();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        used.insert(corners[k]);
        ring.push_back(mesh_.points[corners[k]]);
        const Edge edge{corners[k], corners[(k + 1) % corners.size()]};
        if (!cell_left_of_.emplace(edge, c).second) faults_ << "edge on two cells' left\n";
      }
      const double area = geometry::signed_area(ring);
      if (!(area > 0)) faults_ << "cell " << c << " has area " << area << '\n';
      if (!geometry::is_simple(ring)) faults_ << "cell " << c << " is not simple\n";
      areas_[mesh_.cell_region[c]] += area;
    }
    if (used.size() != mesh_.points.size()) faults_ << "unused points\n";
  }

  void check_areas() {
    std::map<Index, double> wanted;
    for (Index f = 0; f < static_cast<Index>(domain_.faces.size()); ++f) {
      for (const auto& ring : domain_.rings(f)) {
        wanted[domain_.faces[f].region] += ring.size() > 2 ? geometry::signed_area(ring) : 0;
      }
    }
    for (const auto& [region, area] : wanted) {
      if (std::abs(areas_[region] - area) > 1e-12 * domain_.length * domain_.length) {
        faults_ << "region " << region << " lacks area " << area - areas_[region] << '\n';
      }
    }
  }

  Index region_left_of(Index from, Index to) const {
    const auto found = cell_left_of_.find({from, to});
    return found == cell_left_of_.end() ? -1 : mesh_.cell_region[found->second];
  }
  Index region_of(Index face) const { return face < 0 ? -1 : domain_.faces[face].region; }

  // The mesh points on each segment, in order, must be joined by edges with the right regions beside them.
  void check_segments() {
    for (std::size_t s = 0; s < domain_.segments.size(); ++s) {
      const auto& segment = domain_.segments[s];
      const Point a = domain_.points[segment.from], b = domain_.points[segment.to];
      std::vector<std::pair<double, Index>> on;
      for (std::size_t p = 0; p < mesh_.points.size(); ++p) {
        double t = 0;
        if (geometry::distance_to_segment(mesh_.points[p], a, b, &t) < 1e-12 * domain_.length) {
          on.push_back({t, static_cast<Index>(p)});
        }
      }
      std::sort(on.begin(), on.end());
      if (on.size() < 2 || mesh_.points[on.front().second] != a || mesh_.points[on.back().second] != b) {
        faults_ << "segment " << s << " does not begin and end at its points\n";
        continue;
      }
      for (std::size_t k = 0; k + 1 < on.size(); ++k) {
        const Index from = on[k].second, to = on[k + 1].second;
        on_segments_.insert({from, to});
        on_segments_.insert({to, from});
        if (region_left_of(from, to) == region_of(segment.left) &&
            region_left_of(to, from) == region_of(segment.right)) {
          continue;
        }
        faults_ << "segment " << s << " is not followed near " << mesh_.points[from].x << ", "
                << mesh_.points[from].y << '\n';
      }
    }
  }

  // Edges with one cell, and edges between regions, must lie on segments.
  void check_borders() {
    for (const auto& [edge, cell] : cell_left_of_) {
      const bool inner = region_left_of(edge.second, edge.first) == mesh_.cell_region[cell];
      if (!inner && !on_segments_.count(edge)) faults_ << "border edge off all segments\n";
    }
  }

  const Domain& domain_;
  const RawMesh& mesh_;
  std::map<Edge, Index> cell_left_of_;
  std::set<Edge> on_segments_;
  std::map<Index, double> areas_;
  std::ostringstream faults_;
};

}  // namespace ashlar::mesh
