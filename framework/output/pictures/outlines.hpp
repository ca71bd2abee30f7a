#pragma once
// The lines that a picture of a mesh needs: borders of regions, joints, edges inside. Included by
// pictures/*.cpp only.

#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "output/pictures/frame.hpp"

namespace ashlar::output {

/// Below this many cells their edges are drawn as lines of their own.
constexpr mesh::Index few_cells = 3000;

/// Edges on the outer border, between regions, and on lips of joints, as chains of points.
std::vector<std::vector<mesh::Index>> outlines(const mesh::Mesh& mesh);
/// The first lip of each joint, as chains of points.
std::vector<std::vector<mesh::Index>> joint_lines(const mesh::Mesh& mesh);
/// Edges between two cells of one region.
std::vector<std::array<mesh::Index, 2>> inner_edges(const mesh::Mesh& mesh);

Bounds bounds_of(std::span<const geometry::Point> points);

void draw_chains(Canvas& canvas, const Frame& frame, std::span<const geometry::Point> points,
                 const std::vector<std::vector<mesh::Index>>& chains, const LineStyle& style);
/// Thin lines; few enough of them for cairo.
void draw_thin_edges(Canvas& canvas, const Frame& frame, std::span<const geometry::Point> points,
                     const std::vector<std::array<mesh::Index, 2>>& edges, const LineStyle& style);

}  // namespace ashlar::output
