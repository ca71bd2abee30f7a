#include "mesh/face_lips.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "geometry/polygon.hpp"
#include "mesh/cell_shapes.hpp"
#include "mesh/chain.hpp"
#include "mesh/flatten.hpp"

namespace ashlar::mesh {

namespace {

using core::InputError;
using core::Mistake;

const char* const own_points =
    "bodies that meet by contact have points of their own; equal points of a mesh file are made one, so that "
    "`between` is the joint for them";
constexpr double round_off = 1e-13;  // of points that are on their arc, over its radius
constexpr double slowest = 1e-3;     // growth of s where projections stand still, over the edge's length

/// A connected stretch of a lip: points.size() is links.size() + 1.
struct Stretch {
  std::vector<Link> links;
  std::vector<double> s;  ///< at the start of each link, and at the end of the last
  bool closed() const { return links.front().start == links.back().end; }
  Index point(std::size_t i) const { return i < links.size() ? links[i].start : links.back().end; }
};

std::vector<Stretch> stretches(const std::vector<Link>& links) {
  std::vector<Stretch> list;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (i == 0 || links[i - 1].end != links[i].start) list.emplace_back();
    list.back().links.push_back(links[i]);
  }
  return list;
}

double distance_to(const Mesh& mesh, Point p, const std::vector<Link>& lip) {
  double least = std::numeric_limits<double>::infinity();
  for (const Link& link : lip)
    least = std::min(least, geometry::distance_to_segment(p, mesh.points[link.start], mesh.points[link.end]));
  return least;
}

// A closed stretch begins where it is farthest from the other lip.
void cut_loop(const Mesh& mesh, const std::vector<Link>& other, Stretch& stretch) {
  if (!stretch.closed()) return;
  std::size_t farthest = 0;
  double most = -1;
  for (std::size_t i = 0; i < stretch.links.size(); ++i) {
    const double away = distance_to(mesh, mesh.points[stretch.links[i].start], other);
    if (away > most) most = away, farthest = i;
  }
  std::rotate(stretch.links.begin(), stretch.links.begin() + static_cast<std::ptrdiff_t>(farthest),
              stretch.links.end());
}

/// Where a point of the second lip lies on the first.
struct Projection {
  double s = 0, away = std::numeric_limits<double>::infinity();
  Point along;  ///< unit tangent of the first lip there
};

Projection project(const Mesh& mesh, const std::vector<Stretch>& first, Point p) {
  Projection best;
  for (const Stretch& stretch : first)
    for (std::size_t i = 0; i < stretch.links.size(); ++i) {
      const Point a = mesh.points[stretch.links[i].start], b = mesh.points[stretch.links[i].end];
      double t = 0;
      const double away = geometry::distance_to_segment(p, a, b, &t);
      if (away >= best.away) continue;
      const double length = geometry::distance(a, b);
      const bool before = i == 0 && t == 0, after = i + 1 == stretch.links.size() && t == 1;
      if ((before || after) && !stretch.closed()) t = dot(p - a, b - a) / (length * length);
      best = {stretch.s[i] + t * length, away, (1 / length) * (b - a)};
    }
  return best;
}

void measure_first(const Mesh& mesh, std::vector<Stretch>& lip) {
  double s = 0;
  for (Stretch& stretch : lip) {
    stretch.s = {s};
    for (const Link& link : stretch.links)
      stretch.s.push_back(s += geometry::distance(mesh.points[link.start], mesh.points[link.end]));
  }
}

void measure_second(const Mesh& mesh, const std::vector<Stretch>& first, Stretch& stretch) {
  const std::size_t count = stretch.links.size();
  std::vector<Projection> on(count + 1);
  for (std::size_t i = 0; i <= count; ++i) on[i] = project(mesh, first, mesh.points[stretch.point(i)]);
  const auto nearest = std::ranges::min_element(on, {}, &Projection::away) - on.begin();
  const auto middle = static_cast<std::size_t>(nearest);
  stretch.s.assign(count + 1, 0.0);
  stretch.s[middle] = on[middle].s;
  const auto edge = [&](std::size_t i) {
    return mesh.points[stretch.point(i + 1)] - mesh.points[stretch.point(i)];
  };
  for (std::size_t i = middle; i < count; ++i) {
    const double length = norm(edge(i)), here = stretch.s[i];
    stretch.s[i + 1] =
        dot(edge(i), on[i + 1].along) > 0 ? std::max(on[i + 1].s, here + slowest * length) : here + length;
  }
  for (std::size_t i = middle; i-- > 0;) {
    const double length = norm(edge(i)), here = stretch.s[i + 1];
    stretch.s[i] = dot(edge(i), on[i].along) > 0 ? std::min(on[i].s, here - slowest * length) : here - length;
  }
}

// Puts the points in the middle of a drawn chord on its arc.
void put_on_arcs(const std::vector<Index>& edges, CellShapes& cells, Mesh& mesh) {
  std::map<Index, std::vector<Index>> edges_at;
  for (const Index edge : edges)
    for (const Index p : mesh.edge_points[edge]) edges_at[p].push_back(edge);
  for (const auto& [p, around] : edges_at) {
    const auto first = mesh.arcs.find(around.front()), second = mesh.arcs.find(around.back());
    if (around.size() != 2 || first == mesh.arcs.end() || second == mesh.arcs.end()) continue;
    const EdgeArc &arc = first->second, &other = second->second;
    if (!(arc.center == other.center) || arc.radius != other.radius) continue;
    const Point to = arc.nearest(mesh.points[p]);
    if (geometry::distance(to, mesh.points[p]) > round_off * arc.radius) cells.move(p, to);
  }
}

class FaceJoint {
 public:
  FaceJoint(Mesh& mesh, const JointLine& line, const std::vector<Index>& body_of, CellShapes& cells)
      : mesh_(mesh), line_(line), body_of_(body_of), cells_(cells) {}

