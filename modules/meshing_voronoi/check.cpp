#include <algorithm>
#include <cmath>

#include "cells.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::meshing_voronoi {

namespace {

constexpr double area_tolerance = 1e-12;

struct Step {
  Index from, to, face;
  auto operator<=>(const Step&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 misreads it
};

// Edges of cells between border points, with the face of the cell on their left.
std::vector<Step> border_steps(const Cells& cells) {
  std::vector<Step> steps;
  const Index fixed = static_cast<Index>(cells.fixed_points);
  for (Index c = 0; c < cells.size(); ++c) {
    for (Index k = cells.offsets[c]; k < cells.offsets[c + 1]; ++k) {
      const Index next = k + 1 < cells.offsets[c + 1] ? k + 1 : cells.offsets[c];
      const Index a = cells.corners[k], b = cells.corners[next];
      if (a < fixed && b < fixed) steps.push_back({a, b, cells.faces[c]});
    }
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

void check_pieces(const mesh::Domain& domain, const Border& border, const Cells& cells,
                  std::vector<Point>& faults) {
  const std::vector<Step> steps = border_steps(cells);
  const auto followed = [&](Index from, Index to, Index face) {
    if (face < 0 || domain.faces[face].region < 0) return true;
    return std::binary_search(steps.begin(), steps.end(), Step{from, to, face});
  };
  for (const Piece& piece : border.pieces) {
    if (followed(piece.from, piece.to, piece.left) && followed(piece.to, piece.from, piece.right)) continue;
    faults.push_back(0.5 * (cells.points[piece.from] + cells.points[piece.to]));
  }
}

bool sound(const std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  double turning = 0;
  bool convex = true;
  for (std::size_t k = 0; k < n && convex; ++k) {
    const Point u = ring[(k + 1) % n] - ring[k], v = ring[(k + 2) % n] - ring[(k + 1) % n];
    const double sine = geometry::cross(u, v);
    convex = sine > 0;
    turning += std::atan2(sine, geometry::dot(u, v));
  }
  // Only a ring that turns once is simple if it always turns left.
  if (convex && turning < 7) return true;
  return geometry::signed_area(ring) > 0 && geometry::is_simple(ring);
}

std::vector<double> face_areas(const mesh::Domain& domain) {
  std::vector<double> areas(domain.faces.size(), 0.0);
  const Point origin = domain.points.front();
  for (const auto& segment : domain.segments) {
    const Point a = domain.points[segment.from] - origin, b = domain.points[segment.to] - origin;
    const double area = 0.5 * geometry::cross(a, b);
    if (segment.left >= 0) areas[segment.left] += area;
    if (segment.right >= 0) areas[segment.right] -= area;
  }
  return areas;
}

void check_areas(const mesh::Domain& domain, const Cells& cells, std::vector<Point>& faults) {
  std::vector<double> missing = face_areas(domain);
  const std::vector<double> areas = missing;
  std::vector<Point> ring;
  for (Index c = 0; c < cells.size(); ++c) {
    ring.clear();
    for (Index k = cells.offsets[c]; k < cells.offsets[c + 1]; ++k)
      ring.push_back(cells.points[cells.corners[k]]);
    if (!sound(ring)) {
      faults.push_back(ring.empty() ? domain.faces[cells.faces[c]].inside : ring.front());
      continue;
    }
    missing[cells.faces[c]] -= geometry::signed_area(ring);
  }
  const double box = domain.length * domain.length;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (domain.faces[f].region < 0 || std::abs(missing[f]) <= area_tolerance * (areas[f] + box)) continue;
    faults.push_back(domain.faces[f].inside);
  }
}

}  // namespace

std::vector<Point> find_faults(const mesh::Domain& domain, const Border& border, const Cells& cells) {
  std::vector<Point> faults;
  check_pieces(domain, border, cells, faults);
  check_areas(domain, cells, faults);
  return faults;
}

}  // namespace ashlar::meshing_voronoi
