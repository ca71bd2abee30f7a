#include "geometry/polygon.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "geometry/predicates.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::geometry {

namespace {

std::size_t after(std::size_t i, std::size_t count) {
  return i + 1 == count ? 0 : i + 1;
}

// Two edges that share the corner b may only part there, not fold back on each other.
bool folds_back(Point a, Point b, Point c) {
  return a == b || b == c || (orientation(a, b, c) == 0 && dot(b - a, c - b) < 0);
}

bool edges_conflict(std::span<const Point> ring, std::size_t i, std::size_t j) {
  const std::size_t count = ring.size();
  const Point a = ring[i], b = ring[after(i, count)], c = ring[j], d = ring[after(j, count)];
  if (after(i, count) == j && after(j, count) == i) return true;
  if (after(i, count) == j) return folds_back(a, b, d);
  if (after(j, count) == i) return folds_back(c, d, b);
  return segments_touch(a, b, c, d);
}

}  // namespace

double signed_area(std::span<const Point> ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

Point centroid(std::span<const Point> ring) {
  double twice = 0;
  Point moment;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    const double area = cross(a, b);
    twice += area;
    moment = moment + area * (a + b);
  }
  return twice == 0 ? ring[0] : ring[0] + (1 / (3 * twice)) * moment;
}

double diameter(std::span<const Point> ring) {
  double square = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      const Point d = ring[j] - ring[i];
      square = std::max(square, dot(d, d));
    }
  }
  return std::sqrt(square);
}

std::vector<double> monomial_integrals(std::span<const Point> ring, Point center, int degree) {
  // For f homogeneous of degree d about c: ∫_E f = 1/(d+2) Σ_e ∫_e f (x−c)·n ds, and (x−c)·n is constant on
  // e.
  const std::size_t size = static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
  std::vector<double> integrals(size, 0.0);
  const Rule& rule = gauss_legendre(degree);
  std::vector<double> x_powers(static_cast<std::size_t>(degree) + 1, 1.0), y_powers = x_powers;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - center, edge = ring[after(i, ring.size())] - ring[i];
    const double lever = cross(a, edge);
    for (std::size_t g = 0; g < rule.at.size(); ++g) {
      const Point x = a + rule.at[g] * edge;
      for (std::size_t k = 1; k < x_powers.size(); ++k) {
        x_powers[k] = x_powers[k - 1] * x.x;
        y_powers[k] = y_powers[k - 1] * x.y;
      }
      std::size_t m = 0;
      for (std::size_t d = 0; d < x_powers.size(); ++d) {
        const double weight = rule.weight[g] * lever / static_cast<double>(d + 2);
        for (std::size_t q = 0; q <= d; ++q) integrals[m++] += weight * x_powers[d - q] * y_powers[q];
      }
    }
  }
  return integrals;
}

bool contains(std::span<const Point> ring, Point p) {
  int winding = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[after(i, ring.size())];
    if (on_segment(p, a, b)) return true;
    if (a.y <= p.y && b.y > p.y && orientation(a, b, p) > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && orientation(a, b, p) < 0) --winding;
  }
  return winding != 0;
}

bool is_simple(std::span<const Point> ring) {
  return first_crossing(ring).first < 0;
}

std::pair<int, int> first_crossing(std::span<const Point> ring) {
  const std::size_t count = ring.size();
  if (count < 3) return {0, 0};
  auto low = [&](std::size_t i) { return std::min(ring[i].x, ring[after(i, count)].x); };
  auto high = [&](std::size_t i) { return std::max(ring[i].x, ring[after(i, count)].x); };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](auto i, auto j) { return std::pair(low(i), i) < std::pair(low(j), j); });
  std::pair<std::size_t, std::size_t> first{count, count};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t l = k + 1; l < count && low(order[l]) <= high(order[k]); ++l) {
      const auto [i, j] = std::minmax(order[k], order[l]);
      if (std::pair(i, j) < first && edges_conflict(ring, i, j)) first = {i, j};
    }
  }
  if (first.first == count) return {-1, -1};
  return {static_cast<int>(first.first), static_cast<int>(first.second)};
}

double distance_to_segment(Point p, Point a, Point b, double* parameter) {
  const Point edge = b - a;
  const double square = dot(edge, edge);
  const double t = square > 0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
  if (parameter) *parameter = t;
  return t == 1 ? distance(p, b) : distance(p, a + t * edge);
}

std::vector<std::array<int, 3>> triangulate(std::span<const Point> ring) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> rest(ring.size());
  std::iota(rest.begin(), rest.end(), 0);
  auto at = [&](std::size_t k) { return ring[static_cast<std::size_t>(rest[k])]; };
  auto is_ear = [&](std::size_t before, std::size_t tip, std::size_t next) {
    const Point a = at(before), b = at(tip), c = at(next);
    for (std::size_t k = 0; k < rest.size(); ++k) {
      if (k == before || k == tip || k == next) continue;
      const Point p = at(k);
      if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return false;
    }
    return true;
  };
  std::size_t k = 0, misses = 0;
  while (rest.size() >= 3 && misses < rest.size()) {
    k %= rest.size();
    const std::size_t before = k == 0 ? rest.size() - 1 : k - 1, next = after(k, rest.size());
    const int turn = orientation(at(before), at(k), at(next));
    if (turn > 0 && is_ear(before, k, next))
      triangles.push_back({rest[before], rest[k], rest[next]});
    else if (turn != 0) {
      ++k, ++misses;
      continue;
    }
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
    misses = 0;
    ++k;
  }
  return triangles;
}

}  // namespace ashlar::geometry
