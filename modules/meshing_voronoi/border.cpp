#include "border.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "corners.hpp"

namespace ashlar::meshing_voronoi {

namespace {

constexpr double sqrt2 = std::numbers::sqrt2;
constexpr double notable =
    0.85;  // smaller sizes than this share of the wish are graded into the surroundings
constexpr double flattest = 0.15;  // least distance of sites from their piece, over its length
constexpr double coincide = 1e-9;  // angle [rad] below which two sites of a sector are one
constexpr double widest_gap = 0.56 * std::numbers::pi;  // between sites around a corner
constexpr double shrink = 0.7;                          // of the size where balls are in each other's way
constexpr int most_rounds = 40;

/// A segment's balls in order; those at its ends belong to the corners.
struct Chain {
  std::vector<Index> balls;
  std::vector<double> positions;  ///< along the segment
};

/// What stood in the way: a corner whose ball must shrink, or else a spot that needs a smaller size.
struct Fault {
  Index corner = -1;
  Point at;
  double size = 0;
};

class Protector {
 public:
  Protector(const mesh::Domain& domain, mesh::SizeField& sizes, std::vector<Corner> corners)
      : domain_(domain), sizes_(sizes), corners_(std::move(corners)) {}

  /// Corner balls, and sources in the size field where there is little room.
  void prepare();
  /// One attempt; what went wrong.
  std::vector<Fault> run();
  void amend(const std::vector<Fault>& faults);
  Border take() { return std::move(border_); }

 private:
  double size_on(Index segment, Point p) const;
  Point point_on(Index segment, double x) const;
  double length_of(Index segment) const;
  const Spoke& spoke_at(Index segment, bool outward) const;
  std::array<double, 2> free_span(Index segment) const;
  void note(Index segment, Point p, double size);
  void note_corner(Index corner);
  void note_room(Index segment);
  Fault shrink_ball(Index ball) const;
  void place_corner_balls();
  void place_balls(Index segment);
  std::vector<double> spread(Index segment, double from, double to) const;
  void smooth_radii();
  void place_pairs(std::vector<Fault>& faults);
  void place_around_corners();
  Index ball_beside(const Spoke& spoke) const;
  void add_site(Point at, Index face, std::array<Index, 4> balls);
  void find_overlaps(std::vector<Fault>& faults) const;

