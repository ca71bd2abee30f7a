#include "model/support_check.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "geometry/polygon.hpp"
#include "model/free_motions.hpp"

namespace ashlar::model {

namespace {

using geometry::Index;
using Segment = mesh::Domain::Segment;

bool drawn(const Scene& scene) {
  return std::all_of(scene.regions.begin(), scene.regions.end(),
                     [](const RegionData& region) { return region.mesh_group.empty(); });
}

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  Index face = -1;
};

Nearest nearest_border(const mesh::Domain& domain, Point p) {
  Nearest nearest;
  for (const Segment& segment : domain.segments) {
    const double d = geometry::distance_to_segment(p, domain.points[segment.from], domain.points[segment.to]);
    if (d < nearest.distance) nearest = {d, segment.left >= 0 ? segment.left : segment.right};
  }
  return nearest;
}

void check_place(const mesh::Domain& domain, Point p, const core::Place& place, core::Mistakes& mistakes) {
  if (domain.face_at(p) >= 0) return;
  const double away = nearest_border(domain, p).distance;
  // Arcs are chords here: a point on a true arc lies a little outside.
  if (away > 0.01 * domain.length)
    mistakes.add(place, "the point lies outside every region, " + core::format_quantity(away, {1, 0, 0}) +
                            " from the nearest border");
}

/// The body that bears this border; -1 if none does.
Index body_at(const mesh::Domain& domain, const std::vector<Index>& body, const std::string& border) {
  for (const Segment& segment : domain.segments)
    if (std::ranges::count(segment.borders, border) > 0)
      return body[segment.left >= 0 ? segment.left : segment.right];
  return -1;
}

/// Bodies that meet by contact may hold each other.
void join_faces(const mesh::Domain& domain, std::vector<Index>& body) {
  for (const mesh::JointLine& joint : domain.joints) {
    if (joint.faces.size() != 2) continue;
    const Index a = body_at(domain, body, joint.faces[0]), b = body_at(domain, body, joint.faces[1]);
    if (a >= 0 && b >= 0) std::ranges::replace(body, std::max(a, b), std::min(a, b));
  }
}

/// Bodies as numbers of faces.
std::vector<Index> bodies_of(const mesh::Domain& domain) {
  std::vector<Index> body(domain.faces.size());
  std::iota(body.begin(), body.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Segment& segment : domain.segments) {
      if (segment.left < 0 || segment.right < 0) continue;
      Index &a = body[segment.left], &b = body[segment.right];
      changed = changed || a != b;
      a = b = std::min(a, b);
    }
  }
  join_faces(domain, body);
  return body;
}

/// The part of a–b inside the box; nothing if there is none.
std::optional<std::array<Point, 2>> clip(Point a, Point b, const std::array<Point, 2>& box) {
  double from = 0, to = 1;
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    const double t0 = (low - start) / step, t1 = (high - start) / step;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
    return from <= to;
  };
  const auto [x_low, x_high] = std::minmax(box[0].x, box[1].x);
  const auto [y_low, y_high] = std::minmax(box[0].y, box[1].y);
  const Point step = b - a;
  if (!cut(a.x, step.x, x_low, x_high) || !cut(a.y, step.y, y_low, y_high)) return {};
  return std::array{a + from * step, a + to * step};
}

class Holder {
 public:
  Holder(const mesh::Domain& domain, Plane plane)
      : domain_(domain), plane_(plane), body_(bodies_of(domain)) {}

  std::set<Index> bodies() const { return {body_.begin(), body_.end()}; }