  JointLips make() {
    std::array<std::vector<Link>, 2> links;
    for (int side = 0; side < 2; ++side) links[side] = chained(links_of(side), mesh_.points);
    check_bodies(links);
    for (const std::string& face : line_.faces) put_on_arcs(mesh_.edge_groups.at(face), cells_, mesh_);
    std::array<std::vector<Stretch>, 2> lips;
    for (int side = 0; side < 2; ++side) {
      lips[side] = stretches(links[side]);
      for (Stretch& stretch : lips[side]) cut_loop(mesh_, links[1 - side], stretch);
    }
    measure_first(mesh_, lips[0]);
    for (Stretch& stretch : lips[1]) measure_second(mesh_, lips[0], stretch);
    std::ranges::stable_sort(lips[1], {}, [](const Stretch& stretch) { return stretch.s.front(); });
    JointLips joint{line_.name, line_.sides, {}, true, {}};
    for (int side = 0; side < 2; ++side)
      for (const Stretch& stretch : lips[side]) take(stretch, side, joint);
    return joint;
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& advice) const {
    throw InputError(Mistake{line_.place, "joint '" + line_.name + "': " + what, advice});
  }

  std::vector<Link> links_of(int side) const {
    const std::string& face = line_.faces[side];
    const auto group = mesh_.edge_groups.find(face);
    if (group == mesh_.edge_groups.end() || group->second.empty())
      fail("the mesh has no edges named '" + face + "'", core::did_you_mean(face, edge_group_names(mesh_)));
    std::vector<Link> links;
    for (const Index edge : group->second) {
      auto [a, b] = mesh_.edge_points[edge];
      if (mesh_.edge_cells[edge][1] >= 0)
        fail("edge '" + face + "' is not on the border of its body at " + to_text(mesh_.points[a]),
             own_points);
      if (side == 1) std::swap(a, b);
      links.push_back({edge, a, b});
    }
    return links;
  }

  void check_bodies(const std::array<std::vector<Link>, 2>& links) const {
    std::set<Index> points, bodies;
    for (const Link& link : links[0]) {
      points.insert({link.start, link.end});
      bodies.insert(body_of_[mesh_.edge_cells[link.number][0]]);
    }
    for (const Link& link : links[1]) {
      if (!bodies.contains(body_of_[mesh_.edge_cells[link.number][0]]) && !points.contains(link.start) &&
          !points.contains(link.end))
        continue;
      fail("'" + line_.faces[0] + "' and '" + line_.faces[1] + "' belong to one body, which they meet at " +
               to_text(mesh_.points[link.start]),
           own_points);
    }
  }

  void take(const Stretch& stretch, int side, JointLips& joint) {
    auto& group = mesh_.edge_groups[line_.name + "." + line_.sides[side]];
    for (std::size_t i = 0; i < stretch.links.size(); ++i) {
      const Link& link = stretch.links[i];
      joint.lips[side].push_back({link.number, mesh_.edge_cells[link.number][0], link.start, link.end,
                                  stretch.s[i], stretch.s[i + 1], arc_of(mesh_, link.number, side == 1)});
      group.push_back(link.number);
    }
    std::ranges::sort(group);
  }

  Mesh& mesh_;
  const JointLine& line_;
  const std::vector<Index>& body_of_;
  CellShapes& cells_;
};

}  // namespace

void add_face_joints(Mesh& mesh, const std::vector<JointLine>& joints) {
  if (std::ranges::none_of(joints, [](const JointLine& joint) { return !joint.faces.empty(); })) return;
  Index count = 0;
  const std::vector<Index> body_of = bodies(mesh, count);
  CellShapes cells(mesh);
  for (const JointLine& joint : joints)
    if (!joint.faces.empty()) mesh.joints.push_back(FaceJoint(mesh, joint, body_of, cells).make());
  std::ranges::stable_sort(mesh.joints, {}, [&](const JointLips& lips) {
    return std::ranges::find(joints, lips.name, &JointLine::name) - joints.begin();
  });
}

}  // namespace ashlar::mesh
