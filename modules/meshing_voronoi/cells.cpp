#include "cells.hpp"

#include <algorithm>

#include "delaunay.hpp"

namespace ashlar::meshing_voronoi {

namespace {

constexpr double equal = 1e-7;  // of the circumradius: nearer circumcentres are one

// The ball on whose circle all three sites lie; its centre is their circumcentre.
Index common_ball(const Site& a, const Site& b, const Site& c) {
  const auto has = [](const Site& site, Index ball) {
    return std::find(site.balls.begin(), site.balls.end(), ball) != site.balls.end();
  };
  for (const Index ball : a.balls) {
    if (ball >= 0 && has(b, ball) && has(c, ball)) return ball;
  }
  return -1;
}

std::vector<Index> vertex_of_triangle(const std::vector<Triangle>& triangles, const std::vector<Site>& sites,
                                      Cells& cells) {
  std::vector<Index> vertex(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t].sites;
    vertex[t] = common_ball(sites[a], sites[b], sites[c]);
    if (vertex[t] >= 0) continue;
    vertex[t] = static_cast<Index>(cells.points.size());
    cells.points.push_back(circumcentre(sites[a].at, sites[b].at, sites[c].at));
  }
  return vertex;
}

// Where more than three sites lie on one circle, several triangles have one circumcentre but for rounding.
void join_equal_vertices(const std::vector<Triangle>& triangles, const std::vector<Site>& sites,
                         const Cells& cells, std::vector<Index>& vertex) {
  std::vector<Index> same(cells.points.size());
  for (std::size_t v = 0; v < same.size(); ++v) same[v] = static_cast<Index>(v);
  const auto root = [&](Index v) {
    while (same[v] != v) v = same[v];
    return v;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Point site = sites[triangles[t].sites[0]].at;
    for (const Index n : triangles[t].neighbours) {
      if (n < static_cast<Index>(t)) continue;
      const auto [low, high] = std::minmax({root(vertex[t]), root(vertex[n])});
      if (low == high || high < static_cast<Index>(cells.fixed_points)) continue;
      const double radius = geometry::distance(cells.points[low], site);
      if (geometry::distance(cells.points[low], cells.points[high]) < equal * radius) same[high] = low;
    }
  }
  for (Index& v : vertex) v = root(v);
}

// Walks round a site counter-clockwise; an unbounded cell stays empty and is found by the check of areas.
void append_ring(Index site, Index start, const std::vector<Triangle>& triangles,
                 const std::vector<Index>& vertex, std::vector<Index>& ring) {
  ring.clear();
  Index t = start;
  do {
    if (ring.empty() || ring.back() != vertex[t]) ring.push_back(vertex[t]);
    const auto& corners = triangles[t].sites;
    const int k = corners[0] == site ? 0 : corners[1] == site ? 1 : 2;
    t = triangles[t].neighbours[(k + 1) % 3];
  } while (t != start && t >= 0);
  if (t < 0) ring.clear();
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

}  // namespace

Cells cut_cells(const std::vector<Site>& sites, const std::vector<Ball>& balls) {
  std::vector<Point> points(sites.size());
  for (std::size_t k = 0; k < sites.size(); ++k) points[k] = sites[k].at;
  const std::vector<Triangle> triangles = triangulate(points, curve_order(points));
  Cells cells;
  for (const Ball& ball : balls) cells.points.push_back(ball.center);
  cells.fixed_points = balls.size();
  std::vector<Index> vertex = vertex_of_triangle(triangles, sites, cells);
  join_equal_vertices(triangles, sites, cells, vertex);
  std::vector<Index> start(sites.size(), -1);
  for (std::size_t t = triangles.size(); t-- > 0;) {
    for (const Index site : triangles[t].sites) start[site] = static_cast<Index>(t);
  }
  std::vector<Index> ring;
  for (std::size_t s = 0; s < sites.size(); ++s) {
    if (sites[s].face < 0 || start[s] < 0) continue;
    append_ring(static_cast<Index>(s), start[s], triangles, vertex, ring);
    cells.corners.insert(cells.corners.end(), ring.begin(), ring.end());
    cells.offsets.push_back(static_cast<Index>(cells.corners.size()));
    cells.faces.push_back(sites[s].face);
  }
  return cells;
}

void drop_unused_points(Cells& cells) {
  std::vector<Index> number(cells.points.size(), -1);
  for (const Index corner : cells.corners) number[corner] = 0;
  std::vector<Point> kept;
  std::size_t fixed = 0;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] < 0) continue;
    number[p] = static_cast<Index>(kept.size());
    kept.push_back(cells.points[p]);
    fixed += p < cells.fixed_points;
  }
  for (Index& corner : cells.corners) corner = number[corner];
  cells.points = std::move(kept);
  cells.fixed_points = fixed;
}

}  // namespace ashlar::meshing_voronoi
