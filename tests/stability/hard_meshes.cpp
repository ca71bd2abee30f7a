#include "stability/hard_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

#include "geometry/polygon.hpp"
#include "mesh/domain.hpp"
#include "testing/meshes.hpp"

namespace ashlar::stability {

namespace {

using geometry::Ring;

Ring corners(const mesh::RawMesh& raw, Index cell) {
  Ring ring;
  for (const Index p : raw.cell_points[cell]) ring.push_back(raw.points[static_cast<std::size_t>(p)]);
  return ring;
}

/// The border of cells taken together, or nothing if it is not one ring that visits no point twice.
std::vector<Index> border(const mesh::RawMesh& raw, std::span<const Index> cells) {
  std::set<std::pair<Index, Index>> edges;
  for (const Index cell : cells) {
    const auto points = raw.cell_points[cell];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Index a = points[i], b = points[(i + 1) % points.size()];
      if (edges.erase({b, a}) == 0) edges.insert({a, b});
    }
  }
  std::map<Index, Index> next;
  for (const auto& [a, b] : edges)
    if (!next.emplace(a, b).second) return {};
  if (next.empty()) return {};
  std::vector<Index> ring{next.begin()->first};
  while (ring.size() <= next.size()) {
    const Index to = next.at(ring.back());
    if (to == ring.front()) break;
    ring.push_back(to);
  }
  return ring.size() == next.size() ? ring : std::vector<Index>{};
}

mesh::RawMesh joined_lists(const mesh::RawMesh& raw, const std::vector<std::vector<Index>>& groups) {
  mesh::RawMesh made;
  made.points = raw.points;
  for (const auto& cells : groups) {
    const std::vector<Index> ring = border(raw, cells);
    if (ring.empty()) throw std::logic_error("joined cells are no simple polygon");
    made.cell_points.append(ring);
    made.cell_region.push_back(0);
  }
  return made;
}

/// Where the ray at an angle from the middle of the unit square leaves it.
Point on_square(double angle) {
  const Point d{std::cos(angle), std::sin(angle)};
  const double reach = 0.5 / std::max(std::abs(d.x), std::abs(d.y));
  return {0.5 + reach * d.x, 0.5 + reach * d.y};
}

}  // namespace

mesh::Mesh bare(mesh::RawMesh raw) {
  if (raw.regions.empty()) raw.regions = {"square"};
  return mesh::build_mesh(std::move(raw), mesh::Domain{});
}

mesh::RawMesh around(std::span<const Point> ring, const std::function<double(std::size_t)>& angle) {
  mesh::RawMesh raw;
  const std::size_t n = ring.size();
  for (const Point p : ring) raw.points.push_back(Point{0.5, 0.5} + p);
  for (std::size_t i = 0; i < n; ++i) raw.points.push_back(on_square(angle(i)));
  std::vector<Index> middle(n);
  std::iota(middle.begin(), middle.end(), 0);
  raw.cell_points.append(middle);
  raw.cell_region.push_back(0);
  const double turn = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double from = angle(i), to = j == 0 ? angle(0) + turn : angle(j);
    std::vector<Index> cell{static_cast<Index>(i), static_cast<Index>(n + i)};
    for (int c = 0; c < 8; ++c) {
      const double corner = (0.25 + 0.5 * c) * std::numbers::pi;
      if (corner <= from + 1e-9 || corner >= to - 1e-9) continue;
      cell.push_back(static_cast<Index>(raw.points.size()));
      raw.points.push_back({c % 4 == 0 || c % 4 == 3 ? 1.0 : 0.0, c % 4 < 2 ? 1.0 : 0.0});
    }
    cell.insert(cell.end(), {static_cast<Index>(n + j), static_cast<Index>(j)});
    raw.cell_points.append(cell);
    raw.cell_region.push_back(0);
  }
  return raw;
}

mesh::RawMesh regular_cell(int n, double flat) {
  const auto angle = [n](std::size_t i) { return 0.1 + 2 * std::numbers::pi * static_cast<double>(i) / n; };
  Ring ring;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
    ring.push_back({0.25 * std::cos(angle(i)), 0.25 * flat * std::sin(angle(i))});
  return around(ring, angle);
}

