#include "mesh/near_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "core/units.hpp"
#include "geometry/polygon.hpp"
#include "mesh/flatten.hpp"

namespace ashlar::mesh {

namespace {

constexpr double reach = 4;  // edges along the lines through where they meet: two on each

struct Line {
  std::string text;  ///< "joint 'fault'"
  Index joint = -1;
  bool operator==(const Line&) const = default;
};

/// Where a point comes too near to a piece of another line.
struct Near {
  Index line = -1, other = -1;
  double distance = 0, size = 0;
  bool meet = false;  ///< a few edges away
  Point at;
};

using Start = std::array<std::pair<Index, double>, 2>;

/// Straight pieces of lines between numbered points.
class Network {
 public:
  Network(const std::vector<JointLine>& joints, std::size_t points) : joints_(joints), at_(points) {}

  Index line(Index joint, const std::vector<std::string>& borders, const std::string& otherwise) {
    Line found{otherwise, joint};
    for (std::size_t j = 0; j < joints_.size() && found.joint < 0; ++j)
      for (const std::string& face : joints_[j].faces)
        if (std::ranges::count(borders, face) > 0) found.joint = static_cast<Index>(j);
    if (found.joint >= 0)
      found.text = "joint '" + joints_[found.joint].name + "'";
    else if (!borders.empty())
      found.text = "edge '" + borders.front() + "'";
    const auto same = std::ranges::find(lines_, found);
    if (same == lines_.end()) lines_.push_back(found);
    return static_cast<Index>(std::ranges::find(lines_, found) - lines_.begin());
  }

  void add(Index a, Index b, double length, Index line) {
    at_[a].push_back({b, length, line});
    at_[b].push_back({a, length, line});
  }

  bool is_joint(Index line) const { return lines_[line].joint >= 0; }

  /// The line at a point that this one may be too near to; -1 if there is none.
  Index other_at(Index point, Index line) const {
    Index best = -1;
    for (const Step& step : at_[point]) {
      if (!is_joint(line) && !is_joint(step.line)) continue;
      const auto rank = [&](Index l) { return l < 0 ? 0 : l == line ? 1 : is_joint(l) ? 3 : 2; };
      if (rank(step.line) > rank(best)) best = step.line;
    }
    return best;
  }

  /// The way along lines from the nearer of two points, each with the way to it; `limit` if it is no shorter.
  double way(const Start& from, Index to, double limit) const {
    return way(from, to, limit, [](Index) { return true; });
  }
  /// Whether these two lines meet on a way shorter than that.
  bool meet(const Start& from, Index to, double limit, Index line, Index other) const {
    return way(from, to, limit, [&](Index l) { return l == line || l == other; }) < limit;
  }

  /// Keeps the worst place of each two lines.
  void note(Near near) {
    auto& kept = near_[std::minmax(near.line, near.other)];
    if (kept.line < 0 || near.distance * kept.size < kept.distance * near.size) kept = near;
  }

  void throw_if_near(double share, const std::string& sizes) const {
    core::Mistakes mistakes;
    for (const auto& [lines, near] : near_) {
      const Line &a = lines_[lines.first], &b = lines_[lines.second];
      mistakes.add(joints_[std::max(a.joint, b.joint)].place, what(a, b, near, sizes),
                   cure(a, b, near, share));
    }
    mistakes.throw_if_any();
  }

 private:
  struct Step {
    Index to = -1;
    double length = 0;
    Index line = -1;
  };

  template <class Allowed>
  double way(const Start& from, Index to, double limit, Allowed allowed) const {
    std::map<Index, double> known;
    std::vector<std::pair<Index, double>> open(from.begin(), from.end());
    while (!open.empty()) {
      const auto [point, so_far] = open.back();
      open.pop_back();
      if (so_far >= limit) continue;
      const auto [entry, fresh] = known.emplace(point, so_far);
      if (!fresh && entry->second <= so_far) continue;
      entry->second = so_far;
      for (const Step& step : at_[point])
        if (allowed(step.line)) open.emplace_back(step.to, so_far + step.length);
    }
    const auto found = known.find(to);
    return found == known.end() ? limit : found->second;
  }