  const mesh::Domain& domain_;
  mesh::SizeField& sizes_;
  std::vector<Corner> corners_;
  std::vector<Chain> chains_;
  std::vector<Index> corner_of_ball_;  ///< of corners' own balls and of those that they fix
  Border border_;
};

double Protector::size_on(Index segment, Point p) const {
  const auto& s = domain_.segments[segment];
  const Index left = region_of(domain_, s.left), right = region_of(domain_, s.right);
  if (left < 0 || right < 0) return sizes_.at(p, std::max(left, right));
  return std::min(sizes_.at(p, left), sizes_.at(p, right));
}

Point Protector::point_on(Index segment, double x) const {
  const auto& s = domain_.segments[segment];
  const Point a = domain_.points[s.from], b = domain_.points[s.to];
  return a + (x / length_of(segment)) * (b - a);
}

double Protector::length_of(Index segment) const {
  const auto& s = domain_.segments[segment];
  return geometry::distance(domain_.points[s.from], domain_.points[s.to]);
}

const Spoke& Protector::spoke_at(Index segment, bool outward) const {
  const auto& s = domain_.segments[segment];
  const auto& spokes = corners_[outward ? s.from : s.to].spokes;
  return *std::find_if(spokes.begin(), spokes.end(), [&](const Spoke& spoke) {
    return spoke.segment == segment && spoke.outward == outward;
  });
}

// The part of a segment between the balls that its corners fix: the first ball touches the ray to the site.
std::array<double, 2> Protector::free_span(Index segment) const {
  const auto& s = domain_.segments[segment];
  const double length = length_of(segment);
  const auto first = [&](Index point, bool outward) {
    const Corner& corner = corners_[point];
    return corner.smooth ? 0.0 : corner.radius / std::cos(spoke_at(segment, outward).half);
  };
  return {first(s.from, true), length - first(s.to, false)};
}

void Protector::note(Index segment, Point p, double size) {
  if (size < notable * size_on(segment, p)) sizes_.add({p, p, size, 0});
}

// The first balls beside a corner may be small; cells grow gradually from there.
void Protector::note_corner(Index corner) {
  if (corners_[corner].smooth) return;
  for (const Spoke& spoke : corners_[corner].spokes) {
    const double offset = corners_[corner].radius / std::cos(spoke.half);
    const double x = spoke.outward ? offset : spoke.length - offset;
    note(spoke.segment, point_on(spoke.segment, x), sqrt2 * offset * std::sin(spoke.half));
  }
}

void Protector::note_room(Index segment) {
  const auto [from, to] = free_span(segment);
  const double length = length_of(segment);
  note(segment, point_on(segment, 0.5 * length), 1.2 * (to - from));
  for (double x = from; x < to;) {
    const Point p = point_on(segment, x);
    const double size = sqrt2 * room_at(domain_, corners_, segment, p, size_on(segment, p) / sqrt2);
    note(segment, p, size);
    x += 0.5 * std::max(size, 1e-6 * length);
  }
}

// Corners are sized by the wish alone, before small sizes beside them are noted: else both would shrink in
// turn.
void Protector::prepare() {
  size_corners(domain_, sizes_, corners_);
  for (Index c = 0; c < static_cast<Index>(corners_.size()); ++c) note_corner(c);
  for (Index s = 0; s < static_cast<Index>(domain_.segments.size()); ++s) note_room(s);
  sizes_.prepare();
}

void Protector::amend(const std::vector<Fault>& faults) {
  std::vector<Index> shrunk;
  for (const Fault& fault : faults) {
    if (fault.corner >= 0) {
      shrunk.push_back(fault.corner);
    } else {
      sizes_.add({fault.at, fault.at, fault.size, 0});
    }
  }
  std::sort(shrunk.begin(), shrunk.end());
  shrunk.erase(std::unique(shrunk.begin(), shrunk.end()), shrunk.end());
  for (const Index corner : shrunk) {
    corners_[corner].radius *= shrink;
    note_corner(corner);
  }
  sizes_.prepare();
}

Fault Protector::shrink_ball(Index ball) const {
  const Ball& b = border_.balls[ball];
  return {corner_of_ball_[ball], b.center, shrink * std::min(sqrt2 * b.radius, sizes_.at(b.center, -1))};
}

void Protector::place_corner_balls() {
  corner_of_ball_.clear();
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    border_.balls.push_back({domain_.points[c], corners_[c].radius});
    corner_of_ball_.push_back(corners_[c].smooth ? -1 : static_cast<Index>(c));
  }
}

// Positions that split [from, to] evenly in the measure ∫ dx / size, ends included.
std::vector<double> Protector::spread(Index segment, double from, double to) const {
  std::vector<double> x = {from}, measure = {0};
  double density = 1 / size_on(segment, point_on(segment, from));
  while (x.back() < to) {
    double next = x.back() + 0.25 / density;
    if (next > to - 0.05 / density) next = to;
    const double there = 1 / size_on(segment, point_on(segment, next));
    measure.push_back(measure.back() + 0.5 * (density + there) * (next - x.back()));
    x.push_back(next);
    density = there;
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(measure.back() - 0.2)));
  std::vector<double> positions = {from};
  std::size_t k = 0;
  for (int i = 1; i < pieces; ++i) {
    const double wanted = measure.back() * i / pieces;
    while (measure[k + 1] < wanted) ++k;
    positions.push_back(x[k] + (x[k + 1] - x[k]) * (wanted - measure[k]) / (measure[k + 1] - measure[k]));
  }
  positions.push_back(to);
  return positions;
}

