#include "elasticity/recovery.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "core/parallel.hpp"
#include "elasticity/cell_access.hpp"

namespace ashlar::elasticity {

using model::Model;

namespace {

/// The law's answers at the integration points of one cell, and their means.
void sample_cell(const Model& model, const Layout& layout, std::span<const double> u,
                 std::span<const double> history, Index index, CellStresses& found) {
  thread_local model::IntegrationPoints points;
  const Scratch<double, 64> local = gather(layout.dofs[index], u);
  const model::Material& law = model.material(index);
  const auto own = static_cast<std::size_t>(law.internal_variables());
  thread_local std::vector<double> trial;
  trial.resize(own);
  const auto c = static_cast<std::size_t>(index);
  double area = 0;
  with_cell(model, index, [&](const model::Cell& cell) { model.element->integrate(cell, points); });
  for (int q = 0; q < points.size(); ++q) {
    const auto at = static_cast<std::size_t>(q);
    const double part = points.weight[at] / model.thickness;
    const model::Voigt strain = points.strain(q, local);
    const std::span<const double> committed =
        own > 0 ? history.subspan(layout.history[c] + at * own, own) : std::span<const double>();
    const Stress stress = law.respond(strain, committed, trial).stress;
    found.sample[found.start[c] + at] = {points.at[at], part, stress};
    area += part;
    for (std::size_t k = 0; k < 4; ++k) {
      found.strain[c][k] += part * strain[k];
      found.stress[c][k] += part * stress[k];
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    found.strain[c][k] /= area;
    found.stress[c][k] /= area;
  }
}

}  // namespace

CellStresses cell_stresses(const Model& model, const Layout& layout, std::span<const double> u,
                           std::span<const double> history) {
  const auto count = static_cast<std::size_t>(model.mesh.cell_count());
  CellStresses found{std::vector<model::Voigt>(count), std::vector<Stress>(count), layout.point,
                     std::vector<Sample>(layout.point.back())};
  core::parallel_for(count, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      sample_cell(model, layout, u, history, static_cast<Index>(c), found);
  });
  return found;
}

namespace {

/// Value at `at` of the best linear fit; false if the samples are too few or nearly on one line.
bool fit_linear(std::span<const Sample> samples, Point at, Stress& value) {
  if (samples.size() < 3) return false;
  double area = 0;
  Point middle;
  Stress mean{};
  for (const Sample& each : samples) {
    area += each.area;
    middle = middle + each.area * each.at;
    for (std::size_t k = 0; k < 4; ++k) mean[k] += each.area * each.stress[k];
  }
  middle = (1 / area) * middle;
  double xx = 0, xy = 0, yy = 0;
  Stress along_x{}, along_y{};
  for (const Sample& each : samples) {
    const Point d = each.at - middle;
    const double w = each.area;
    xx += w * d.x * d.x;
    xy += w * d.x * d.y;
    yy += w * d.y * d.y;
    for (std::size_t k = 0; k < 4; ++k) {
      along_x[k] += w * d.x * each.stress[k];
      along_y[k] += w * d.y * each.stress[k];
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

/// As `fit_linear` with polynomials of degree 2 or 3 about `at`, whose value there is their first
/// coefficient.
bool fit(std::span<const Sample> samples, int degree, Point at, Stress& value) {
  if (degree == 1) return fit_linear(samples, at, value);
  const auto terms = static_cast<Eigen::Index>((degree + 1) * (degree + 2) / 2);
  const auto count = static_cast<Eigen::Index>(samples.size());
  if (count < terms + 2) return false;
  double reach = 0;
  for (const Sample& each : samples) reach = std::max(reach, distance(each.at, at));
  Eigen::MatrixXd left(count, terms), right(count, 4);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& each = samples[static_cast<std::size_t>(i)];
    const Point d = (1 / reach) * (each.at - at);
    const double root = std::sqrt(std::max(each.area, 0.0));
    Eigen::Index m = 0;
    for (int order = 0; order <= degree; ++order)
      for (int q = 0; q <= order; ++q) left(i, m++) = root * std::pow(d.x, order - q) * std::pow(d.y, q);
    for (int k = 0; k < 4; ++k) right(i, k) = root * each.stress[static_cast<std::size_t>(k)];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(left);
  solver.setThreshold(1e-3);
  if (solver.rank() < terms) return false;
  const Eigen::MatrixXd solution = solver.solve(right);
  for (int k = 0; k < 4; ++k) value[static_cast<std::size_t>(k)] = solution(0, k);
  return true;
}

}  // namespace

Stress Recovery::at_point(Index point) {
  const auto around = cells_of_point_[point];
  double total = 0;
  Stress sum{};
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (!first_of_its_material(around, i)) continue;
    gather_patch(around, model_.material(around[i]));
    double area = 0;
    for (const Index c : patch_)
      for (const Sample& each : cells_.of(c)) area += each.area;
    const Stress value = patch_value(model_.mesh.points[point]);
    for (std::size_t k = 0; k < 4; ++k) sum[k] += area * value[k];
    total += area;
  }
  if (total > 0)
    for (double& component : sum) component /= total;
  return sum;
}

Stress Recovery::on_side(Point at, std::span<const Index> around, Index of) {
  gather_patch(around, model_.material(of));
  return patch_value(at);
}

bool Recovery::first_of_its_material(std::span<const Index> around, std::size_t i) const {
  for (std::size_t k = 0; k < i; ++k)
    if (same_stiffness(model_.material(around[k]), model_.material(around[i]))) return false;
  return true;
}

void Recovery::gather_patch(std::span<const Index> cells, const model::Material& material) {
  patch_.clear();
  for (const Index c : cells)
    if (same_stiffness(model_.material(c), material)) patch_.push_back(c);
}

// Fits of lower and lower degree to the cells around; each tried on their neighbours, too.
Stress Recovery::patch_value(Point at) {
  Stress value{};
  wide_.clear();
  for (int degree = model_.element->order(); degree > 0; --degree) {
    if (fit(samples_of(patch_), degree, at, value)) return value;
    if (wide_.empty()) widen();
    if (fit(samples_of(wide_), degree, at, value)) return value;
  }
  double area = 0;
  for (const Sample& each : samples_of(patch_)) {
    area += each.area;
    for (std::size_t k = 0; k < 4; ++k) value[k] += each.area * each.stress[k];
  }
  for (double& component : value) component /= area;
  return value;
}

std::span<const Sample> Recovery::samples_of(const std::vector<Index>& cells) {
  samples_.clear();
  for (const Index c : cells)
    for (const Sample& each : cells_.of(c)) samples_.push_back(each);
  return samples_;
}

// The patch and all cells of its material that touch it.
void Recovery::widen() {
  const model::Material& material = model_.material(patch_.front());
  wide_.assign(patch_.begin(), patch_.end());
  for (const Index inner : patch_)
    for (const Index p : model_.mesh.cell_points[inner])
      for (const Index c : cells_of_point_[p])
        if (same_stiffness(model_.material(c), material)) wide_.push_back(c);
  std::sort(wide_.begin(), wide_.end());
  wide_.erase(std::unique(wide_.begin(), wide_.end()), wide_.end());
}

std::vector<Stress> recover_at_points(const Model& model, const CellStresses& cells) {
  const mesh::Adjacency cells_of_point = model.mesh.cell_points.transposed(model.mesh.point_count());
  std::vector<Stress> values(static_cast<std::size_t>(model.mesh.point_count()));
  core::parallel_for(values.size(), 256, [&](std::size_t begin, std::size_t end) {
    Recovery recovery(model, cells, cells_of_point);
    for (std::size_t p = begin; p < end; ++p) values[p] = recovery.at_point(static_cast<Index>(p));
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
