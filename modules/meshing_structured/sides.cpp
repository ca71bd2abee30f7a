#include "meshing_structured/sides.hpp"

#include <algorithm>
#include <numbers>

#include "mesh/chain.hpp"

namespace ashlar::meshing_structured {

namespace {

using mesh::Domain;
using mesh::Link;

constexpr double corner_turn = 15 * std::numbers::pi / 180;  // twice what chords of an arc turn
constexpr double straight = 1e-6;                            // round-off of points along a straight side
constexpr double near_share = 0.3;                           // of a division: nearer points take its place

std::vector<Link> outline(const Domain& domain, Index region) {
  auto region_of = [&](Index face) { return face < 0 ? -1 : domain.faces[face].region; };
  std::vector<Link> links;
  for (Index i = 0; i < static_cast<Index>(domain.segments.size()); ++i) {
    const auto& s = domain.segments[i];
    const bool left = region_of(s.left) == region, right = region_of(s.right) == region;
    if (left && !right) links.push_back({i, s.from, s.to});
    if (right && !left) links.push_back({i, s.to, s.from});
  }
  return mesh::chained(std::move(links), domain.points);
}

bool is_one_ring(const std::vector<Link>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].end != ring[(i + 1) % ring.size()].start) return false;
  }
  return ring.size() >= 3;
}

std::vector<std::size_t> corners_of(const std::vector<Link>& ring, const std::vector<Point>& points,
                                    bool& convex) {
  std::vector<std::size_t> corners, bends;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Link& before = ring[(i + ring.size() - 1) % ring.size()];
    const Point a = points[before.end] - points[before.start],
                b = points[ring[i].end] - points[ring[i].start];
    const double turn = std::atan2(geometry::cross(a, b), geometry::dot(a, b));
    if (turn < -corner_turn) convex = false;
    if (turn > corner_turn) corners.push_back(i);
    if (turn > straight) bends.push_back(i);
  }
  // A quadrilateral of straight sides is one however flat its corners are.
  return bends.size() == 4 ? bends : corners;
}

Side side_between(const std::vector<Link>& ring, std::size_t first, std::size_t last,
                  const std::vector<Point>& points) {
  Side side;
  side.points.push_back(ring[first].start);
  side.at.push_back(0);
  for (std::size_t i = first; i != last; i = (i + 1) % ring.size()) {
    side.length += geometry::distance(points[ring[i].start], points[ring[i].end]);
    side.segments.push_back(ring[i].number);
    side.points.push_back(ring[i].end);
    side.at.push_back(side.length);
  }
  for (double& at : side.at) at /= side.length;
  return side;
}

Side reversed(Side side) {
  std::reverse(side.points.begin(), side.points.end());
  std::reverse(side.segments.begin(), side.segments.end());
  std::reverse(side.at.begin(), side.at.end());
  for (double& at : side.at) at = 1 - at;
  return side;
}

// Share of the segment, from its `from`, turned into a share of the side.
double share_of_side(const Domain& domain, const Side& side, std::size_t k, double t) {
  const bool along = domain.segments[side.segments[k]].from == side.points[k];
  return side.at[k] + (along ? t : 1 - t) * (side.at[k + 1] - side.at[k]);
}

}  // namespace

Sides sides_of(const Domain& domain, Index region, const core::Place& place) {
  const auto ring = outline(domain, region);
  bool convex = is_one_ring(ring);
  std::vector<std::size_t> corners;
  if (convex) corners = corners_of(ring, domain.points, convex);
  if (!convex || corners.size() != 4) {
    throw core::InputError(core::Mistake{
        place, "region '" + domain.regions[region] + "' is not four-sided: mesh.structured cannot fill it",
        "use mesh.voronoi or mesh.gmsh, or divide it into four-sided regions"});
  }
  std::array<Side, 4> sides;
  std::size_t bottom = 0;
  double best = -2;
  for (std::size_t k = 0; k < 4; ++k) {
    sides[k] = side_between(ring, corners[k], corners[(k + 1) % 4], domain.points);
    const Point chord = domain.points[sides[k].points.back()] - domain.points[sides[k].points.front()];
    const double along_x = chord.x / geometry::norm(chord);
    if (along_x > best + 1e-9) best = along_x, bottom = k;
  }
  return {sides[bottom], sides[(bottom + 1) % 4], reversed(sides[(bottom + 2) % 4]),
          reversed(sides[(bottom + 3) % 4])};
}

BorderPoints::BorderPoints(const Domain& domain, std::vector<Point>& points)
    : domain_(domain), points_(points), corners_(domain.points.size(), -1), inside_(domain.segments.size()) {}

Index BorderPoints::corner(Index domain_point) {
  if (corners_[domain_point] < 0) {
    corners_[domain_point] = static_cast<Index>(points_.size());
    points_.push_back(domain_.points[domain_point]);
  }
  return corners_[domain_point];
}

SidePoint BorderPoints::make(const Side& side, double at) {
  const auto after = std::upper_bound(side.at.begin() + 1, side.at.end() - 1, at);
  const auto k = static_cast<std::size_t>(after - side.at.begin()) - 1;
  const auto& segment = domain_.segments[side.segments[k]];
  const double part = (at - side.at[k]) / (side.at[k + 1] - side.at[k]);
  const double t = segment.from == side.points[k] ? part : 1 - part;
  const Point a = domain_.points[segment.from], b = domain_.points[segment.to];
  const auto made = static_cast<Index>(points_.size());
  points_.push_back(a + t * (b - a));
  inside_[side.segments[k]].push_back({t, made});
  return {at, made};
}

std::vector<SidePoint> BorderPoints::all_on(const Side& side) {
  std::vector<SidePoint> result;
  for (std::size_t k = 0; k < side.points.size(); ++k) {
    result.push_back({side.at[k], corner(side.points[k])});
    if (k == side.segments.size()) break;
    for (const auto& inner : inside_[side.segments[k]]) {
      result.push_back({share_of_side(domain_, side, k, inner.at), inner.point});
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  return result;
}

std::vector<SidePoint> BorderPoints::divide(const Side& side, const std::vector<double>& shares) {
  const auto present = all_on(side);
  std::vector<SidePoint> nodes{present.front()};
  for (std::size_t i = 1; i + 1 < shares.size(); ++i) {
    const double reach = near_share * std::min(shares[i] - shares[i - 1], shares[i + 1] - shares[i]);
    const SidePoint* nearest = nullptr;
    for (const SidePoint& p : present) {
      if (std::abs(p.at - shares[i]) > reach) continue;
      if (!nearest || std::abs(p.at - shares[i]) < std::abs(nearest->at - shares[i])) nearest = &p;
    }
    nodes.push_back(nearest ? *nearest : make(side, shares[i]));
  }
  nodes.push_back(present.back());
  return nodes;
}

}  // namespace ashlar::meshing_structured
