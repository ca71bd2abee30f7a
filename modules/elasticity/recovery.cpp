#include "elasticity/recovery.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.hpp"
#include "elasticity/cell_access.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

using model::Model;

CellStresses cell_stresses(const Model& model, const mesh::Adjacency& dofs, std::span<const double> u) {
  const auto count = static_cast<std::size_t>(model.mesh.cell_count());
  CellStresses found{std::vector<model::Voigt>(count), std::vector<model::Voigt>(count),
                     std::vector<double>(count), std::vector<Point>(count)};
  core::parallel_for(count, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const auto index = static_cast<Index>(c);
      const Scratch<double, 64> local = gather(dofs[index], u);
      with_cell(model, index, [&](const model::Cell& cell) {
        found.area[c] = geometry::signed_area(cell.corners);
        found.centroid[c] = geometry::centroid(cell.corners);
        found.strain[c] = model.element->strain(cell, local, found.centroid[c]);
      });
      found.stress[c] = model.material(index).respond(found.strain[c], {}, {}).stress;
    }
  });
  return found;
}

namespace {

bool same_stiffness(const model::Material& a, const model::Material& b) {
  return &a == &b || (a.shear_modulus() == b.shear_modulus() && a.plane_modulus() == b.plane_modulus());
}

/// Value at `at` of the best linear fit; false if the centroids are too few or nearly on one line.
bool fit(const CellStresses& cells, std::span<const Index> patch, Point at, Stress& value) {
  if (patch.size() < 3) return false;
  double area = 0;
  Point middle;
  Stress mean{};
  for (const Index c : patch) {
    area += cells.area[c];
    middle = middle + cells.area[c] * cells.centroid[c];
    for (std::size_t k = 0; k < 4; ++k) mean[k] += cells.area[c] * cells.stress[c][k];
  }
  middle = (1 / area) * middle;
  double xx = 0, xy = 0, yy = 0;
  Stress along_x{}, along_y{};
  for (const Index c : patch) {
    const Point d = cells.centroid[c] - middle;
    const double w = cells.area[c];
    xx += w * d.x * d.x;
    xy += w * d.x * d.y;
    yy += w * d.y * d.y;
    for (std::size_t k = 0; k < 4; ++k) {
      along_x[k] += w * d.x * cells.stress[c][k];
      along_y[k] += w * d.y * cells.stress[c][k];
    }
  }
  // Spread across the line less than a tenth of that along it: a slope would be guessed.
  const double determinant = xx * yy - xy * xy, trace = xx + yy;
  if (determinant < 0.01 * trace * trace * 0.25) return false;
  const Point d = at - middle;
  const double to_x = (yy * d.x - xy * d.y) / determinant, to_y = (xx * d.y - xy * d.x) / determinant;
  for (std::size_t k = 0; k < 4; ++k) value[k] = mean[k] / area + to_x * along_x[k] + to_y * along_y[k];
  return true;
}

/// Recovers at one point after another; keeps its lists between points.
class Recovery {
 public:
  Recovery(const Model& model, const CellStresses& cells, const mesh::Adjacency& cells_of_point)
      : model_(model), cells_(cells), cells_of_point_(cells_of_point) {}

  Stress at(Index point) {
    const auto around = cells_of_point_[point];
    double total = 0;
    Stress sum{};
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (!first_of_its_material(around, i)) continue;
      gather_patch(around, model_.material(around[i]));
      double area = 0;
      for (const Index c : patch_) area += cells_.area[c];
      const Stress value = patch_value(point);
      for (std::size_t k = 0; k < 4; ++k) sum[k] += area * value[k];
      total += area;
    }
    if (total > 0)
      for (double& component : sum) component /= total;
    return sum;
  }

 private:
  bool first_of_its_material(std::span<const Index> around, std::size_t i) const {
    for (std::size_t k = 0; k < i; ++k)
      if (same_stiffness(model_.material(around[k]), model_.material(around[i]))) return false;
    return true;
  }

  void gather_patch(std::span<const Index> cells, const model::Material& material) {
    patch_.clear();
    for (const Index c : cells)
      if (same_stiffness(model_.material(c), material)) patch_.push_back(c);
  }

  Stress patch_value(Index point) {
    const Point at = model_.mesh.points[point];
    Stress value{};
    if (fit(cells_, patch_, at, value)) return value;
    widen();
    if (fit(cells_, wide_, at, value)) return value;
    double area = 0;
    for (const Index c : patch_) {
      area += cells_.area[c];
      for (std::size_t k = 0; k < 4; ++k) value[k] += cells_.area[c] * cells_.stress[c][k];
    }
    for (double& component : value) component /= area;
    return value;
  }

  /// The patch and all cells of its material that touch it.
  void widen() {
    const model::Material& material = model_.material(patch_.front());
    wide_.assign(patch_.begin(), patch_.end());
    for (const Index inner : patch_)
      for (const Index p : model_.mesh.cell_points[inner])
        for (const Index c : cells_of_point_[p])
          if (same_stiffness(model_.material(c), material)) wide_.push_back(c);
    std::sort(wide_.begin(), wide_.end());
    wide_.erase(std::unique(wide_.begin(), wide_.end()), wide_.end());
  }

  const Model& model_;
  const CellStresses& cells_;
  const mesh::Adjacency& cells_of_point_;
  std::vector<Index> patch_, wide_;
};

}  // namespace

std::vector<Stress> recover_at_points(const Model& model, const CellStresses& cells) {
  const mesh::Adjacency cells_of_point = model.mesh.cell_points.transposed(model.mesh.point_count());
  std::vector<Stress> values(static_cast<std::size_t>(model.mesh.point_count()));
  core::parallel_for(values.size(), 256, [&](std::size_t begin, std::size_t end) {
    Recovery recovery(model, cells, cells_of_point);
    for (std::size_t p = begin; p < end; ++p) values[p] = recovery.at(static_cast<Index>(p));
  });
  return values;
}

Principal principal(const Stress& s) {
  const double middle = 0.5 * (s[0] + s[1]), half = 0.5 * (s[0] - s[1]);
  const double radius = std::hypot(half, s[2]);
  Principal found;
  found.s1 = middle + radius;
  found.s3 = middle - radius;
  found.angle = radius > 0 ? 90 / std::numbers::pi * std::atan2(s[2], half) : 0;
  return found;
}

double von_mises(const Stress& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[3], zx = s[3] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * s[2] * s[2]);
}

}  // namespace ashlar::elasticity
