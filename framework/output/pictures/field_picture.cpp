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

// A triangle that points up for the greatest value and down for the least, with the value beside it.
void mark(Canvas& canvas, const Frame& frame, Point place, const std::string& text, bool greatest) {
  constexpr double r = 3.1;
  const Point at = frame.at(place);
  const double way = greatest ? -1 : 1;
  const Point ring[] = {
      {at.x, at.y + way * r}, {at.x - r, at.y - way * 0.7 * r}, {at.x + r, at.y - way * 0.7 * r}};
  canvas.fill(ring, greatest ? Color{0.08, 0.09, 0.11} : Color{1, 1, 1});
  canvas.polyline(ring, {{greatest ? 1.0 : 0.08, greatest ? 1.0 : 0.09, greatest ? 1.0 : 0.11}, 0.6}, true);
  TextStyle style{7.5};
  style.halo = true;
  const double width = canvas.text_width(text, style);
  const bool to_left = at.x + r + 3 + width > frame.corner.x + frame.width - 3;
  if (to_left) style.align = Align::right;
  // Inside the plot, away from its rim.
  const double y = std::clamp(at.y + 2.6, frame.corner.y + 9, frame.corner.y + frame.height - 4);
  canvas.text(to_left ? at.x - r - 3 : at.x + r + 3, y, text, style);
}

void mark_extremes(Canvas& canvas, const Frame& frame, const DrawnField& field, const UnitScale& unit) {
  const std::string name = unit.name.empty() ? "" : " " + unit.name;
  const std::string greatest = "max " + value_text(field.greatest / unit.factor) + name;
  const std::string least = "min " + value_text(field.least / unit.factor) + name;
  mark(canvas, frame, field.greatest_at, greatest, true);
  if (field.least < field.greatest) mark(canvas, frame, field.least_at, least, false);
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
            mark_extremes(canvas, frame, *field, unit);
            draw_bar(canvas, frame, bands, unit);
          }};
}

}  // namespace ashlar::output
