#include "relax.hpp"

#include <algorithm>

#include "corners.hpp"
#include "delaunay.hpp"

namespace ashlar::meshing_voronoi {

namespace {

// Steps beyond the centroid converge faster (stable below 2); the last ones rest on it.
constexpr double overshoot = 1.6;
constexpr int resting = 2;
constexpr double push = 1.06;  // sites pushed out of a ball land at this share of its radius

struct Moments {
  double mass = 0;
  Point first;  ///< ∫ ρ (x − site)
};

// Density 1/h⁴, of which centroidal cells have size h in the plane (Gersho's conjecture).
std::vector<double> densities(const std::vector<Site>& sites, const mesh::Domain& domain,
                              const mesh::SizeField& sizes, double scale) {
  std::vector<double> density(sites.size());
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const double h = sizes.at(sites[k].at, region_of(domain, sites[k].face)) / scale;
    density[k] = 1 / (h * h * h * h);
  }
  return density;
}

// The part of a cell between its site and one of its edges; ρ varies linearly over it.
void add_sector(Moments& moments, Point p, Point q, double at_site, double at_p, double at_q) {
  const double area = 0.5 * geometry::cross(p, q);
  const double sum = at_site + at_p + at_q;
  moments.mass += area * sum / 3;
  moments.first = moments.first + (area / 12) * ((sum + at_p) * p + (sum + at_q) * q);
}

std::vector<Moments> cell_moments(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                                  const std::vector<double>& density) {
  std::vector<Point> centres(triangles.size());
  std::vector<double> at_centre(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t].sites;
    centres[t] = circumcentre(points[a], points[b], points[c]);
    at_centre[t] = (density[a] + density[b] + density[c]) / 3;
  }
  std::vector<Moments> moments(points.size());
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Index n = triangles[t].neighbours[k];
      if (n < t) continue;
      const Index a = triangles[t].sites[(k + 1) % 3], b = triangles[t].sites[(k + 2) % 3];
      add_sector(moments[a], centres[n] - points[a], centres[t] - points[a], density[a], at_centre[n],
                 at_centre[t]);
      add_sector(moments[b], centres[t] - points[b], centres[n] - points[b], density[b], at_centre[t],
                 at_centre[n]);
    }
  }
  return moments;
}

// Sites that a ball could catch: those within two triangles of a fixed site.
std::vector<char> near_border(const std::vector<Triangle>& triangles, std::size_t count, std::size_t fixed) {
  std::vector<char> ring(count, 0);
  for (int round = 1; round <= 2; ++round) {
    for (const Triangle& triangle : triangles) {
      bool touches = false;
      for (const Index s : triangle.sites) {
        touches = touches || s < static_cast<Index>(fixed) || (ring[s] > 0 && ring[s] < round);
      }
      if (!touches) continue;
      for (const Index s : triangle.sites) {
        if (ring[s] == 0) ring[s] = static_cast<char>(round);
      }
    }
  }
  return ring;
}

Point outside_balls(Point wanted, Point old, const std::vector<Ball>& balls, const Cover& cover) {
  const Index b = cover.ball_at(wanted);
  if (b < 0) return wanted;
  const Point away = wanted - balls[b].center;
  const Point pushed = balls[b].center + (push * balls[b].radius / geometry::norm(away)) * away;
  return cover.ball_at(pushed) < 0 ? pushed : old;
}

}  // namespace

void relax(std::vector<Site>& sites, std::size_t fixed, const mesh::Domain& domain,
           const mesh::SizeField& sizes, const Cover& cover, int iterations) {
  std::vector<Point> points(sites.size());
  for (std::size_t k = 0; k < sites.size(); ++k) points[k] = sites[k].at;
  const std::vector<Index> order = curve_order(points);
  for (int i = 0; i < iterations; ++i) {
    const std::vector<Triangle> triangles = triangulate(points, order);
    const std::vector<double> density = densities(sites, domain, sizes, sizes.least_base());
    const std::vector<Moments> moments = cell_moments(points, triangles, density);
    const std::vector<char> near = near_border(triangles, sites.size(), fixed);
    const double step = i + resting < iterations ? overshoot : 1.0;
    for (std::size_t k = fixed; k < sites.size(); ++k) {
      if (!(moments[k].mass > 0)) continue;
      const Point centroid = (1 / moments[k].mass) * moments[k].first;
      // Near borders only the centroid itself is sure to lie in the site's own face.
      points[k] = near[k] ? outside_balls(points[k] + centroid, points[k], cover.balls(), cover)
                          : points[k] + step * centroid;
      sites[k].at = points[k];
    }
  }
}

}  // namespace ashlar::meshing_voronoi