void Protector::place_balls(Index segment) {
  const auto& s = domain_.segments[segment];
  const double length = length_of(segment);
  const auto [from, to] = free_span(segment);
  Chain& chain = chains_[segment];
  const auto add = [&](double x, double radius, Index corner) {
    chain.positions.push_back(x);
    chain.balls.push_back(static_cast<Index>(border_.balls.size()));
    border_.balls.push_back({point_on(segment, x), radius});
    corner_of_ball_.push_back(corner);
  };
  chain.positions.push_back(0);
  chain.balls.push_back(s.from);
  const std::vector<double> positions = spread(segment, from, to);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const bool first = k == 0, last = k + 1 == positions.size();
    if (first && from > 0) {
      add(from, corners_[s.from].radius * std::tan(spoke_at(segment, true).half), s.from);
    } else if (last && to < length) {
      add(to, corners_[s.to].radius * std::tan(spoke_at(segment, false).half), s.to);
    } else if (!first && !last) {
      add(positions[k], 0, -1);
    }
  }
  chain.positions.push_back(length);
  chain.balls.push_back(s.to);
}

// Balls that no corner fixes: √2 r = mean of the distances to both neighbours, so that cells are square.
void Protector::smooth_radii() {
  std::vector<double> sum(border_.balls.size(), 0.0);
  for (const Chain& chain : chains_) {
    for (std::size_t k = 0; k + 1 < chain.balls.size(); ++k) {
      const double spacing = chain.positions[k + 1] - chain.positions[k];
      sum[chain.balls[k]] += spacing;
      sum[chain.balls[k + 1]] += spacing;
    }
  }
  for (std::size_t b = 0; b < border_.balls.size(); ++b) {
    if (border_.balls[b].radius == 0) border_.balls[b].radius = sum[b] / (2 * sqrt2);
  }
}

void Protector::add_site(Point at, Index face, std::array<Index, 4> balls) {
  border_.sites.push_back({at, region_of(domain_, face) < 0 ? -1 : face, balls});
}

// Sites of one piece: where the circles of its balls cross. Pieces at fixed corners get theirs there.
void Protector::place_pairs(std::vector<Fault>& faults) {
  for (std::size_t s = 0; s < chains_.size(); ++s) {
    const auto& segment = domain_.segments[s];
    const Chain& chain = chains_[s];
    for (std::size_t k = 0; k + 1 < chain.balls.size(); ++k) {
      const Index from = chain.balls[k], to = chain.balls[k + 1];
      border_.pieces.push_back({from, to, segment.left, segment.right});
      const bool at_start = k == 0 && !corners_[segment.from].smooth;
      const bool at_end = k + 2 == chain.balls.size() && !corners_[segment.to].smooth;
      if (at_start || at_end) continue;
      const Ball& a = border_.balls[from];
      const Ball& b = border_.balls[to];
      const double length = chain.positions[k + 1] - chain.positions[k];
      const double along = (a.radius * a.radius - b.radius * b.radius + length * length) / (2 * length);
      const double height2 = a.radius * a.radius - along * along;
      if (height2 < flattest * flattest * length * length) {
        const Index larger = a.radius > b.radius ? from : to;
        const bool too_large = border_.balls[larger].radius > length && corner_of_ball_[larger] >= 0;
        faults.push_back(too_large ? shrink_ball(larger)
                                   : Fault{-1, 0.5 * (a.center + b.center), shrink * length});
        continue;
      }
      const Point t = (1 / length) * (b.center - a.center);
      const Point foot = a.center + along * t, offset = std::sqrt(height2) * geometry::left_of(t);
      add_site(foot + offset, segment.left, {from, to, -1, -1});
      add_site(foot - offset, segment.right, {from, to, -1, -1});
    }
  }
}

