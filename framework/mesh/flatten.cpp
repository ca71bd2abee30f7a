#include "mesh/flatten.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include "geometry/polygon.hpp"

namespace ashlar::mesh {

namespace {

using geometry::Shape;
using geometry::ShapeEdge;
constexpr double largest_turn = 7.5 * std::numbers::pi / 180;
constexpr double touch = 1e-9;  // relative to the scene's length, as everywhere in this layer

void collect_corners(const Shape& shape, std::vector<Point>& corners) {
  for (const auto& ring : shape.rings) {
    for (const auto& edge : ring) corners.push_back(edge.start);
  }
  for (const auto& operand : shape.operands) collect_corners(operand, corners);
}

double angle_along(const geometry::Arc& arc, Point start, Point p) {
  const Point a = start - arc.center, b = p - arc.center;
  const double sense = arc.counter_clockwise ? 1 : -1;
  const double angle = std::atan2(sense * geometry::cross(a, b), geometry::dot(a, b));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

class Flattener {
 public:
  Flattener(const std::vector<RegionShape>& regions, const std::set<std::string>& faces, double chord,
            core::Mistakes& mistakes)
      : regions_(regions), faces_(faces), chord_(chord), mistakes_(mistakes) {
    for (const auto& region : regions) collect_corners(region.shape, corners_);
    Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}, high = -1.0 * low;
    for (const Point p : corners_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    result_.length = corners_.empty() ? 0 : geometry::distance(low, high);
    // A circle is one corner: its extent is in its radius.
    for (const auto& region : regions) widen_by_arcs(region.shape);
  }

  FlatRegions run() {
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      region_ = static_cast<Index>(r);
      result_.shapes.push_back(flat(regions_[r].shape));
    }
    return std::move(result_);
  }

 private:
  void widen_by_arcs(const Shape& shape) {
    for (const auto& ring : shape.rings) {
      for (const auto& edge : ring) {
        if (edge.arc)
          result_.length = std::max(result_.length, 2 * geometry::distance(edge.start, edge.arc->center));
      }
    }
    for (const auto& operand : shape.operands) widen_by_arcs(operand);
  }

  const std::string& region_name() const { return regions_[region_].name; }
  const core::Place& place(const core::Place& own) const {
    return own.line > 0 || !own.path.empty() ? own : regions_[region_].place;
  }

  FlatShape flat(const Shape& shape) {
    FlatShape result;
    result.kind = shape.kind;
    for (const auto& ring : shape.rings) {
      check_names(ring);
      result.rings.push_back(flat_ring(ring));
    }
    for (std::size_t k = 1; k < result.rings.size(); ++k) check_hole(result.rings[0], result.rings[k], shape);
    for (const auto& operand : shape.operands) result.operands.push_back(flat(operand));
    return result;
  }

  static std::optional<EdgeArc> arc_of(const ShapeEdge& edge) {
    if (!edge.arc) return {};
    return EdgeArc{edge.arc->center, geometry::distance(edge.start, edge.arc->center),
                   edge.arc->counter_clockwise};
  }

  std::vector<Point> flat_ring(const std::vector<ShapeEdge>& ring) {
    std::vector<Point> points;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point end = ring[(i + 1) % ring.size()].start;
      const auto stretch = ring[i].arc ? arc_points(ring[i], end) : std::vector<Point>{ring[i].start, end};
      points.insert(points.end(), stretch.begin(), stretch.end() - 1);
      owner.insert(owner.end(), stretch.size() - 1, i);
    }
    if (!check_ring(ring, points, owner)) return {};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ShapeEdge& edge = ring[owner[i]];
      result_.edges.push_back({points[i], points[(i + 1) % points.size()], region_, edge.name, arc_of(edge)});
    }
    return points;
  }

  // A chord c lies up to c²/(8 r) off its arc.
  double longest_chord(const ShapeEdge& edge, double radius) const {
    if (!faces_.contains(region_name() + "." + edge.name)) return chord_;
    constexpr double off_arc = 0.05;
    return std::max(chord_, std::sqrt(8 * radius * off_arc * chord_));
  }

