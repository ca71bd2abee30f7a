#include "elasticity/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "elasticity/cell_access.hpp"
#include "elasticity/polynomials.hpp"
#include "elasticity/triangle_rule.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::elasticity {

namespace {

/// Squares of errors and of what they are measured against, summed over cells.
struct Sums {
  double displacement = 0, displacement_scale = 0;
  double stress = 0, stress_scale = 0;
  double energy = 0, energy_scale = 0;
  void add(const Sums& other) {
    displacement += other.displacement;
    displacement_scale += other.displacement_scale;
    stress += other.stress;
    stress_scale += other.stress_scale;
    energy += other.energy;
    energy_scale += other.energy_scale;
  }
};

/// One `Exact` of the scene.
struct Exact {
  std::string name;
  const core::Value* displacement = nullptr;  ///< functions; null: not given
  const core::Value* stress = nullptr;
};

std::vector<double> ask(const core::Value& value, Point at, std::size_t least, std::size_t most,
                        const char* wanted) {
  const std::array<double, 2> arguments{at.x, at.y};
  std::vector<double> values = value.function()->call(arguments);
  const bool finite = std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
  if (values.size() < least || values.size() > most || !finite)
    throw core::InputError(core::Mistake{
        value.place,
        "at (" + core::format_quantity(at.x, {1, 0, 0}) + ", " + core::format_quantity(at.y, {1, 0, 0}) +
            ") the function returns " +
            (finite ? std::to_string(values.size()) + (values.size() == 1 ? " number" : " numbers")
                    : std::string("what is no finite number")),
        std::string("it must return ") + wanted});
  return values;
}

/// Polynomials of one cell: columns are components.
struct CellFit {
  Frame frame;
  Eigen::MatrixXd displacement, stress;

