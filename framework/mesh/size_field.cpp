#include "mesh/size_field.hpp"

#include <algorithm>
#include <array>

#include "mesh/quadtree.hpp"

namespace ashlar::mesh {

namespace {

constexpr Index grid_cells = 64;
constexpr std::size_t leaf_sources = 12;
constexpr int deepest = 24;
constexpr double one_is_enough = 0.06;  // boxes over which sizes change by less keep one source

double distance_to(const SizeSource& source, Point p) {
  const Point d = source.b - source.a;
  const double length2 = dot(d, d);
  const double t = length2 > 0 ? std::clamp(dot(p - source.a, d) / length2, 0.0, 1.0) : 0.0;
  return geometry::distance(p, source.a + t * d);
}

}  // namespace

SizeField::SizeField(const Domain& domain, double size, double grading)
    : SizeField(domain, std::vector<double>(domain.regions.size(), size), grading) {}

SizeField::SizeField(const Domain& domain, std::vector<double> region_sizes, double grading)
    : region_sizes_(std::move(region_sizes)), grading_(grading) {
  least_ = *std::min_element(region_sizes_.begin(), region_sizes_.end());
  greatest_ = *std::max_element(region_sizes_.begin(), region_sizes_.end());
  set_box(domain);
  if (least_ < greatest_) add_region_steps(domain);
}

void SizeField::set_box(const Domain& domain) {
  low_ = high_ = domain.points.front();
  for (const Point p : domain.points) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  center_ = 0.5 * (low_ + high_);
  half_ = 0.505 * std::max(high_.x - low_.x, high_.y - low_.y);
}

// Where regions of different sizes meet, the finer size reaches into the coarser region by the grading.
void SizeField::add_region_steps(const Domain& domain) {
  for (const auto& segment : domain.segments) {
    if (segment.left < 0 || segment.right < 0) continue;
    const Index left = domain.faces[segment.left].region, right = domain.faces[segment.right].region;
    if (left < 0 || right < 0 || region_sizes_[left] == region_sizes_[right]) continue;
    add({domain.points[segment.from], domain.points[segment.to],
         std::min(region_sizes_[left], region_sizes_[right]), 0});
  }
}

void SizeField::sample(const core::Function& function, const core::Place& place) {
  const double extent = std::max(high_.x - low_.x, high_.y - low_.y);
  grid_.origin = low_;
  grid_.step = extent / grid_cells;
  grid_.columns = static_cast<Index>(std::ceil((high_.x - low_.x) / grid_.step)) + 1;
  grid_.rows = static_cast<Index>(std::ceil((high_.y - low_.y) / grid_.step)) + 1;
  grid_.values.reserve(static_cast<std::size_t>(grid_.columns) * grid_.rows);
  for (Index j = 0; j < grid_.rows; ++j) {
    for (Index i = 0; i < grid_.columns; ++i) {
      const std::array<double, 2> at = {std::min(low_.x + i * grid_.step, high_.x),
                                        std::min(low_.y + j * grid_.step, high_.y)};
      const std::vector<double> result = function.call(at);
      if (result.size() != 1 || !(result[0] > 0) || !std::isfinite(result[0])) {
        core::Mistake mistake;
        mistake.place = place;
        const std::string got = result.size() == 1 ? core::format_quantity(result[0], {1, 0, 0})
                                                   : std::to_string(result.size()) + " values";
        mistake.what = "the size must be one number above 0 m, but is " + got + " at (" +
                       core::format_quantity(at[0], {}) + ", " + core::format_quantity(at[1], {}) + ")";
        throw core::InputError(mistake);
      }
      grid_.values.push_back(result[0]);
    }
  }
  limit_grid();
  least_ = *std::min_element(grid_.values.begin(), grid_.values.end());
  greatest_ = *std::max_element(grid_.values.begin(), grid_.values.end());
}

// Chamfer sweeps: each node may exceed a neighbour by at most grading × distance.
void SizeField::limit_grid() {
  const auto value = [this](Index i, Index j) -> double& { return grid_.values[j * grid_.columns + i]; };
  const double straight = grading_ * grid_.step, diagonal = std::sqrt(2.0) * straight;
  const auto limit = [&](Index i, Index j, Index side) {
    const auto from = [&](Index ii, Index jj, double growth) {
      if (ii < 0 || jj < 0 || ii >= grid_.columns || jj >= grid_.rows) return;
      value(i, j) = std::min(value(i, j), value(ii, jj) + growth);
    };
    from(i + side, j, straight);
    from(i, j + side, straight);
    from(i + side, j + side, diagonal);
    from(i - side, j + side, diagonal);
  };
  for (Index j = 0; j < grid_.rows; ++j)
    for (Index i = 0; i < grid_.columns; ++i) limit(i, j, -1);
  for (Index j = grid_.rows - 1; j >= 0; --j)
    for (Index i = grid_.columns - 1; i >= 0; --i) limit(i, j, +1);
}

double SizeField::grid_value(Point p) const {
  const double x = std::clamp((p.x - grid_.origin.x) / grid_.step, 0.0, grid_.columns - 1.0);
  const double y = std::clamp((p.y - grid_.origin.y) / grid_.step, 0.0, grid_.rows - 1.0);
  const Index i = std::min(static_cast<Index>(x), std::max(grid_.columns - 2, 0));
  const Index j = std::min(static_cast<Index>(y), std::max(grid_.rows - 2, 0));
  const Index right = std::min(i + 1, grid_.columns - 1), up = std::min(j + 1, grid_.rows - 1);
  const double u = x - i, v = y - j;
  const auto value = [this](Index a, Index b) { return grid_.values[b * grid_.columns + a]; };
  return (1 - v) * ((1 - u) * value(i, j) + u * value(right, j)) +
         v * ((1 - u) * value(i, up) + u * value(right, up));
}

double SizeField::base(Point p, Index region) const {
  if (!grid_.values.empty()) return grid_value(p);
  return region < 0 ? least_ : region_sizes_[region];
}

double SizeField::value_of(const SizeSource& source, Point p) const {
  return source.size + grading_ * std::max(0.0, distance_to(source, p) - source.radius);
}

// A source matters in a box if somewhere in it it can be the least: all values change by at most
// grading × distance.
std::vector<Index> SizeField::relevant(const std::vector<Index>& candidates, Point center,
                                       double half) const {
  const double slack = grading_ * half * std::sqrt(2.0);
  std::vector<double> values(candidates.size());
  double best = greatest_;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    values[k] = value_of(sources_[candidates[k]], center);
    best = std::min(best, values[k]);
  }
  const bool small = slack < one_is_enough * best;
  std::vector<Index> kept;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (small ? values[k] == best && kept.empty() : values[k] - slack <= best + slack) {
      kept.push_back(candidates[k]);
    }
  }
  return kept;
}