  std::string name(Index body) const {
    std::set<std::string> names;
    for (std::size_t f = 0; f < body_.size(); ++f)
      if (body_[f] == body) names.insert("'" + domain_.regions[domain_.faces[f].region] + "'");
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " with ") + name;
    return text;
  }

  /// "slide in x and rotate about (3, 0)"; empty if the supports hold the body.
  std::string free_motions(Index body, const std::vector<SupportData>& supports) const {
    FreeMotions motions(domain_.points.front(), domain_.length, plane_);
    for (const SupportData& support : supports)
      for (const Point p : points_of(support, body))
        for (int c = 0; c < 2; ++c)
          if (support.move[static_cast<std::size_t>(c)]) motions.hold(p, c);
    return motions.words();
  }

  /// The lowest named edge of a body; empty if it has none.
  std::string lowest_edge(Index body) const {
    std::string name;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Segment& segment : domain_.segments) {
      if (segment.borders.empty() || !belongs(segment, body)) continue;
      const double height = domain_.points[segment.from].y + domain_.points[segment.to].y;
      if (height < lowest) name = segment.borders.front();
      lowest = std::min(lowest, height);
    }
    return name;
  }

 private:
  bool belongs(const Segment& segment, Index body) const {
    return (segment.left >= 0 && body_[segment.left] == body) ||
           (segment.right >= 0 && body_[segment.right] == body);
  }

  bool bears(const Segment& segment, const std::string& edge) const {
    if (std::find(segment.borders.begin(), segment.borders.end(), edge) != segment.borders.end()) return true;
    return segment.joint >= 0 && edge.starts_with(domain_.joints[segment.joint].name + ".");
  }

  std::vector<Point> points_of(const SupportData& support, Index body) const {
    std::vector<Point> points;
    if (support.at) {
      const Index inside = domain_.face_at(*support.at);
      const Index face = inside >= 0 ? inside : nearest_border(domain_, *support.at).face;
      if (face >= 0 && body_[face] == body) points.push_back(*support.at);
      return points;
    }
    for (const Segment& segment : domain_.segments) {
      if (!belongs(segment, body)) continue;
      const Point a = domain_.points[segment.from], b = domain_.points[segment.to];
      if (!support.box && bears(segment, support.edge)) points.insert(points.end(), {a, b});
      const auto inside = support.box ? clip(a, b, *support.box) : std::nullopt;
      if (inside) points.insert(points.end(), inside->begin(), inside->end());
    }
    if (support.box) add_corners(*support.box, body, points);
    return points;
  }

  void add_corners(const std::array<Point, 2>& box, Index body, std::vector<Point>& points) const {
    for (const Point corner : {box[0], box[1], Point{box[0].x, box[1].y}, Point{box[1].x, box[0].y}}) {
      const Index face = domain_.face_at(corner);
      if (face >= 0 && body_[face] == body) points.push_back(corner);
    }
  }

  const mesh::Domain& domain_;
  Plane plane_;
  std::vector<Index> body_;
};

/// A half section lies on one side of the axis of revolution.
void check_axis(const mesh::Domain& domain, const core::Place& place, core::Mistakes& mistakes) {
  double least = 0;
  for (const Point p : domain.points) least = std::min(least, p.x);
  if (least < -1e-9 * domain.length)
    mistakes.add(place,
                 "the geometry reaches x = " + core::format_quantity(least, {1, 0, 0}) +
                     ", across the axis of revolution x = 0",
                 "draw the half section with x >= 0, x being the radius");
}

}  // namespace

void check_places(const Scene& scene, const mesh::Domain& domain, core::Mistakes& mistakes) {
  if (!drawn(scene)) return;
  if (scene.plane == Plane::axisymmetric) check_axis(domain, scene.root.place_of("plane"), mistakes);
  for (const ProbeData& probe : scene.probes) check_place(domain, probe.at, probe.place, mistakes);
  for (const StageData& stage : scene.stages)
    for (const SupportData& support : stage.supports)
      if (support.at) check_place(domain, *support.at, support.place, mistakes);
}

void check_support(const Scene& scene, const mesh::Domain& domain, core::Mistakes& mistakes) {
  if (!drawn(scene)) return;
  const Holder holder(domain, scene.plane);
  for (const Index body : holder.bodies())
    for (const StageData& stage : scene.stages) {
      const std::string motions = holder.free_motions(body, stage.supports);
      if (motions.empty()) continue;
      add_unheld({holder.name(body), stage.name, motions, holder.lowest_edge(body)}, stage.place, mistakes);
      break;  // later stages inherit the mistake
    }
}

}  // namespace ashlar::model
