#include "mesh/domain.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "geometry/polygon.hpp"
#include "geometry/predicates.hpp"
#include "mesh/domain_joints.hpp"
#include "mesh/flatten.hpp"

namespace ashlar::mesh {

namespace {

using geometry::Arrangement;
using geometry::InputSegment;

Index source_number(Index source) {
  return source < 0 ? -1 - source : source;
}

// The regions of the arrangement's faces; -1 outside. Overlaps are mistakes, said once a pair.
std::vector<Index> regions_of_faces(const Arrangement& arrangement, const std::vector<RegionShape>& regions,
                                    const FlatRegions& flat, core::Mistakes& mistakes) {
  std::vector<Index> region(arrangement.faces.size(), -1);
  std::set<std::pair<Index, Index>> said;
  for (std::size_t f = 1; f < arrangement.faces.size(); ++f) {
    for (Index r = 0; r < static_cast<Index>(regions.size()); ++r) {
      if (!flat.shapes[r].contains(arrangement.faces[f].inside)) continue;
      if (region[f] < 0) {
        region[f] = r;
      } else if (said.emplace(region[f], r).second) {
        mistakes.add(regions[r].place,
                     "regions '" + regions[region[f]].name + "' and '" + regions[r].name +
                         "' overlap around " + to_text(arrangement.faces[f].inside),
                     "let one end where the other begins, or take it away with difference");
      }
    }
  }
  return region;
}

// Segments that part nothing (inside a united shape, outside of everything) and bear no joint go.
std::vector<InputSegment> needed_segments(const Arrangement& arrangement, const std::vector<Index>& region,
                                          Index first_joint_source) {
  std::vector<InputSegment> needed;
  for (std::size_t i = 0; i < arrangement.segments.size(); ++i) {
    const auto& s = arrangement.segments[i];
    const bool joint = std::any_of(s.sources.begin(), s.sources.end(),
                                   [&](Index source) { return source_number(source) >= first_joint_source; });
    if (region[s.left] == region[s.right] && !joint) continue;
    needed.push_back({arrangement.points[s.from], arrangement.points[s.to], static_cast<Index>(i)});
  }
  return needed;
}

// Sources of the second arrangement's segments in terms of the first one's inputs.
void compose_sources(Arrangement& second, const Arrangement& first) {
  for (auto& s : second.segments) {
    std::vector<Index> sources;
    for (const Index through : s.sources) {
      for (const Index source : first.segments[source_number(through)].sources) {
        sources.push_back(through >= 0 ? source : -1 - source);
      }
    }
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    s.sources = std::move(sources);
  }
}

// Names and the arc of the drawn edges that bound a region here.
void take_borders(const Domain& domain, const std::vector<Index>& sources, const std::vector<FlatEdge>& edges,
                  Domain::Segment& segment) {
  std::set<std::string> names;
  for (const Index source : sources) {
    const Index number = source_number(source);
    if (number >= static_cast<Index>(edges.size())) continue;
    const FlatEdge& edge = edges[number];
    const bool bounds = (segment.left >= 0 && domain.faces[segment.left].region == edge.region) !=
                        (segment.right >= 0 && domain.faces[segment.right].region == edge.region);
    if (!bounds) continue;
    if (!edge.name.empty()) names.insert(domain.regions[edge.region] + "." + edge.name);
    if (!edge.arc || segment.arc) continue;
    segment.arc = edge.arc;
    if (source < 0) segment.arc->counter_clockwise = !edge.arc->counter_clockwise;
  }
  segment.borders = {names.begin(), names.end()};
}

void fill_domain(Domain& domain, const Arrangement& arrangement, const std::vector<Index>& region,
                 const FlatRegions& flat) {
  domain.points = arrangement.points;
  std::vector<Index> number(arrangement.faces.size(), -1);
  for (std::size_t f = 0; f < arrangement.faces.size(); ++f) {
    if (region[f] < 0) continue;
    number[f] = static_cast<Index>(domain.faces.size());
    const auto& face = arrangement.faces[f];
    domain.faces.push_back({region[f], face.outer, face.inner, face.inside});
  }
  for (const auto& s : arrangement.segments) {
    Domain::Segment segment;
    segment.from = s.from;
    segment.to = s.to;
    segment.left = number[s.left];
    segment.right = number[s.right];
    take_borders(domain, s.sources, flat.edges, segment);
    domain.segments.push_back(std::move(segment));
  }
}

double extent(const std::vector<InputSegment>& segments) {
  if (segments.empty()) return 0;
  Point low = segments[0].from, high = low;
  for (const auto& s : segments) {
    for (const Point p : {s.from, s.to}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return geometry::distance(low, high);
}

void report_empty_regions(const Domain& domain, const std::vector<RegionShape>& regions,
                          const FlatRegions& flat, core::Mistakes& mistakes) {
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const bool filled = std::any_of(domain.faces.begin(), domain.faces.end(),
                                    [&](const auto& face) { return face.region == static_cast<Index>(r); });
    const auto& shape = flat.shapes[r];
    const bool reported =
        shape.kind == geometry::Shape::Kind::rings && (shape.rings.empty() || shape.rings[0].empty());
    if (!filled && !reported)
      mistakes.add(regions[r].place, "region '" + regions[r].name + "' is empty: nothing is left of it");
  }
}

template <class Visit>
void visit_border(const Domain::Face& face, Visit visit) {
  for (const Index entry : face.outer) visit(entry);
  for (const auto& ring : face.inner) {
    for (const Index entry : ring) visit(entry);
  }
}

// Crossings of a ray to the right: antennas count twice, so parity holds for outer ring and holes together.
bool face_contains(const Domain& domain, const Domain::Face& face, Point p) {
  bool inside = false, on_border = false;
  visit_border(face, [&](Index entry) {
    const auto& segment = domain.segments[source_number(entry)];
    const Point a = domain.points[segment.from], b = domain.points[segment.to];
    if (geometry::on_segment(p, a, b)) on_border = true;
    if ((a.y > p.y) == (b.y > p.y)) return;
    const int side = geometry::orientation(a, b, p);
    if (b.y > a.y ? side > 0 : side < 0) inside = !inside;
  });
  return inside || on_border;
}

}  // namespace

std::vector<std::vector<Point>> Domain::rings(Index face) const {
  auto points_of = [this](const std::vector<Index>& entries) {
    std::vector<Point> ring;
    for (const Index entry : entries) {
      ring.push_back(points[entry < 0 ? segments[-1 - entry].to : segments[entry].from]);
    }
    return ring;
  };
  std::vector<std::vector<Point>> result{points_of(faces[face].outer)};
  for (const auto& inner : faces[face].inner) result.push_back(points_of(inner));
  return result;
}

Index Domain::face_at(Point p) const {
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
    if (face_contains(*this, faces[f], p)) return f;
  }
  return -1;
}

double Domain::area() const {
  double sum = 0;
  for (const Segment& segment : segments) {
    const double part =
        0.5 * geometry::cross(points[segment.from] - points.front(), points[segment.to] - points.front());
    if (segment.left >= 0) sum += part;
    if (segment.right >= 0) sum -= part;
  }
  return sum;
}

Domain make_domain(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints,
                   double chord, core::Mistakes& mistakes) {
  constexpr double relative_snap = 1e-9;
  Domain domain;
  for (const auto& region : regions) domain.regions.push_back(region.name);
  domain.joints = joints;
  domain.arc_chord = chord;
  const FlatRegions flat = flatten(regions, faces_of(joints), chord, mistakes);
  std::vector<InputSegment> inputs;
  for (const auto& edge : flat.edges)
    inputs.push_back({edge.from, edge.to, static_cast<Index>(inputs.size())});
  const auto first_joint = static_cast<Index>(inputs.size());
  const std::vector<JointSource> sources = joint_sources(joints, first_joint, inputs, mistakes);
  domain.length = flat.length > 0 ? flat.length : extent(inputs);
  for (const auto& joint : joints) {
    if (std::find(domain.regions.begin(), domain.regions.end(), joint.name) == domain.regions.end()) continue;
    mistakes.add(joint.place, "a joint and a region have the same name '" + joint.name + "'",
                 "lips and borders are named by them");
  }
  if (inputs.empty() || !std::isfinite(domain.length)) return domain;

  const double snap = relative_snap * domain.length;
  Arrangement arrangement = geometry::arrange(inputs, snap);
  core::Mistakes overlaps, repeated;
  auto region = regions_of_faces(arrangement, regions, flat, overlaps);
  for (const auto& mistake : overlaps.list()) mistakes.add(mistake.place, mistake.what, mistake.advice);
  const auto needed = needed_segments(arrangement, region, first_joint);
  if (needed.size() < arrangement.segments.size()) {
    const Arrangement first = std::move(arrangement);
    arrangement = geometry::arrange(needed, snap);
    compose_sources(arrangement, first);
    region = regions_of_faces(arrangement, regions, flat, repeated);
  }
  fill_domain(domain, arrangement, region, flat);
  report_empty_regions(domain, regions, flat, mistakes);
  mark_path_joints(domain, arrangement, sources, mistakes);
  mark_border_joints(domain, mistakes);
  return domain;
}

}  // namespace ashlar::mesh
