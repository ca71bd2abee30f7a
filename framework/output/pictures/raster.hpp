#pragma once
// Cells as pixels: cairo takes seconds for what 100 000 cells need, these loops take milliseconds.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "output/pictures/scale.hpp"

namespace ashlar::output {

/// Row by row from the top; premultiplied 0xAARRGGBB, transparent where nothing was drawn.
struct Image {
  Image(int columns, int rows)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * rows) {}
  int width, height;
  std::vector<std::uint32_t> pixels;
};

/// Metres to pixels: column = (x − left)·scale, row = (top − y)·scale.
struct View {
  double left = 0, top = 0, scale = 1;
  geometry::Point pixel(geometry::Point p) const { return {(p.x - left) * scale, (top - p.y) * scale}; }
};

/// Points of the cells, as they are or moved.
struct Shape {
  std::span<const geometry::Point> points;
  const mesh::Adjacency& cells;
};

/// Contour bands of values given at the corners of each cell (laid out as cells.values()): linear in
/// triangles about each cell's middle, so jumps between cells stay. Borders of bands are smoothed and drawn
/// as faint lines.
void fill_bands(Image& image, const View& view, const Shape& shape, std::span<const double> corner_values,
                const Bands& bands);

/// Each cell in its own colour (packed).
void fill_cells(Image& image, const View& view, const Shape& shape, std::span<const std::uint32_t> colors);

/// Lines between points, `width` pixels wide (below 1: fainter). Where lines are denser than pixels they add
/// up to a tint, never beyond `darkest`.
void draw_edges(Image& image, const View& view, std::span<const geometry::Point> points,
                std::span<const std::array<mesh::Index, 2>> edges, double width, double darkest = 0.55);

}  // namespace ashlar::output
