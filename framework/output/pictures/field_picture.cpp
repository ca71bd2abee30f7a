#include <algorithm>
#include <cmath>
#include <memory>

#include "output/files.hpp"
#include "output/pictures/labels.hpp"
#include "output/pictures/outlines.hpp"
#include "output/pictures/pictures.hpp"
#include "output/pictures/values.hpp"

namespace ashlar::output {

using geometry::Point;

namespace {

const LineStyle outline_style{{0.08, 0.09, 0.11}, 0.7};
const LineStyle joint_style{{0.08, 0.09, 0.11}, 1.15};

constexpr double mark_radius = 3.1, label_height = 6.5;
const TextStyle label_style = [] {
  TextStyle style{7.5};
  style.halo = true;
  return style;
}();

// A triangle that points up for the greatest value and down for the least, with the value beside it.
void draw_mark(Canvas& canvas, Point at, bool greatest) {
  const double r = greatest ? mark_radius : -mark_radius;
  const Point ring[] = {{at.x, at.y - r}, {at.x - r, at.y + 0.7 * r}, {at.x + r, at.y + 0.7 * r}};
  const Color dark{0.08, 0.09, 0.11}, white{1, 1, 1};
  canvas.fill(ring, greatest ? dark : white);
  canvas.polyline(ring, {greatest ? white : dark, 0.6}, true);
}

void mark_extremes(Canvas& canvas, const Frame& frame, const Image& image, const DrawnField& field,
                   const UnitScale& unit) {
  struct Extreme {
    Point at;
    std::string text;
    bool greatest;
  };
  const Extreme extremes[] = {
      {frame.at(field.greatest_at), "max " + value_text(field.greatest, unit, field.unit), true},
      {frame.at(field.least_at), "min " + value_text(field.least, unit, field.unit), false}};
  Labels labels(frame, image);
  for (const Extreme& each : extremes) {
    constexpr double r = mark_radius;
    labels.shun(Box{each.at - Point{r, r}, 2 * r, 2 * r});
    draw_mark(canvas, each.at, each.greatest);
  }
  for (const Extreme& each : extremes) {
    const double width = canvas.text_width(each.text, label_style);
    const Box box = labels.beside(each.at, mark_radius + 3, width, label_height);
    canvas.text(box.corner.x, box.corner.y + label_height - 0.8, each.text, label_style);
  }
}

// What the picture shows, and with which numbers beside it.
struct Plan {
  DrawnField field;
  Bands bands;
  UnitScale unit;
  Frame frame;
};

Plan plan_of(DrawnField field, const mesh::Mesh& mesh) {
  Plan plan{std::move(field), {}, {}, {}};
  const DrawnField& f = plan.field;
  const bool varied = f.kind == DrawnField::Kind::varied;
  plan.bands = varied ? make_bands(f.low, f.high, f.least, f.greatest) : make_bands(0, 0, 0, 0);
  const double reach = std::max(std::abs(plan.bands.first), std::abs(plan.bands.edge(plan.bands.count())));
  plan.unit = unit_scale(f.unit, reach);
  plan.frame = make_frame(bounds_of(mesh.points),
                          varied ? std::optional(bar_label_width(plan.bands, plan.unit)) : std::nullopt);
  return plan;
}

std::string full_title(const DrawnField& field) {
  if (field.kind == DrawnField::Kind::varied) return field.title;
  if (field.kind == DrawnField::Kind::zero)
    return field.title + (field.whole > 0 ? ": zero to round-off" : ": zero");
  return field.title + ": " +
         value_text(field.greatest, unit_scale(field.unit, std::abs(field.greatest)), field.unit) +
         " everywhere";
}

void draw_field(Canvas& canvas, const mesh::Mesh& mesh, const Plan& plan) {
  const Frame& frame = plan.frame;
  const bool varied = plan.field.kind == DrawnField::Kind::varied;
  Image image = frame.image();
  if (varied)
    fill_bands(image, frame.view(), {mesh.points, mesh.cell_points}, plan.field.corners, plan.bands);
  else
    fill_cells(image, frame.view(), {mesh.points, mesh.cell_points},
               std::vector<std::uint32_t>(mesh.cell_region.size(), packed({0.93, 0.935, 0.94})));
  canvas.image(frame.corner, image, pixels_per_unit);
  if (mesh.cell_count() < few_cells)
    draw_thin_edges(canvas, frame, mesh.points, inner_edges(mesh), {{0, 0, 0}, 0.2, 0, 0.22});
  draw_chains(canvas, frame, mesh.points, outlines(mesh), outline_style);
  draw_chains(canvas, frame, mesh.points, joint_lines(mesh), joint_style);
  draw_axes(canvas, frame);
  if (!varied) return;
  mark_extremes(canvas, frame, image, plan.field, plan.unit);
  draw_bar(canvas, frame, plan.bands, plan.unit);
}

}  // namespace

Picture field_picture(const PictureSource& source, const std::string& quantity) {
  auto found = drawn_field(source, quantity);
  if (!found) return {};
  const mesh::Mesh& mesh = source.model.mesh;
  const auto plan = std::make_shared<const Plan>(plan_of(std::move(*found), mesh));
  return {file_name(quantity), plan->frame.page_height, [source, &mesh, plan](Canvas& canvas) {
            draw_title(canvas, full_title(plan->field),
                       "stage " + source.stage.name +
                           (plan->field.stress ? " · tension positive · " : " · ") + source.scene.title);
            draw_field(canvas, mesh, *plan);
          }};
}

}  // namespace ashlar::output
