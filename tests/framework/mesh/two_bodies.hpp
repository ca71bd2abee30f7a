#pragma once
// Meshes of two bodies that are meshed apart, and joints between their faces.

#include <numbers>

#include "framework/mesh/mesh_shapes.hpp"
#include "mesh/face_lips.hpp"
#include "mesh/groups.hpp"

namespace ashlar::mesh {

inline RegionShape box(const std::string& name, Point low, Point high) {
  return region(name,
                polygon({low, {high.x, low.y}, high, {low.x, high.y}}, {"bottom", "right", "top", "left"}));
}

inline JointLine faces(const std::string& name, const std::string& first, const std::string& second) {
  JointLine line;
  line.name = name;
  line.faces = {first, second};
  line.sides = {first.substr(0, first.find('.')), second.substr(0, second.find('.'))};
  return line;
}

inline Domain alone(const RegionShape& shape, double chord = 1) {
  core::Mistakes mistakes;
  Domain domain = make_domain({shape}, {}, chord, mistakes);
  mistakes.throw_if_any();
  return domain;
}

/// Rows and columns of cells between the given coordinates.
inline RawMesh lattice(const std::vector<double>& x, const std::vector<double>& y) {
  RawMesh raw;
  for (const double b : y)
    for (const double a : x) raw.points.push_back({a, b});
  const auto stride = static_cast<Index>(x.size());
  for (Index j = 0; j + 1 < static_cast<Index>(y.size()); ++j)
    for (Index i = 0; i + 1 < stride; ++i) {
      const Index p = j * stride + i;
      raw.cell_points.append(std::array<Index, 4>{p, p + 1, p + stride + 1, p + stride});
      raw.cell_region.push_back(0);
    }
  return raw;
}

inline std::vector<double> steps(int n, double from = 0, double to = 1) {
  std::vector<double> list;
  for (int i = 0; i <= n; ++i) list.push_back(from + (to - from) * i / n);
  return list;
}

inline RawMesh moved(RawMesh raw, const auto& map) {
  for (Point& p : raw.points) p = map(p);
  return raw;
}

/// Block "low" with n × n cells in [0, 1]², block "up" with m × m upon it, joint "touch".
inline Mesh two_blocks(int n, int m) {
  const RegionShape low = box("low", {0, 0}, {1, 1}), up = box("up", {0, 1}, {1, 2});
  std::vector<Mesh> parts;
  parts.push_back(build_mesh(lattice(steps(n), steps(n)), alone(low)));
  parts.push_back(build_mesh(lattice(steps(m), steps(m, 1, 2)), alone(up)));
  Mesh mesh = merge(std::move(parts), {"up", "low"});
  add_face_joints(mesh, {faces("touch", "low.top", "up.bottom")});
  return mesh;
}

/// Both blocks as one body, n × 2 n cells.
inline Mesh as_one_block(int n) {
  core::Mistakes mistakes;
  const Domain domain = make_domain({box("low", {0, 0}, {1, 1}), box("up", {0, 1}, {1, 2})}, {}, 1, mistakes);
  mistakes.throw_if_any();
  RawMesh raw = lattice(steps(n), steps(2 * n, 0, 2));
  for (std::size_t c = 0; c < raw.cell_region.size(); ++c) raw.cell_region[c] = static_cast<int>(c) >= n * n;
  return build_mesh(std::move(raw), domain);
}

/// A disc of 48 triangles (arcs turn by 7.5° at most), radius 1, touches a block of 4 × 1 cells at (2, 1);
/// joint "touch". `halved`: each chord bears a point in its middle.
inline Mesh disc_on_block(bool disc_first, bool halved = false) {
  const RegionShape block = box("block", {0, 0}, {4, 1}), disc = region("disc", circle({2, 2}, 1, "rim"));
  const Domain domain = alone(disc);
  RawMesh raw;
  raw.points = domain.points;
  raw.points.push_back({2, 2});
  const auto center = static_cast<Index>(domain.points.size());
  for (const auto& segment : domain.segments) {
    const bool inside = segment.left >= 0;
    std::vector<Index> cell{inside ? segment.from : segment.to, inside ? segment.to : segment.from, center};
    if (halved) {
      cell.insert(cell.begin() + 1, static_cast<Index>(raw.points.size()));
      raw.points.push_back(0.5 * (domain.points[segment.from] + domain.points[segment.to]));
    }
    raw.cell_points.append(cell);
    raw.cell_region.push_back(0);
  }
  std::vector<Mesh> parts;
  parts.push_back(build_mesh(lattice(steps(4, 0, 4), steps(1)), alone(block)));
  parts.push_back(build_mesh(std::move(raw), domain));
  Mesh mesh = merge(std::move(parts), {"block", "disc"});
  add_face_joints(
      mesh, {disc_first ? faces("touch", "disc.rim", "block.top") : faces("touch", "block.top", "disc.rim")});
  return mesh;
}

/// A thin cell of a plate on one chord of its round hole (radius 1 about the origin, 7.5°), the chord's
/// middle being point 4, and a square pin inside; groups "plate.wall" and "pin.rim".
inline Mesh chord_of_a_hole(double thickness) {
  const double turn = std::numbers::pi / 48;
  const Point a{std::sin(turn), -std::cos(turn)}, b{-a.x, a.y}, down{0, -thickness};
  RawMesh raw;
  raw.points = {a, b, b + down, a + down, 0.5 * (a + b), {0, 0.5}, {0.5, 0.5}, {0.5, 0.9}, {0, 0.9}};
  raw.cell_points.append(std::array<Index, 5>{0, 4, 1, 2, 3});
  raw.cell_points.append(std::array<Index, 4>{5, 6, 7, 8});
  raw.cell_region = {0, 1};
  raw.regions = {"plate", "pin"};
  raw.edge_groups = {{"plate.wall", {{0, 4}, {4, 1}}}, {"pin.rim", {{5, 6}}}};
  Mesh mesh = build_mesh(std::move(raw), {});
  for (const Index edge : mesh.edge_groups.at("plate.wall")) mesh.arcs[edge] = {{0, 0}, 1, false};
  return mesh;
}

}  // namespace ashlar::mesh