  std::vector<Point> arc_points(const ShapeEdge& edge, Point end) {
    const geometry::Arc& arc = *edge.arc;
    const double r0 = geometry::distance(edge.start, arc.center), r1 = geometry::distance(end, arc.center);
    if (!(r0 > 0) || !(std::abs(r1 - r0) <= 1e-6 * r0)) {
      mistakes_.add(place(edge.place),
                    "the arc from " + to_text(edge.start) + " to " + to_text(end) + " about " +
                        to_text(arc.center) + " has ends at different distances from its centre, or none",
                    "give a centre that is equally far from both ends, or a third point on the arc");
      return {edge.start, end};
    }
    // Corners of other shapes on this arc split it, so that arcs that are shared in part get the same chords.
    const double full = edge.start == end ? 2 * std::numbers::pi : angle_along(arc, edge.start, end);
    const double near = touch * result_.length, chord = longest_chord(edge, r0);
    std::vector<std::pair<double, Point>> stops;
    for (const Point p : corners_) {
      if (std::abs(geometry::distance(p, arc.center) - r0) > near) continue;
      if (geometry::distance(p, edge.start) <= near || geometry::distance(p, end) <= near) continue;
      const double angle = angle_along(arc, edge.start, p);
      if (angle < full) stops.emplace_back(angle, p);
    }
    std::sort(stops.begin(), stops.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    stops.emplace_back(full, end);
    std::vector<Point> points{edge.start};
    for (const auto& stop : stops) {
      if (stop.second == points.back() && points.size() > 1) continue;
      const auto part = geometry::points_on_arc(points.back(), stop.second, arc, chord, largest_turn);
      points.insert(points.end(), part.begin() + 1, part.end());
    }
    return points;
  }

  bool check_ring(const std::vector<ShapeEdge>& ring, const std::vector<Point>& points,
                  const std::vector<std::size_t>& owner) {
    const core::Place where = place(ring.empty() ? core::Place{} : ring.front().place);
    for (const Point p : points) {
      if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
      mistakes_.add(where, "region '" + region_name() + "' has a corner that is not a finite point");
      return false;
    }
    if (points.size() < 3) {
      mistakes_.add(where, "region '" + region_name() + "' is empty: a ring needs three corners or an arc");
      return false;
    }
    const auto [i, j] = geometry::first_crossing(points);
    if (i >= 0) {
      report_crossing(ring, owner[i], owner[j]);
      return false;
    }
    if (std::abs(geometry::signed_area(points)) > touch * touch * result_.length * result_.length)
      return true;
    mistakes_.add(where, "region '" + region_name() + "' is empty: it has no area");
    return false;
  }

  void report_crossing(const std::vector<ShapeEdge>& ring, std::size_t i, std::size_t j) {
    auto label = [&](std::size_t k) {
      return "edge " + std::to_string(k + 1) + (ring[k].name.empty() ? "" : " '" + ring[k].name + "'") +
             " from " + to_text(ring[k].start);
    };
    for (const std::size_t k : {i, j}) {
      if (ring[k].arc || ring[k].start != ring[(k + 1) % ring.size()].start) continue;
      mistakes_.add(place(ring[k].place),
                    "region '" + region_name() + "' has an edge of no length at " + to_text(ring[k].start),
                    "a ring closes itself: do not repeat a corner");
      return;
    }
    mistakes_.add(place(ring[i].place),
                  "region '" + region_name() + "' crosses itself: " + label(i) + " meets " + label(j),
                  "list the corners in order around the region");
  }

  // One name in one ring means one connected stretch of its border.
  void check_names(const std::vector<ShapeEdge>& ring) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::string& name = ring[i].name;
      if (name.empty() || name == ring[(i + ring.size() - 1) % ring.size()].name) continue;
      if (seen.insert(name).second) continue;
      mistakes_.add(place(ring[i].place),
                    "region '" + region_name() + "' has two separate borders named '" + name + "'",
                    "give each its own name");
    }
  }

  void check_hole(const std::vector<Point>& outer, const std::vector<Point>& hole, const Shape& shape) {
    for (const Point p : hole) {
      if (outer.empty() || geometry::contains(outer, p)) continue;
      const double near = touch * result_.length;
      bool touches = false;
      for (std::size_t i = 0; i < outer.size() && !touches; ++i) {
        touches = geometry::distance_to_segment(p, outer[i], outer[(i + 1) % outer.size()]) < near;
      }
      if (touches) continue;
      mistakes_.add(place(shape.place),
                    "region '" + region_name() + "' has a hole that leaves it at " + to_text(p),
                    "keep holes inside the outer ring, or use difference");
      return;
    }
  }

  const std::vector<RegionShape>& regions_;
  const std::set<std::string>& faces_;
  double chord_;
  core::Mistakes& mistakes_;
  std::vector<Point> corners_;
  Index region_ = 0;
  FlatRegions result_;
};

}  // namespace

bool FlatShape::contains(Point p) const {
  auto holds = [p](const FlatShape& shape) { return shape.contains(p); };
  switch (kind) {
    case Shape::Kind::rings:
      if (rings.empty() || !geometry::contains(rings[0], p)) return false;
      return std::none_of(rings.begin() + 1, rings.end(),
                          [p](const auto& hole) { return geometry::contains(hole, p); });
    case Shape::Kind::difference:
      return !operands.empty() && operands[0].contains(p) &&
             std::none_of(operands.begin() + 1, operands.end(), holds);
    case Shape::Kind::unite:
      return std::any_of(operands.begin(), operands.end(), holds);
    case Shape::Kind::intersection:
      return !operands.empty() && std::all_of(operands.begin(), operands.end(), holds);
  }
  return false;
}

FlatRegions flatten(const std::vector<RegionShape>& regions, const std::set<std::string>& faces, double chord,
                    core::Mistakes& mistakes) {
  return Flattener(regions, faces, chord, mistakes).run();
}

std::set<std::string> faces_of(const std::vector<JointLine>& joints) {
  std::set<std::string> names;
  for (const JointLine& joint : joints) names.insert(joint.faces.begin(), joint.faces.end());
  return names;
}

std::string to_text(Point p) {
  std::ostringstream text;
  text.precision(7);
  text << '(' << p.x << ", " << p.y << ')';
  return text.str();
}

}  // namespace ashlar::mesh