Index Protector::ball_beside(const Spoke& spoke) const {
  const auto& balls = chains_[spoke.segment].balls;
  return spoke.outward ? balls[1] : balls[balls.size() - 2];
}

void Protector::place_around_corners() {
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const Corner& corner = corners_[c];
    if (corner.smooth) continue;
    const Index ball = static_cast<Index>(c);
    const auto add = [&](double angle, Index face, Index first, Index second) {
      const Point direction{std::cos(angle), std::sin(angle)};
      add_site(domain_.points[c] + corner.radius * direction, face, {ball, first, second, -1});
    };
    for (std::size_t k = 0; k < corner.spokes.size(); ++k) {
      const Spoke& spoke = corner.spokes[k];
      const Spoke& next = corner.spokes[(k + 1) % corner.spokes.size()];
      const double gap = spoke.sector - spoke.half - next.half;
      const double begin = spoke.angle + spoke.half;
      if (gap < coincide) {
        add(begin + 0.5 * gap, spoke.face, ball_beside(spoke), ball_beside(next));
        continue;
      }
      add(begin, spoke.face, ball_beside(spoke), -1);
      add(begin + gap, spoke.face, ball_beside(next), -1);
      if (region_of(domain_, spoke.face) < 0) continue;
      const int parts = static_cast<int>(std::ceil(gap / widest_gap));
      for (int i = 1; i < parts; ++i) add(begin + gap * i / parts, spoke.face, -1, -1);
    }
  }
}

// Balls may overlap only with their neighbours along a segment (and touch at corners).
void Protector::find_overlaps(std::vector<Fault>& faults) const {
  const auto& balls = border_.balls;
  std::vector<std::array<Index, 2>> neighbours;
  for (const Piece& piece : border_.pieces) {
    neighbours.push_back({std::min(piece.from, piece.to), std::max(piece.from, piece.to)});
  }
  std::sort(neighbours.begin(), neighbours.end());
  std::vector<Index> order;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (balls[b].radius > 0) order.push_back(static_cast<Index>(b));
  }
  const auto left_end = [&](Index b) { return balls[b].center.x - balls[b].radius; };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(left_end(a), a) < std::pair(left_end(b), b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Ball& a = balls[order[i]];
    for (std::size_t j = i + 1; j < order.size() && left_end(order[j]) < a.center.x + a.radius; ++j) {
      const Ball& b = balls[order[j]];
      if (geometry::distance(a.center, b.center) > (1 - 1e-7) * (a.radius + b.radius)) continue;
      const std::array<Index, 2> pair = {std::min(order[i], order[j]), std::max(order[i], order[j])};
      if (std::binary_search(neighbours.begin(), neighbours.end(), pair)) continue;
      faults.push_back(shrink_ball(order[i]));
      faults.push_back(shrink_ball(order[j]));
    }
  }
}

std::vector<Fault> Protector::run() {
  border_ = {};
  place_corner_balls();
  chains_.assign(domain_.segments.size(), {});
  for (Index s = 0; s < static_cast<Index>(chains_.size()); ++s) place_balls(s);
  smooth_radii();
  std::vector<Fault> faults;
  place_pairs(faults);
  place_around_corners();
  find_overlaps(faults);
  return faults;
}

}  // namespace

Border protect(const mesh::Domain& domain, mesh::SizeField& sizes) {
  Protector protector(domain, sizes, find_corners(domain));
  protector.prepare();
  for (int round = 0;; ++round) {
    const std::vector<Fault> faults = protector.run();
    if (faults.empty()) return protector.take();
    protector.amend(faults);
    if (round < most_rounds) continue;
    core::Mistake mistake;
    mistake.what = "mesh.voronoi cannot follow the borders near (" + std::to_string(faults[0].at.x) + ", " +
                   std::to_string(faults[0].at.y) + ")";
    mistake.advice = "look for edges or joints that nearly touch there";
    throw core::InputError(mistake);
  }
}

}  // namespace ashlar::meshing_voronoi
