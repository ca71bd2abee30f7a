#include "corners.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/polygon.hpp"

namespace ashlar::meshing_voronoi {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double square = pi / 4;       // half-angle of a square corner cell
constexpr double widest = 0.28 * pi;    // half-angles are not raised beyond this
constexpr double straight = 0.78 * pi;  // sectors of a smooth point are at least this wide
constexpr double acute = 0.47 * pi;     // wider sectors need no smaller balls beside them
constexpr double apart = 0.2 * pi;      // least angle between sites of a sector that do not coincide
constexpr double share = 0.49;          // of the distance between two segments, for each one's balls
constexpr double same_curve = 0.6;      // chord over arc length: nearer segments belong to one curve

void add_spokes(const mesh::Domain& domain, std::vector<Corner>& corners) {
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const auto& segment = domain.segments[s];
    const Point d = domain.points[segment.to] - domain.points[segment.from];
    const double length = geometry::norm(d);
    const Index index = static_cast<Index>(s);
    corners[segment.from].spokes.push_back({index, true, std::atan2(d.y, d.x), length, segment.left, 0, 0});
    corners[segment.to].spokes.push_back({index, false, std::atan2(-d.y, -d.x), length, segment.right, 0, 0});
  }
}

// Where two sites of one sector would lie close together, one half-angle grows until they coincide.
void close_gaps(std::vector<Spoke>& spokes) {
  const std::size_t n = spokes.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (const bool forward : {true, false}) {
      const std::size_t next = (k + 1) % n;
      const double gap = spokes[k].sector - spokes[k].half - spokes[next].half;
      if (gap < 1e-9 || gap > apart) continue;
      Spoke& raised = forward ? spokes[next] : spokes[k];
      const Spoke& beyond = forward ? spokes[(next + 1) % n] : spokes[(k + n - 1) % n];
      const double other_sector = forward ? raised.sector : beyond.sector;
      const double left_over = other_sector - raised.half - gap - beyond.half;
      const bool fits = left_over > apart || std::abs(left_over) < 1e-9;
      if (n > 1 && raised.half + gap <= widest && fits) raised.half += gap;
    }
  }
}

void choose_half_angles(Corner& corner) {
  auto& spokes = corner.spokes;
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.angle < b.angle; });
  const std::size_t n = spokes.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = spokes[(k + 1) % n].angle - spokes[k].angle;
    spokes[k].sector = turn > 0 ? turn : turn + 2 * pi;
  }
  for (std::size_t k = 0; k < n; ++k) {
    spokes[k].half = std::min({square, 0.5 * spokes[k].sector, 0.5 * spokes[(k + n - 1) % n].sector});
  }
  close_gaps(spokes);
  corner.smooth = n == 2 && std::min(spokes[0].sector, spokes[1].sector) > straight;
}

// True if the way along smooth points from `segment` at p to `other` is hardly longer than the distance:
// both are chords of one gentle curve.
bool on_one_curve(const mesh::Domain& domain, const std::vector<Corner>& corners, Index segment, Index other,
                  Point p, double distance) {
  for (const bool onward : {true, false}) {
    Index at = segment;
    Index point = onward ? domain.segments[at].to : domain.segments[at].from;
    double length = geometry::distance(p, domain.points[point]);
    while (corners[point].smooth && length <= distance / same_curve) {
      const auto& spokes = corners[point].spokes;
      const Spoke& next = spokes[0].segment == at ? spokes[1] : spokes[0];
      if (next.segment == other) return true;
      at = next.segment;
      length += next.length;
      point = next.outward ? domain.segments[at].to : domain.segments[at].from;
    }
  }
  return false;
}

// A ball at distance x from a corner stays in its own half of each sector beside its segment.
double room_beside_corner(const Corner& corner, Index segment, double x) {
  if (corner.smooth) return std::numeric_limits<double>::infinity();
  const std::size_t n = corner.spokes.size();
  double angle = pi;
  for (std::size_t k = 0; k < n; ++k) {
    if (corner.spokes[k].segment == segment) {
      angle = std::min({angle, corner.spokes[k].sector, corner.spokes[(k + n - 1) % n].sector});
    }
  }
  return angle < acute ? x * std::sin(0.5 * angle) : std::numeric_limits<double>::infinity();
}

bool joined(const mesh::Domain::Segment& a, const mesh::Domain::Segment& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

double room_of_corner(const mesh::Domain& domain, Index point) {
  double room = std::numeric_limits<double>::infinity();
  const Point p = domain.points[point];
  for (const auto& segment : domain.segments) {
    if (segment.from == point || segment.to == point) continue;
    room = std::min(room,
                    geometry::distance_to_segment(p, domain.points[segment.from], domain.points[segment.to]));
  }
  return room;
}

}  // namespace

Index region_of(const mesh::Domain& domain, Index face) {
  return face < 0 ? -1 : domain.faces[face].region;
}

std::vector<Corner> find_corners(const mesh::Domain& domain) {
  std::vector<Corner> corners(domain.points.size());
  add_spokes(domain, corners);
  for (Corner& corner : corners) {
    if (!corner.spokes.empty()) choose_half_angles(corner);
  }
  return corners;
}

double room_at(const mesh::Domain& domain, const std::vector<Corner>& corners, Index segment, Point p,
               double enough) {
  const auto& own = domain.segments[segment];
  double room = enough;
  for (const Index end : {own.from, own.to}) {
    const double x = geometry::distance(p, domain.points[end]);
    room = std::min(room, room_beside_corner(corners[end], segment, x));
  }
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const auto& other = domain.segments[s];
    if (joined(own, other)) continue;
    const double distance =
        geometry::distance_to_segment(p, domain.points[other.from], domain.points[other.to]);
    if (share * distance >= room) continue;
    if (on_one_curve(domain, corners, segment, static_cast<Index>(s), p, distance)) continue;
    room = share * distance;
  }
  return room;
}

void size_corners(const mesh::Domain& domain, const mesh::SizeField& sizes, std::vector<Corner>& corners) {
  for (std::size_t c = 0; c < corners.size(); ++c) {
    Corner& corner = corners[c];
    if (corner.spokes.empty() || corner.smooth) continue;
    double size = std::numeric_limits<double>::infinity();
    for (const Spoke& spoke : corner.spokes) {
      size = std::min(size, sizes.at(domain.points[c], region_of(domain, spoke.face)));
    }
    double radius = share * room_of_corner(domain, static_cast<Index>(c));
    for (const Spoke& spoke : corner.spokes) {
      // A sharp corner gets one longer cell of ordinary area instead of many tiny ones.
      const double stretch = std::min(3.0, 1 / std::sqrt(std::sin(2 * std::min(spoke.half, square))));
      const double steps = std::max(3.0, std::ceil(spoke.length / (size * stretch) - 0.2));
      const double first = std::min(size * stretch, spoke.length / steps);
      radius = std::min(radius, first * std::cos(spoke.half));
    }
    corner.radius = radius;
  }
}

}  // namespace ashlar::meshing_voronoi