  std::string what(const Line& a, const Line& b, const Near& near, const std::string& sizes) const {
    const auto length = [](double value) { return core::format_quantity(value, {1, 0, 0}); };
    const std::string apart = length(near.distance) + (a == b ? " of itself" : " apart");
    const std::string where = " around " + to_text(near.at) + ", where " + sizes + " " + length(near.size) +
                              ": the mesh cannot tell " + (a == b ? "its legs" : "them") + " apart";
    if (a == b) return a.text + " comes within " + apart + where;
    if (a.joint < 0 || b.joint < 0)
      return (a.joint < 0 ? b.text + " and " + a.text : a.text + " and " + b.text) + " are " + apart + where;
    return "joints '" + joints_[a.joint].name + "' and '" + joints_[b.joint].name + "' are " + apart + where;
  }

  static std::string cure(const Line& a, const Line& b, const Near& near, double share) {
    if (near.meet) {
      std::ostringstream angle;
      angle << std::ceil(10 * std::asin(2 * share / reach) * 180 / std::numbers::pi) / 10;
      return "let " + std::string(a == b ? "its legs" : "them") + " meet at no less than " + angle.str() +
             "°, or end " + (a.joint >= 0 && b.joint >= 0 && !(a == b) ? "one of them" : "the joint") +
             " before";
    }
    const std::string smaller =
        "smaller cells there, of at most " + core::format_quantity(near.distance / share, {1, 0, 0});
    if (a == b) return smaller + ", or a path that does not come back to itself";
    if (a.joint < 0 || b.joint < 0) return smaller + ", or move the joint";
    return smaller + ", or one joint in place of both; a joint may also end on the other";
  }

  const std::vector<JointLine>& joints_;
  std::vector<Line> lines_;
  std::vector<std::vector<Step>> at_;
  std::map<std::pair<Index, Index>, Near> near_;
};

std::string between(const std::vector<std::string>& regions, Index left, Index right) {
  if (left < 0 || right < 0) return "the border of region '" + regions[std::max(left, right)] + "'";
  return "the border between regions '" + regions[left] + "' and '" + regions[right] + "'";
}

/// The mesh edges on joints and borders, and which line each is on; -1: on none. Points of lips that lie on
/// each other are one place.
class MeshLines {
 public:
  MeshLines(const Mesh& mesh, const std::vector<JointLine>& joints)
      : mesh_(mesh),
        place_of_(mesh.points.size(), -1),
        line_of_(static_cast<std::size_t>(mesh.edge_count()), -1),
        network_(joints, mesh.points.size()) {
    std::map<Index, std::vector<std::string>> names;
    for (const auto& [name, edges] : mesh.edge_groups)
      for (const Index edge : edges) names[edge].push_back(name);
    std::map<Index, Index> joint_of;
    for (const JointLips& lips : mesh.joints)
      for (const auto& lip : lips.lips)
        for (const LipEdge& edge : lip)
          joint_of[edge.edge] =
              static_cast<Index>(std::ranges::find(joints, lips.name, &JointLine::name) - joints.begin());
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const auto joint = joint_of.find(e);
      const Index left = region_at(e, 0), right = region_at(e, 1);
      if (joint == joint_of.end() && left == right) continue;
      line_of_[e] = network_.line(joint == joint_of.end() ? -1 : joint->second, names[e],
                                  between(mesh.regions, left, right));
      const auto [a, b] = mesh.edge_points[e];
      network_.add(place(a), place(b), geometry::distance(mesh.points[a], mesh.points[b]), line_of_[e]);
    }
  }

  void require_apart() {
    for (Index e = 0; e < mesh_.edge_count(); ++e)
      for (const Index cell : mesh_.edge_cells[e])
        if (line_of_[e] >= 0 && cell >= 0) look_across(e, cell);
    network_.throw_if_near(least_over_edge, "the mesh has edges of");
  }

 private:
  Index region_at(Index edge, int side) const {
    const Index cell = mesh_.edge_cells[edge][side];
    return cell < 0 ? -1 : mesh_.cell_region[cell];
  }

  Index place(Index point) {
    const Point p = mesh_.points[point];
    return place_of_[point] = places_.emplace(std::pair(p.x, p.y), point).first->second;
  }