void SizeField::build(Index node, Point center, double half, const std::vector<Index>& candidates,
                      int depth) {
  if (candidates.size() <= leaf_sources || depth == deepest) {
    nodes_[node].begin = static_cast<Index>(lists_.size());
    lists_.insert(lists_.end(), candidates.begin(), candidates.end());
    nodes_[node].end = static_cast<Index>(lists_.size());
    return;
  }
  const Index child = static_cast<Index>(nodes_.size());
  nodes_.resize(nodes_.size() + 4);
  nodes_[node].child = child;
  for (Index k = 0; k < 4; ++k) {
    const double quarter = 0.5 * half;
    const Point c = center + Point{k & 1 ? quarter : -quarter, k & 2 ? quarter : -quarter};
    build(child + k, c, quarter, relevant(candidates, c, quarter), depth + 1);
  }
}

void SizeField::prepare() {
  nodes_.assign(1, Node{});
  lists_.clear();
  std::vector<Index> all(sources_.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<Index>(k);
  build(0, center_, half_, all, 0);
}

double SizeField::at(Point p, Index region) const {
  double size = base(p, region);
  if (sources_.empty()) return size;
  const Index node = leaf_at(nodes_, center_, half_, p);
  for (Index k = nodes_[node].begin; k < nodes_[node].end; ++k) {
    size = std::min(size, value_of(sources_[lists_[k]], p));
  }
  return size;
}

}  // namespace ashlar::mesh
