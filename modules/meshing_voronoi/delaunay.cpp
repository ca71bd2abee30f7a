#include "delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <cassert>

namespace ashlar::meshing_voronoi {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Faces = CGAL::Triangulation_face_base_with_info_2<Index, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;

}  // namespace

std::vector<Index> curve_order(const std::vector<Point>& points) {
  std::vector<Kernel::Point_2> copies;
  std::vector<std::size_t> order(points.size());
  copies.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    copies.emplace_back(points[k].x, points[k].y);
    order[k] = k;
  }
  const auto map = CGAL::make_property_map(copies);
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
  return {order.begin(), order.end()};
}

std::vector<Triangle> triangulate(const std::vector<Point>& points, const std::vector<Index>& order) {
  Delaunay delaunay;
  Delaunay::Face_handle near;
  for (const Index k : order) {
    const auto vertex = delaunay.insert(Kernel::Point_2(points[k].x, points[k].y), near);
    vertex->info() = k;
    near = vertex->face();
  }
  assert(delaunay.number_of_vertices() == points.size());
  Index count = 0;
  for (auto face = delaunay.all_faces_begin(); face != delaunay.all_faces_end(); ++face) {
    face->info() = delaunay.is_infinite(face) ? -1 : count++;
  }
  std::vector<Triangle> triangles;
  triangles.reserve(count);
  for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face) {
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.sites[k] = face->vertex(k)->info();
      triangle.neighbours[k] = face->neighbor(k)->info();
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

Point circumcentre(Point a, Point b, Point c) {
  const Point u = b - a, v = c - a;
  const double scale = 0.5 / geometry::cross(u, v);
  const double uu = geometry::dot(u, u), vv = geometry::dot(v, v);
  return a + Point{(v.y * uu - u.y * vv) * scale, (u.x * vv - v.x * uu) * scale};
}

}  // namespace ashlar::meshing_voronoi