mesh::RawMesh star_cell(int n) {
  const auto angle = [n](std::size_t i) { return 0.1 + std::numbers::pi * static_cast<double>(i) / n; };
  Ring ring;
  for (std::size_t i = 0; i < static_cast<std::size_t>(2 * n); ++i) {
    const double radius = i % 2 == 0 ? 0.35 : 0.06;
    ring.push_back({radius * std::cos(angle(i)), radius * std::sin(angle(i))});
  }
  return around(ring, angle);
}

mesh::RawMesh joined(const mesh::RawMesh& raw, const std::function<int(Point)>& group) {
  std::map<int, std::vector<Index>> cells;
  for (Index cell = 0; cell < raw.cell_points.size(); ++cell)
    cells[group(geometry::centroid(corners(raw, cell)))].push_back(cell);
  std::vector<std::vector<Index>> lists;
  for (auto& [name, list] : cells) lists.push_back(std::move(list));
  return joined_lists(raw, lists);
}

mesh::RawMesh c_shaped(int n) {
  const int side = 3 * n;
  return joined(testing::distorted_square(side, 0.15), [=](Point p) {
    const int x = static_cast<int>(p.x * side), y = static_cast<int>(p.y * side);
    const bool plug = y % 3 == 1 && x % 3 > 0;
    return 2 * ((y / 3) * n + x / 3) + (plug ? 1 : 0);
  });
}

mesh::RawMesh many_to_one(int n) {
  return joined(testing::structured_square(2 * n), [=](Point p) {
    if (p.x > 0.5) return 2 + static_cast<int>(p.y * 2 * n) * 2 * n + static_cast<int>(p.x * 2 * n);
    return p.y < 0.5 ? 0 : 1;
  });
}

mesh::RawMesh agglomerated(int n, int size, unsigned seed) {
  const mesh::RawMesh raw = testing::distorted_square(n, 0.2, seed);
  std::mt19937 random(seed);
  std::vector<Index> order(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  std::vector<char> taken(order.size());
  std::vector<std::vector<Index>> groups;
  for (const Index start : order) {
    if (taken[static_cast<std::size_t>(start)]) continue;
    std::vector<Index> heap{start};
    taken[static_cast<std::size_t>(start)] = 1;
    for (int tries = 0; tries < 6 * size && static_cast<int>(heap.size()) < size; ++tries) {
      const Index from = heap[random() % heap.size()];
      const int way = static_cast<int>(random() % 4), x = from % n + (way == 0) - (way == 1),
                y = from / n + (way == 2) - (way == 3);
      if (x < 0 || y < 0 || x >= n || y >= n || taken[static_cast<std::size_t>(y * n + x)]) continue;
      heap.push_back(y * n + x);
      if (border(raw, heap).empty())
        heap.pop_back();
      else
        taken[static_cast<std::size_t>(y * n + x)] = 1;
    }
    groups.push_back(std::move(heap));
  }
  return joined_lists(raw, groups);
}

mesh::RawMesh mapped(mesh::RawMesh raw, const std::function<Point(Point)>& map) {
  for (Point& p : raw.points) p = map(p);
  return raw;
}

mesh::RawMesh renumbered(const mesh::RawMesh& raw, unsigned seed) {
  std::mt19937 random(seed);
  const auto shuffled = [&](std::size_t count) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
  };
  const std::vector<Index> point = shuffled(raw.points.size());  // new number of each
  const std::vector<Index> cell = shuffled(static_cast<std::size_t>(raw.cell_points.size()));
  mesh::RawMesh made;
  made.regions = raw.regions;
  made.points.resize(raw.points.size());
  for (std::size_t p = 0; p < point.size(); ++p)
    made.points[static_cast<std::size_t>(point[p])] = raw.points[p];
  for (const Index c : cell) {
    std::vector<Index> ring;
    for (const Index p : raw.cell_points[c]) ring.push_back(point[static_cast<std::size_t>(p)]);
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random() % ring.size()), ring.end());
    made.cell_points.append(ring);
    made.cell_region.push_back(raw.cell_region[static_cast<std::size_t>(c)]);
  }
  return made;
}

}  // namespace ashlar::stability
