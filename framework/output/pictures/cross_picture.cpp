#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "geometry/polygon.hpp"
#include "output/pictures/outlines.hpp"
#include "output/pictures/pictures.hpp"

namespace ashlar::output {

using geometry::Point;
using mesh::Index;
using model::FieldResult;

namespace {

const Color tension = oklch(0.55, 0.21, 27), compression = oklch(0.40, 0.15, 260);
const LineStyle outline_style{{0.10, 0.11, 0.13}, 0.7};
const LineStyle joint_style{{0.10, 0.11, 0.13}, 1.15};
constexpr double spacing = 11.5;     // of crosses, in units of the page
constexpr double longest = 0.62;     // half an arm over the spacing: neighbours hardly touch
constexpr double negligible = 0.03;  // of the scale: such an arm would be a dot

/// A cell's principal stresses in the plane.
struct Cross {
  Point at;
  double s1 = 0, s3 = 0, angle = 0;  ///< angle from x to s1 [rad]
};

const FieldResult* cell_field(const model::StageResult& stage, const std::string& name) {
  for (const FieldResult& field : stage.fields)
    if (field.name == name && field.on == FieldResult::On::cells) return &field;
  return nullptr;
}

/// From the stresses of cells, or from their principal stresses and angles.
std::optional<std::vector<Cross>> crosses_of(const PictureSource& source) {
  const FieldResult* stress = cell_field(source.stage, "stress");
  const FieldResult* principal = cell_field(source.stage, "principal_stress");
  const FieldResult* angle = cell_field(source.stage, "principal_angle");
  if (!stress && !(principal && angle)) return {};
  std::vector<Cross> crosses;
  std::vector<Point> corners;
  for (Index cell = 0; cell < source.model.mesh.cell_count(); ++cell) {
    const auto c = static_cast<std::size_t>(cell);
    Cross& each = crosses.emplace_back();
    each.at = geometry::centroid(source.model.mesh.corners(cell, corners));
    if (stress) {
      const double* s = stress->values.data() + c * static_cast<std::size_t>(stress->width);
      const double middle = 0.5 * (s[0] + s[1]), radius = std::hypot(0.5 * (s[0] - s[1]), s[2]);
      each.s1 = middle + radius;
      each.s3 = middle - radius;
      each.angle = 0.5 * std::atan2(s[2], 0.5 * (s[0] - s[1]));
    } else {
      each.s1 = principal->values[2 * c];
      each.s3 = principal->values[2 * c + 1];
      each.angle = angle->values[c] * std::acos(-1.0) / 180;
    }
    if (!std::isfinite(each.s1) || !std::isfinite(each.s3)) return {};
  }
  return crosses;
}

double largest_of(const Cross& cross) {
  return std::max(std::abs(cross.s1), std::abs(cross.s3));
}

/// In each square of a grid the one nearest to its middle.
std::vector<Cross> thinned(const std::vector<Cross>& all, const Frame& frame) {
  std::map<std::pair<int, int>, std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Point p = frame.at(all[i].at);
    const double column = std::floor(p.x / spacing), row = std::floor(p.y / spacing);
    const double off = geometry::distance(p, {(column + 0.5) * spacing, (row + 0.5) * spacing});
    const auto [at, is_new] = nearest.try_emplace({static_cast<int>(column), static_cast<int>(row)}, off, i);
    if (!is_new && off < at->second.first) at->second = {off, i};
  }
  std::vector<Cross> chosen;
  for (const auto& [square, each] : nearest) chosen.push_back(all[each.second]);
  return chosen;
}

/// The stress of a full arm: a round number that 97 % of the crosses stay below.
double full_arm(const std::vector<Cross>& crosses) {
  std::vector<double> sizes;
  for (const Cross& cross : crosses) sizes.push_back(largest_of(cross));
  std::ranges::sort(sizes);
  const double most = sizes[static_cast<std::size_t>(0.97 * static_cast<double>(sizes.size() - 1))];
  return most > 0 ? round_up(most) : 1;
}

/// Tension: a line with arrowheads that point outward. Compression: a plain, thicker line.
void draw_arm(Canvas& canvas, Point middle, Point half, bool pulls) {
  const Point a = middle - half, b = middle + half;
  canvas.line(a, b, {pulls ? tension : compression, pulls ? 0.65 : 1.0});
  if (!pulls) return;
  const double length = geometry::norm(half), head = std::min(2.1, 0.6 * length);
  for (const double sense : {1.0, -1.0}) {
    const Point out = (sense / length) * half, tip = middle + sense * half;
    const Point aside = 0.42 * head * geometry::left_of(out), back = tip - head * out;
    const Point ring[] = {tip, back + aside, back - aside};
    canvas.fill(ring, tension);
  }
}

/// `full`: the stress of a whole arm. Greater ones are cut there, and their ends say so with a bar.
void draw_cross(Canvas& canvas, const Cross& cross, Point at, double full) {
  const auto arm = [&](double stress, double angle) {
    const double share = std::abs(stress) / full;
    if (share < negligible) return;
    const double half = longest * spacing * std::min(share, 1.0);
    const Point along{half * std::cos(angle), -half * std::sin(angle)};  // the page's y points down
    draw_arm(canvas, at, along, stress > 0);
    if (share <= 1) return;
    const Point aside = (1.5 / half) * geometry::left_of(along);
    for (const Point end : {at + along, at - along})
      canvas.line(end - aside, end + aside, {stress > 0 ? tension : compression, 0.65});
  };
  const double right_angle = std::acos(0.0);
  // The greater one first: the smaller stays visible upon it.
  const bool first = std::abs(cross.s1) > std::abs(cross.s3);
  arm(first ? cross.s1 : cross.s3, first ? cross.angle : cross.angle + right_angle);
  arm(first ? cross.s3 : cross.s1, first ? cross.angle + right_angle : cross.angle);
}

/// A full arm of each kind, with its stress.
void draw_key(Canvas& canvas, double full, double y) {
  const double half = longest * spacing;
  const std::string size = value_text(full, unit_scale("Pa", full), "Pa");
  const TextStyle style{7.5};
  double x = 22;
  for (const bool pulls : {false, true}) {
    draw_arm(canvas, {x, y}, {half, 0}, pulls);
    const std::string text = std::string(pulls ? "tension " : "compression ") + size;
    canvas.text(x + half + 5, y + 2.6, text, style);
    x += 2 * half + 26 + canvas.text_width(text, style);
  }
  canvas.text(x - half, y + 2.6, "cut at the bars: more", style);
}

}  // namespace

