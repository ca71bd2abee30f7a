#include <algorithm>
#include <array>
#include <cmath>

#include "output/pictures/outlines.hpp"
#include "output/pictures/pictures.hpp"
#include "output/text_table.hpp"

namespace ashlar::output {

using geometry::Point;
using mesh::Index;

namespace {

const Color joint_color = oklch(0.50, 0.19, 27);
const LineStyle outline_style{{0.10, 0.11, 0.13}, 0.75};
const LineStyle joint_style{joint_color, 1.1};

Point middle_of(const mesh::Mesh& mesh, Index cell) {
  Point sum;
  for (const Index p : mesh.cell_points[cell]) sum = sum + mesh.points[p];
  return (1.0 / mesh.cell_points.count(cell)) * sum;
}

// Inside the region even where its centroid is not: the cell nearest to it.
Point label_place(const mesh::Mesh& mesh, Index region) {
  Point sum;
  int count = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (mesh.cell_region[cell] == region) {
      sum = sum + middle_of(mesh, cell);
      ++count;
    }
  const Point center = (1.0 / std::max(count, 1)) * sum;
  Point best = center;
  double nearest = 1e300;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Point middle = middle_of(mesh, cell);
    if (mesh.cell_region[cell] != region || geometry::distance(middle, center) >= nearest) continue;
    nearest = geometry::distance(middle, center);
    best = middle;
  }
  return best;
}

Image tinted_cells(const Frame& frame, const mesh::Mesh& mesh, std::span<const Point> points) {
  std::vector<std::uint32_t> colors;
  for (const Index region : mesh.cell_region) colors.push_back(packed(region_tint(region)));
  Image image = frame.image();
  fill_cells(image, frame.view(), {points, mesh.cell_points}, colors);
  return image;
}

// Edges of a typical cell in pixels say how thin its lines must be.
double edge_width(const Frame& frame, const mesh::Mesh& mesh) {
  const double area = frame.width * frame.height * pixels_per_unit * pixels_per_unit;
  const double cell = std::sqrt(area / std::max<Index>(1, mesh.cell_count()));
  return std::clamp(cell / 16, 0.16, 0.85);
}

void draw_cells(Canvas& canvas, const Frame& frame, const mesh::Mesh& mesh, std::span<const Point> points) {
  Image image = tinted_cells(frame, mesh, points);
  const auto edges = inner_edges(mesh);
  const bool few = mesh.cell_count() < few_cells;
  if (!few) draw_edges(image, frame.view(), points, edges, edge_width(frame, mesh));
  canvas.image(frame.corner, image, pixels_per_unit);
  if (few)
    draw_thin_edges(canvas, frame, points, edges, {{0.25, 0.27, 0.30}, 0.3 * edge_width(frame, mesh) / 0.85});
}

void label_joint(Canvas& canvas, const Frame& frame, const mesh::Mesh& mesh, const mesh::JointLips& joint) {
  const auto& lip = joint.lips[0];
  if (lip.empty()) return;
  const mesh::LipEdge& edge = lip[lip.size() / 2];
  const Point a = frame.at(mesh.points[edge.from]), b = frame.at(mesh.points[edge.to]);
  TextStyle style{8, joint_color};
  style.halo = true;
  const Point along = (1 / std::max(geometry::distance(a, b), 1e-12)) * (b - a);
  // Beside the line, on whichever side lies right of it on the page.
  Point aside = {-along.y, along.x};
  if (aside.x < 0) aside = -1.0 * aside;
  canvas.text(a.x + 5 * aside.x + 2, a.y + 5 * aside.y + 3, joint.name, style);
}

}  // namespace

Picture mesh_picture(const model::Scene& scene, const model::Model& model) {
  const mesh::Mesh& mesh = model.mesh;
  const Frame frame = make_frame(bounds_of(mesh.points), false);
  return {"mesh", frame.page_height, [&scene, &mesh, frame](Canvas& canvas) {
            const std::string counts = std::to_string(mesh.cell_count()) + " cells, " +
                                       std::to_string(mesh.point_count()) + " points";
            draw_title(canvas, "Mesh", scene.title.empty() ? counts : counts + " · " + scene.title);
            draw_cells(canvas, frame, mesh, mesh.points);
            draw_chains(canvas, frame, mesh.points, outlines(mesh), outline_style);
            draw_chains(canvas, frame, mesh.points, joint_lines(mesh), joint_style);
            TextStyle style{8.5};
            style.align = Align::center;
            style.halo = true;
            for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
              const Point at = frame.at(label_place(mesh, static_cast<Index>(r)));
              canvas.text(at.x, at.y + 3, mesh.regions[r], style);
            }
            for (const mesh::JointLips& joint : mesh.joints) label_joint(canvas, frame, mesh, joint);
            draw_axes(canvas, frame);
          }};
}

Picture deformed_picture(const PictureSource& source) {
  const mesh::Mesh& mesh = source.model.mesh;
  const auto field =
      std::find_if(source.stage.fields.begin(), source.stage.fields.end(), [](const auto& each) {
        return each.name == "displacement" && each.width == 2 && each.on == model::FieldResult::On::points;
      });
  if (field == source.stage.fields.end()) return {};
  const Bounds box = bounds_of(mesh.points);
  const double size = std::hypot(box.right - box.left, box.top - box.bottom);
  double largest = 0;
  for (std::size_t i = 0; i + 1 < field->values.size(); i += 2)
    largest = std::max(largest, std::hypot(field->values[i], field->values[i + 1]));
  if (!std::isfinite(largest)) return {};
  const double factor = largest > 1e-30 * size ? round_down(0.07 * size / largest) : 1;
  std::vector<Point> moved = mesh.points;
  Bounds bounds = box;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = moved[i] + Point{factor * field->values[2 * i], factor * field->values[2 * i + 1]};
    bounds.add(moved[i]);
  }
  const Frame frame = make_frame(bounds, false);
  return {"deformed", frame.page_height, [source, &mesh, frame, moved, factor, largest](Canvas& canvas) {
            const std::string times = factor >= 1 ? tick_text(factor, 1) : value_text(factor);
            draw_title(canvas, "Deformed shape, displacements × " + times,
                       "stage " + source.stage.name + " · greatest displacement " +
                           short_quantity(largest, "m") + " · " + source.scene.title);
            draw_cells(canvas, frame, mesh, moved);
            const auto lines = outlines(mesh);
            draw_chains(canvas, frame, mesh.points, lines, {{0.45, 0.47, 0.50}, 0.6, 2.4});
            draw_chains(canvas, frame, moved, lines, outline_style);
            draw_axes(canvas, frame);
          }};
}

}  // namespace ashlar::output