  // The cell's corners on other lines.
  void look_across(Index edge, Index cell) {
    const auto [a, b] = mesh_.edge_points[edge];
    const Point from = mesh_.points[a], to = mesh_.points[b];
    const double size = geometry::distance(from, to), beside = reach * size;
    const Start ends = {{{place_of_[a], 0.0}, {place_of_[b], 0.0}}};
    for (const Index corner : mesh_.cell_points[cell]) {
      const Index at = place_of_[corner];
      const Index other = at < 0 || corner == a || corner == b ? -1 : network_.other_at(at, line_of_[edge]);
      if (other < 0) continue;
      const Point p = mesh_.points[corner];
      const double distance = geometry::distance_to_segment(p, from, to);
      if (distance >= least_over_edge * size || network_.way(ends, at, beside) < beside) continue;
      const bool meet = network_.meet(ends, at, 2 * beside, line_of_[edge], other);
      network_.note({line_of_[edge], other, distance, size, meet, p});
    }
  }

  const Mesh& mesh_;
  std::map<std::pair<double, double>, Index> places_;
  std::vector<Index> place_of_;  // a point of the mesh at the same place; -1: on no line
  std::vector<Index> line_of_;
  Network network_;
};

/// The domain's segments, looked at from places half a cell apart on each.
class DrawnLines {
 public:
  DrawnLines(const Domain& domain, const SizeField& sizes)
      : domain_(domain), sizes_(sizes), network_(domain.joints, domain.points.size()) {
    for (const auto& s : domain.segments) {
      line_of_.push_back(
          network_.line(s.joint, s.borders, between(domain.regions, region(s.left), region(s.right))));
      network_.add(s.from, s.to, geometry::distance(domain.points[s.from], domain.points[s.to]),
                   line_of_.back());
    }
  }

  void require_apart() {
    for (std::size_t s = 0; s < domain_.segments.size(); ++s) {
      const auto& segment = domain_.segments[s];
      const Point from = domain_.points[segment.from], along = domain_.points[segment.to] - from;
      const double length = geometry::norm(along);
      for (double x = 0; x <= length;) {
        const Point p = from + (x / length) * along;
        const double size = std::min(size_at(p, segment.left), size_at(p, segment.right));
        look_around(s, p, x, size);
        x = x < length ? std::min(length, x + std::max(0.5 * size, 1e-4 * length)) : 2 * length;
      }
    }
    network_.throw_if_near(least_over_size, "the size asked for is");
  }

 private:
  Index region(Index face) const { return face < 0 ? -1 : domain_.faces[face].region; }
  double size_at(Point p, Index face) const {
    return face < 0 ? std::numeric_limits<double>::infinity() : sizes_.at(p, region(face));
  }

  void look_around(std::size_t own, Point p, double x, double size) {
    const auto& segment = domain_.segments[own];
    const double length = geometry::distance(domain_.points[segment.from], domain_.points[segment.to]);
    for (std::size_t s = 0; s < domain_.segments.size(); ++s) {
      const auto& other = domain_.segments[s];
      if (s == own || (!network_.is_joint(line_of_[own]) && !network_.is_joint(line_of_[s]))) continue;
      const Point a = domain_.points[other.from], b = domain_.points[other.to];
      double t = 0;
      const double distance = geometry::distance_to_segment(p, a, b, &t);
      if (distance >= least_over_size * size) continue;
      const Start ends = {{{segment.from, x}, {segment.to, length - x}}};
      const double beside = reach * size, whole = geometry::distance(a, b);
      if (network_.way(ends, other.from, beside) + t * whole < beside) continue;
      if (network_.way(ends, other.to, beside) + (1 - t) * whole < beside) continue;
      const bool meet = network_.meet(ends, other.from, 2 * beside, line_of_[own], line_of_[s]) ||
                        network_.meet(ends, other.to, 2 * beside, line_of_[own], line_of_[s]);
      network_.note({line_of_[own], line_of_[s], distance, size, meet, p});
    }
  }

  const Domain& domain_;
  const SizeField& sizes_;
  std::vector<Index> line_of_;
  Network network_;
};

}  // namespace

void require_lines_apart(const Mesh& mesh, const std::vector<JointLine>& joints) {
  MeshLines(mesh, joints).require_apart();
}

void require_lines_apart(const Domain& domain, const SizeField& sizes) {
  DrawnLines(domain, sizes).require_apart();
}

}  // namespace ashlar::mesh