  static Eigen::RowVectorXd row(Point xi, Eigen::Index size) {
    Eigen::RowVectorXd values(size);
    for (Eigen::Index m = 0; m < size; ++m) values[m] = monomial(static_cast<int>(m), xi);
    return values;
  }
  Eigen::RowVectorXd displacement_at(Point x) const {
    return row(frame.to_local(x), displacement.rows()) * displacement;
  }
  Eigen::RowVectorXd stress_at(Point x) const { return row(frame.to_local(x), stress.rows()) * stress; }
};

/// Least squares through the cell's nodes, and the means of v m_γ if the element has them.
Eigen::MatrixXd fit_displacement(const model::Model& model, std::span<const Point> corners,
                                 const Frame& frame, std::span<const double> local) {
  const int n = static_cast<int>(corners.size()), k = model.element->order(),
            edge = model.element->nodes().per_edge;
  const int size = monomials(k), nodes = n * (1 + edge);
  const int moments = k > 1 && model.element->nodes().per_cell == monomials(k - 2) ? monomials(k - 2) : 0;
  Eigen::MatrixXd left(nodes + moments, size), right(nodes + moments, 2);
  for (int i = 0; i < n; ++i)
    for (int g = 0; g <= edge; ++g) {
      const double t = g == 0 ? 0 : model.element->edge_node(g - 1);
      const int row = g == 0 ? i : n + i * edge + g - 1;
      const Point at =
          (1 - t) * corners[static_cast<std::size_t>(i)] + t * corners[static_cast<std::size_t>((i + 1) % n)];
      left.row(row) = CellFit::row(frame.to_local(at), size);
    }
  std::vector<Point> ring;
  for (const Point corner : corners) ring.push_back(frame.to_local(corner));
  const std::vector<double> integrals = geometry::monomial_integrals(ring, {}, 2 * k);
  for (int c = 0; c < moments; ++c)
    for (int a = 0; a < size; ++a) {
      const int p = powers_of(a).p + powers_of(c).p, q = powers_of(a).q + powers_of(c).q;
      left(nodes + c, a) = integrals[static_cast<std::size_t>(number_of(p, q))] / integrals[0];
    }
  for (Eigen::Index row = 0; row < right.rows(); ++row)
    for (Eigen::Index c = 0; c < 2; ++c) right(row, c) = local[static_cast<std::size_t>(2 * row + c)];
  return left.colPivHouseholderQr().solve(right);
}

/// Through the law's answers: of one degree less than the displacement.
Eigen::MatrixXd fit_stress(std::span<const Sample> samples, int order, const Frame& frame) {
  Eigen::Index count = 0;
  for (const Sample& sample : samples) count += sample.area > 0 ? 1 : 0;
  int degree = order - 1;
  while (degree > 0 && monomials(degree) > count) --degree;
  Eigen::MatrixXd left(count, monomials(degree)), right(count, 4);
  Eigen::Index i = 0;
  for (const Sample& sample : samples) {
    if (sample.area <= 0) continue;
    left.row(i) = CellFit::row(frame.to_local(sample.at), left.cols());
    for (Eigen::Index c = 0; c < 4; ++c) right(i, c) = sample.stress[static_cast<std::size_t>(c)];
    ++i;
  }
  return left.colPivHouseholderQr().solve(right);
}

/// Inverse of the law's tangent at rest for the components that do work: zz only around an axis.
Eigen::MatrixXd compliance(const model::Model& model, Index cell) {
  const int size = model.axisymmetric() ? 4 : 3;
  const model::Material& law = model.material(cell);
  const std::vector<double> none(static_cast<std::size_t>(law.internal_variables()));
  std::vector<double> trial = none;
  const model::Tangent tangent = law.respond({}, none, trial).tangent;
  Eigen::MatrixXd d(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) d(i, j) = tangent[static_cast<std::size_t>(4 * i + j)];
  return d.inverse();
}

void add_point(const Exact& exact, const CellFit& fit, const Eigen::MatrixXd& compliance, Point at,
               double weight, Sums& sums) {
  if (exact.displacement) {
    const std::vector<double> u = ask(*exact.displacement, at, 2, 2, "two numbers: ux, uy [m]");
    const Eigen::RowVectorXd found = fit.displacement_at(at);
    const Eigen::RowVector2d right(u[0], u[1]);
    sums.displacement += weight * (found - right).squaredNorm();
    sums.displacement_scale += weight * right.squaredNorm();
  }
  if (!exact.stress) return;
  const std::vector<double> s =
      ask(*exact.stress, at, 3, 4, "three or four numbers: xx, yy, xy, and zz [Pa]");
  Eigen::Vector4d right(s[0], s[1], s[2], s.size() > 3 ? s[3] : 0);
  Eigen::Vector4d wrong = fit.stress_at(at).transpose() - right;
  if (s.size() < 4) wrong[3] = 0;
  const Eigen::Vector4d twice(1, 1, 2, 1);
  sums.stress += weight * wrong.cwiseAbs2().dot(twice);
  sums.stress_scale += weight * right.cwiseAbs2().dot(twice);
  const Eigen::Index size = compliance.rows();
  sums.energy += weight * wrong.head(size).dot(compliance * wrong.head(size));
  sums.energy_scale += weight * right.head(size).dot(compliance * right.head(size));
}

Sums cell_sums(const model::Model& model, const Layout& layout, const Exact& exact, std::span<const double> u,
               const CellStresses& cells, Index cell) {
  std::vector<Point> store;
  const std::span<const Point> corners = model.mesh.corners(cell, store);
  const Scratch<double, 64> local = gather(layout.dofs[cell], u);
  CellFit fit{Frame(corners), {}, {}};
  fit.displacement = fit_displacement(model, corners, fit.frame, local);
  fit.stress = fit_stress(cells.of(cell), model.element->order(), fit.frame);
  const Eigen::MatrixXd inverse = compliance(model, cell);
  Sums sums;
  for (const auto& [a, b, c] : geometry::triangulate(corners)) {
    const std::array<Point, 3> of{corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)],
                                  corners[static_cast<std::size_t>(c)]};
    const double area = geometry::signed_area(of);
    for (const TrianglePoint& p : triangle_rule_6) {
      const Point at = p.a * of[0] + p.b * of[1] + (1 - p.a - p.b) * of[2];
      add_point(exact, fit, inverse, at, p.weight * area * model.depth(at), sums);
    }
  }
  return sums;
}

std::vector<Exact> exacts_of(const model::Scene& scene, const std::string& stage) {
  std::vector<Exact> found;
  const core::Settings::Entry* entry = scene.outputs.find("exact");
  if (!entry) return found;
  for (const auto& [name, settings] : entry->objects) {
    if (settings.said("stage") && settings.text("stage") != stage) continue;
    const auto given = [&of = settings](const char* key) {
      const core::Value& value = of.value(key);
      return value.function() ? &value : nullptr;
    };
    found.push_back({name, given("displacement"), given("stress")});
  }
  return found;
}

}  // namespace

void add_norms(const model::Model& model, const Layout& layout, const model::Scene& scene,
               std::span<const double> u, std::span<const double> history, model::StageResult& result) {
  const std::vector<Exact> exacts = exacts_of(scene, result.name);
  if (exacts.empty()) return;
  const CellStresses cells = cell_stresses(model, layout, u, history);
  for (const Exact& exact : exacts) {
    Sums sums;  // cell by cell in their order: the script's functions run on one thread
    for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
      sums.add(cell_sums(model, layout, exact, u, cells, cell));
    const auto add = [&](const char* quantity, const char* unit, double error, double norm) {
      result.norms.push_back({exact.name, quantity, unit, std::sqrt(error), std::sqrt(norm)});
    };
    if (exact.displacement) add("displacement", "m^2.5", sums.displacement, sums.displacement_scale);
    if (!exact.stress) continue;
    add("stress", "Pa*m^1.5", sums.stress, sums.stress_scale);
    add("energy", "J^0.5", sums.energy, sums.energy_scale);
  }
}

}  // namespace ashlar::elasticity
