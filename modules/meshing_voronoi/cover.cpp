#include "cover.hpp"

#include <algorithm>
#include <string>

#include "corners.hpp"
#include "mesh/quadtree.hpp"
#include "random.hpp"

namespace ashlar::meshing_voronoi {

namespace {

constexpr double keep_off = 1.05;  // of a ball's radius: interior sites stay farther out
constexpr double begin_off =
    1.5;  // and begin farther out: a cell must fit between them and the border's cells
constexpr double leaf_size = 0.6;  // of the wished size
constexpr std::size_t most_leaves = 40'000'000;
constexpr int tries = 12;  // for a free place in a leaf that balls partly cover
constexpr Index most_bands = 2048;

}  // namespace

FaceLocator::FaceLocator(const mesh::Domain& domain) : domain_(domain) {
  double high = domain.points.front().y;
  low_ = high;
  for (const Point p : domain.points) {
    low_ = std::min(low_, p.y);
    high = std::max(high, p.y);
  }
  const Index count = std::clamp(static_cast<Index>(domain.segments.size()), Index{1}, most_bands);
  bands_.resize(count);
  step_ = (high - low_) / count;
  const auto band = [&](double y) {
    return std::clamp(static_cast<Index>((y - low_) / step_), Index{0}, count - 1);
  };
  for (std::size_t s = 0; s < domain.segments.size(); ++s) {
    const double a = domain.points[domain.segments[s].from].y, b = domain.points[domain.segments[s].to].y;
    for (Index k = band(std::min(a, b)); k <= band(std::max(a, b)); ++k) {
      bands_[k].push_back(static_cast<Index>(s));
    }
  }
}

// The first segment met by the ray from p to the right tells the face.
Index FaceLocator::at(Point p) const {
  const double place = (p.y - low_) / step_;
  if (!(place >= 0) || place >= static_cast<double>(bands_.size())) return -1;
  double nearest = std::numeric_limits<double>::infinity();
  Index face = -1;
  for (const Index s : bands_[static_cast<std::size_t>(place)]) {
    const auto& segment = domain_.segments[s];
    const Point a = domain_.points[segment.from], b = domain_.points[segment.to];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double x = a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
    if (x < p.x || x >= nearest) continue;
    nearest = x;
    face = b.y > a.y ? segment.left : segment.right;
  }
  return region_of(domain_, face) < 0 ? -1 : face;
}

/// Order of a node's quarters on the Hilbert curve and the turns inside them, as in the classic recursion
/// with start point and two axes.
struct Cover::Turn {
  Point across, along;  ///< the curve starts at −across−along, ends at +across−along
};

Cover::Cover(const mesh::Domain& domain, const mesh::SizeField& sizes, const Border& border)
    : domain_(domain), sizes_(sizes), balls_(border.balls), locator_(domain) {
  Point low = domain.points.front(), high = low;
  for (const Point p : domain.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  center_ = 0.5 * (low + high);
  half_ = 0.5001 * std::max(high.x - low.x, high.y - low.y);
  std::vector<Index> balls;
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    if (balls_[b].radius > 0) balls.push_back(static_cast<Index>(b));
  }
  nodes_.emplace_back();
  build(0, center_, half_, balls, {{1, 0}, {0, 1}});
}

double Cover::size_at(Point p, Index face) const {
  return sizes_.at(p, region_of(domain_, face));
}

void Cover::build(Index node, Point center, double half, const std::vector<Index>& balls, Turn turn) {
  // A node without balls lies in one face: borders are covered by balls.
  const Index face = locator_.at(center);
  if (balls.empty() && face < 0) return;
  if (2 * half <= leaf_size * size_at(center, face)) {
    add_leaf(node, center, half, balls);
    return;
  }
  if (nodes_.size() > most_leaves) {
    core::Mistake mistake;
    mistake.what = "mesh.voronoi would need more than ten million cells";
    mistake.advice = "ask for larger cells, or remove details that are very small";
    throw core::InputError(mistake);
  }
  const Index child = static_cast<Index>(nodes_.size());
  nodes_.resize(nodes_.size() + 4);
  nodes_[node].child = child;
  const Point u = turn.across, v = turn.along;
  const std::array<Point, 4> quarters = {Point{0, 0} - u - v, v - u, u + v, u - v};
  const std::array<Turn, 4> turns = {Turn{v, u}, turn, turn, Turn{-1.0 * v, -1.0 * u}};
  for (int k = 0; k < 4; ++k) {
    const double h = 0.5 * half;
    const Point c = center + h * quarters[k];
    std::vector<Index> inside;
    for (const Index b : balls) {
      const double dx = std::max(0.0, std::abs(balls_[b].center.x - c.x) - h);
      const double dy = std::max(0.0, std::abs(balls_[b].center.y - c.y) - h);
      if (std::hypot(dx, dy) <= begin_off * balls_[b].radius) inside.push_back(b);
    }
    build(child + (c.x > center.x ? 1 : 0) + (c.y > center.y ? 2 : 0), c, h, inside, turns[k]);
  }
}

bool Cover::near_balls(const Node& node, Point p) const {
  for (Index k = node.begin; k < node.end; ++k) {
    const Ball& ball = balls_[lists_[k]];
    if (geometry::distance(p, ball.center) < begin_off * ball.radius) return true;
  }
  return false;
}

void Cover::add_leaf(Index node, Point center, double half, const std::vector<Index>& balls) {
  nodes_[node].begin = static_cast<Index>(lists_.size());
  lists_.insert(lists_.end(), balls.begin(), balls.end());
  nodes_[node].end = static_cast<Index>(lists_.size());
  Leaf leaf{center, half, 0, node, -1};
  if (balls.empty()) {
    leaf.face = locator_.at(center);
    const double size = size_at(center, leaf.face);
    leaf.mass = 4 * half * half / (size * size);
    cells_ += leaf.mass;
  } else {
    for (const Point corner : {Point{-1, -1}, Point{1, -1}, Point{-1, 1}, Point{1, 1}}) {
      const Point p = center + 0.5 * half * corner;
      const Index face = locator_.at(p);
      if (face < 0) continue;
      const double size = size_at(p, face);
      const double mass = half * half / (size * size);
      cells_ += mass;
      if (!near_balls(nodes_[node], p)) leaf.mass += mass;
    }
  }
  if (leaf.mass == 0) return;
  mass_ += leaf.mass;
  leaf.mass = mass_;
  leaves_.push_back(leaf);
}

Index Cover::ball_at(Point p) const {
  const Index node = mesh::leaf_at(nodes_, center_, half_, p);
  for (Index k = nodes_[node].begin; k < nodes_[node].end; ++k) {
    const Ball& ball = balls_[lists_[k]];
    if (geometry::distance(p, ball.center) < keep_off * ball.radius) return lists_[k];
  }
  return -1;
}

// One site per equal share of the mass along the curve: well spread from the start, and exactly `count`.
std::vector<Site> Cover::sample(Index count, std::uint64_t seed) const {
  std::vector<Site> sites;
  if (leaves_.empty()) return sites;
  Random random(seed);
  std::size_t k = 0;
  for (Index i = 0; i < count; ++i) {
    const double wanted = (i + 0.25 + 0.5 * random.unit()) * mass_ / count;
    while (k + 1 < leaves_.size() && leaves_[k].mass < wanted) ++k;
    for (std::size_t shift = 0;; ++shift) {
      const Leaf& leaf = leaves_[(k + shift) % leaves_.size()];
      bool placed = false;
      for (int attempt = 0; attempt < tries && !placed; ++attempt) {
        const Point p = leaf.center + leaf.half * Point{2 * random.unit() - 1, 2 * random.unit() - 1};
        if (near_balls(nodes_[leaf.node], p)) continue;
        const Index face = leaf.face >= 0 ? leaf.face : locator_.at(p);
        if (face < 0) continue;
        sites.push_back({p, face, {-1, -1, -1, -1}});
        placed = true;
      }
      if (placed) break;
      if (shift == leaves_.size()) return sites;
    }
  }
  return sites;
}

}  // namespace ashlar::meshing_voronoi