Picture cross_picture(const PictureSource& source) {
  const auto all = crosses_of(source);
  if (!all || all->empty()) return {};
  constexpr double key_height = 14;
  const mesh::Mesh& mesh = source.model.mesh;
  const Frame frame = make_frame(bounds_of(mesh.points), {});
  const double full = full_arm(*all);
  return {"crosses", frame.page_height + key_height,
          [source, &mesh, frame, full, crosses = thinned(*all, frame)](Canvas& canvas) {
            draw_title(canvas, "Crosses of principal stresses",
                       "stage " + source.stage.name + " · " + source.scene.title);
            Image image = frame.image();
            fill_cells(image, frame.view(), {mesh.points, mesh.cell_points},
                       std::vector<std::uint32_t>(mesh.cell_region.size(), packed({0.96, 0.962, 0.965})));
            canvas.image(frame.corner, image, pixels_per_unit);
            draw_chains(canvas, frame, mesh.points, outlines(mesh), outline_style);
            draw_chains(canvas, frame, mesh.points, joint_lines(mesh), joint_style);
            for (const Cross& cross : crosses) draw_cross(canvas, cross, frame.at(cross.at), full);
            draw_axes(canvas, frame);
            draw_key(canvas, full, frame.page_height + 4);
          }};
}

}  // namespace ashlar::output
