#include <algorithm>
#include <cmath>
#include <memory>

#include "output/files.hpp"
#include "output/pictures/outlines.hpp"
#include "output/pictures/pictures.hpp"
#include "output/pictures/values.hpp"

namespace ashlar::output {

using geometry::Point;

namespace {

const LineStyle outline_style{{0.08, 0.09, 0.11}, 0.7};
const LineStyle joint_style{{0.08, 0.09, 0.11}, 1.15};

constexpr double mark_radius = 3.1, label_height = 6.5;

struct Box {
  Point corner;  ///< upper left, in units
  double width = 0, height = 0;
};

// Share of the box that the field covers.
double covered(const Frame& frame, const Image& image, const Box& box) {
  int inside = 0, count = 0;
  for (double y = 0; y <= 1; y += 0.25)
    for (double x = 0; x <= 1; x += 0.0625) {
      const int column = static_cast<int>((box.corner.x + x * box.width - frame.corner.x) * pixels_per_unit);
      const int row = static_cast<int>((box.corner.y + y * box.height - frame.corner.y) * pixels_per_unit);
      if (column < 0 || row < 0 || column >= image.width || row >= image.height) return -1;
      inside += image.pixels[static_cast<std::size_t>(row) * image.width + column] != 0;
      ++count;
    }
  return static_cast<double>(inside) / count;
}

// Beside, above or below the mark: inside the plot, off the outlines, on white rather than on colours.
Box label_box(const Frame& frame, const Image& image, Point at, double width) {
  constexpr double off = mark_radius + 3;
  const double right = at.x + off, left = at.x - off - width, middle = at.y - label_height / 2;
  const double above = at.y - off - label_height, below = at.y + off;
  const Point places[] = {{right, middle},         {left, middle},           {right - off + 4, above},
                          {left + off - 4, above}, {right - off + 4, below}, {left + off - 4, below}};
  Box best{places[0], width, label_height};
  double lowest = 1e300, bias = 0;
  for (const Point& place : places) {
    const Box box{place, width, label_height};
    const double share = covered(frame, image, box);
    const double cost = share < 0 ? 10 : 4 * share * (1 - share) + 0.15 * share + bias;
    if (cost < lowest) best = box;
    lowest = std::min(lowest, cost);
    bias += 0.01;
  }
  return best;
}

// A triangle that points up for the greatest value and down for the least, with the value beside it.
void mark(Canvas& canvas, const Frame& frame, const Image& image, Point place, const std::string& text) {
  const bool greatest = text.starts_with("max");
  const Point at = frame.at(place);
  const double r = greatest ? mark_radius : -mark_radius;
  const Point ring[] = {{at.x, at.y - r}, {at.x - r, at.y + 0.7 * r}, {at.x + r, at.y + 0.7 * r}};
  const Color dark{0.08, 0.09, 0.11}, white{1, 1, 1};
  canvas.fill(ring, greatest ? dark : white);
  canvas.polyline(ring, {greatest ? white : dark, 0.6}, true);
  TextStyle style{7.5};
  style.halo = true;
  const Box box = label_box(frame, image, at, canvas.text_width(text, style));
  canvas.text(box.corner.x, box.corner.y + label_height - 0.8, text, style);
}

void mark_extremes(Canvas& canvas, const Frame& frame, const Image& image, const DrawnField& field,
                   const UnitScale& unit) {
  const std::string name = unit.name.empty() ? "" : " " + unit.name;
  mark(canvas, frame, image, field.greatest_at, "max " + value_text(field.greatest / unit.factor) + name);
  if (field.least < field.greatest)
    mark(canvas, frame, image, field.least_at, "min " + value_text(field.least / unit.factor) + name);
}

}  // namespace

Picture field_picture(const PictureSource& source, const std::string& quantity) {
  auto found = drawn_field(source, quantity);
  if (!found) return {};
  const auto field = std::make_shared<const DrawnField>(std::move(*found));
  const mesh::Mesh& mesh = source.model.mesh;
  const Frame frame = make_frame(bounds_of(mesh.points), true);
  return {file_name(quantity), frame.page_height, [source, &mesh, frame, field](Canvas& canvas) {
            const Bands bands = make_bands(field->low, field->high, field->least, field->greatest);
            const double reach = std::max(std::abs(bands.first), std::abs(bands.edge(bands.count())));
            const UnitScale unit = unit_scale(field->unit, reach);
            draw_title(canvas, field->title,
                       "stage " + source.stage.name + (field->stress ? " · tension positive · " : " · ") +
                           source.scene.title);
            Image image = frame.image();
            fill_bands(image, frame.view(), {mesh.points, mesh.cell_points}, field->corners, bands);
            canvas.image(frame.corner, image, pixels_per_unit);
            if (mesh.cell_count() < few_cells)
              draw_thin_edges(canvas, frame, mesh.points, inner_edges(mesh), {{0, 0, 0}, 0.2, 0, 0.22});
            draw_chains(canvas, frame, mesh.points, outlines(mesh), outline_style);
            draw_chains(canvas, frame, mesh.points, joint_lines(mesh), joint_style);
            draw_axes(canvas, frame);
            mark_extremes(canvas, frame, image, *field, unit);
            draw_bar(canvas, frame, bands, unit);
          }};
}

}  // namespace ashlar::output
