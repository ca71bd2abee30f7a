#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon.hpp"
#include "output/pictures/labels.hpp"
#include "output/pictures/outlines.hpp"
#include "output/pictures/pictures.hpp"

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

/// The cell of the region with the most room about it for a label, rather near the region's middle.
Point label_place(const mesh::Mesh& mesh, Index region, const std::vector<std::array<Point, 2>>& lines) {
  std::vector<Point> middles;
  Point center;
  Bounds bounds;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    if (mesh.cell_region[cell] != region) continue;
    middles.push_back(middle_of(mesh, cell));
    center = center + middles.back();
    bounds.add(middles.back());
  }
  if (middles.empty()) return center;
  center = (1.0 / static_cast<double>(middles.size())) * center;
  // A few hundred places and lines tell enough.
  const std::size_t stride = middles.size() / 300 + 1, line_stride = lines.size() / 1000 + 1;
  Point best = middles.front();
  double most = -1e300;
  for (std::size_t i = 0; i < middles.size(); i += stride) {
    double room = 1e300;
    for (std::size_t k = 0; k < lines.size(); k += line_stride)
      room = std::min(room, geometry::distance_to_segment(middles[i], lines[k][0], lines[k][1]));
    const double worth = room - 0.15 * geometry::distance(middles[i], center);
    if (worth <= most) continue;
    most = worth;
    best = middles[i];
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

Image draw_cells(Canvas& canvas, const Frame& frame, const mesh::Mesh& mesh, std::span<const Point> points) {
  Image image = tinted_cells(frame, mesh, points);
  const auto edges = inner_edges(mesh);
  const bool few = mesh.cell_count() < few_cells;
  if (!few) draw_edges(image, frame.view(), points, edges, edge_width(frame, mesh));
  canvas.image(frame.corner, image, pixels_per_unit);
  if (few)
    draw_thin_edges(canvas, frame, points, edges, {{0.25, 0.27, 0.30}, 0.3 * edge_width(frame, mesh) / 0.85});
  return image;
}

// Beside the line, at its middle or elsewhere along it.
void label_joint(Canvas& canvas, const Frame& frame, const mesh::Mesh& mesh, const mesh::JointLips& joint,
                 Labels& labels) {
  const auto& lip = joint.lips[0];
  if (lip.empty()) return;
  TextStyle style{8, joint_color};
  style.halo = true;
  const double width = canvas.text_width(joint.name, style), height = 7;
  std::vector<Point> corners;
  for (const double t : {0.5, 0.35, 0.65, 0.2, 0.8, 0.08, 0.92}) {
    const double s = lip.front().s_from + t * (lip.back().s_to - lip.front().s_from);
    const mesh::LipEdge& edge =
        *std::find_if(lip.begin(), lip.end() - 1, [s](const mesh::LipEdge& each) { return each.s_to >= s; });
    const Point a = frame.at(mesh.points[edge.from]), b = frame.at(mesh.points[edge.to]);
    const Point along = (1 / std::max(geometry::distance(a, b), 1e-12)) * (b - a);
    for (const double side : {1.0, -1.0}) {
      const Point aside = side * Point{-along.y, along.x};
      // As far as the box reaches across the line, and a gap.
      const double off = (std::abs(aside.x) * width + std::abs(aside.y) * height) / 2 + 2.5;
      corners.push_back(0.5 * (a + b) + off * aside - Point{width / 2, height / 2});
    }
  }
  const Box box = labels.place(corners, width, height);
  canvas.text(box.corner.x, box.corner.y + height - 1.2, joint.name, style);
}

// Joints first: they have less choice.
void draw_names(Canvas& canvas, const Frame& frame, const mesh::Mesh& mesh, const Image& image) {
  Labels labels(frame, image);
  std::vector<std::array<Point, 2>> lines;
  for (const auto& chains : {outlines(mesh), joint_lines(mesh)})
    for (const std::vector<Index>& chain : chains)
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        lines.push_back({mesh.points[chain[i]], mesh.points[chain[i + 1]]});
  for (const auto& [a, b] : lines) labels.shun(frame.at(a), frame.at(b));
  for (const mesh::JointLips& joint : mesh.joints) label_joint(canvas, frame, mesh, joint, labels);
  TextStyle style{8.5};
  style.halo = true;
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    const double width = canvas.text_width(mesh.regions[r], style), height = 8;
    const Point wish = frame.at(label_place(mesh, static_cast<Index>(r), lines));
    const Box box = labels.near(wish, width, height);
    canvas.text(box.corner.x, box.corner.y + height - 1.5, mesh.regions[r], style);
  }
}

// The factor is made for the largest body, not for the distances between bodies.
double largest_body(const mesh::Mesh& mesh) {
  Index count = 0;
  const std::vector<Index> body = mesh::bodies(mesh, count);
  std::vector<Bounds> bounds(count);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const Index p : mesh.cell_points[cell]) bounds[body[cell]].add(mesh.points[p]);
  double size = 0;
  for (const Bounds& b : bounds) size = std::max(size, std::hypot(b.right - b.left, b.top - b.bottom));
  return size;
}

// "10 000": digits in threes.
std::string grouped(std::string digits) {
  for (int at = static_cast<int>(digits.size()) - 3; digits.size() > 4 && at > 0; at -= 3)
    digits.insert(at, "\u2009");
  return digits;
}

}  // namespace

Picture mesh_picture(const model::Scene& scene, const model::Model& model) {
  const mesh::Mesh& mesh = model.mesh;
  const Frame frame = make_frame(bounds_of(mesh.points), {});
  return {"mesh", frame.page_height, [&scene, &mesh, frame](Canvas& canvas) {
            const std::string counts = std::to_string(mesh.cell_count()) + " cells, " +
                                       std::to_string(mesh.point_count()) + " points";
            draw_title(canvas, "Mesh", scene.title.empty() ? counts : counts + " · " + scene.title);
            const Image image = draw_cells(canvas, frame, mesh, mesh.points);
            draw_chains(canvas, frame, mesh.points, outlines(mesh), outline_style);
            draw_chains(canvas, frame, mesh.points, joint_lines(mesh), joint_style);
            draw_names(canvas, frame, mesh, image);
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
  const double size = largest_body(mesh);
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
  const Frame frame = make_frame(bounds, {});
  return {"deformed", frame.page_height, [source, &mesh, frame, moved, factor, largest](Canvas& canvas) {
            const std::string times = factor >= 1 ? grouped(tick_text(factor, 1)) : value_text(factor);
            draw_title(canvas, "Deformed shape, displacements × " + times,
                       "stage " + source.stage.name + " · greatest displacement " +
                           value_text(largest, unit_scale("m", largest), "m") + " · " + source.scene.title);
            draw_cells(canvas, frame, mesh, moved);
            const auto lines = outlines(mesh);
            draw_chains(canvas, frame, mesh.points, lines, {{0.45, 0.47, 0.50}, 0.6, 2.4});
            draw_chains(canvas, frame, moved, lines, outline_style);
            draw_axes(canvas, frame);
          }};
}

}  // namespace ashlar::output
