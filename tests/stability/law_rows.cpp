// Hard materials: stiffnesses that differ by many digits, Poisson's ratios at both ends.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "convergence/families.hpp"
#include "convergence/norms.hpp"
#include "stability/hard_meshes.hpp"
#include "stability/patch_run.hpp"
#include "testing/meshes.hpp"

namespace ashlar::stability {

namespace {

using elasticity::Elastic;

/// Distorted quadrilaterals in two layers that meet at y = ½.
mesh::RawMesh layers(int n) {
  const auto inner = [](double x) { return x > 1e-9 && x < 1 - 1e-9; };
  mesh::RawMesh raw = mapped(testing::structured_square(n), [&](Point p) {
    if (!inner(p.x) || !inner(p.y)) return p;
    const double dy = std::abs(p.y - 0.5) < 1e-9 ? 0 : std::cos(23 * p.x - 11 * p.y);
    return p + 0.2 / n * Point{std::sin(17 * p.x + 31 * p.y), dy};
  });
  raw.regions = {"lower", "upper"};
  for (Index cell = 0; cell < raw.cell_points.size(); ++cell)
    raw.cell_region[static_cast<std::size_t>(cell)] = cell < n * n / 2 ? 0 : 1;
  return raw;
}

/// Uniform σ_yy and σ_xy: strains jump at the border as the stiffnesses do.
void add_layers(double contrast, int order, Fault fault, Outcome& outcome) {
  const double nu = 0.3, sigma = 3e5, tau = -2e5;
  const std::array e = {1e9, 1e9 * contrast};
  const mesh::Mesh mesh = bare(layers(8));
  const auto law = [&](int layer) {
    return std::make_shared<Elastic>(e[static_cast<std::size_t>(layer)], nu, model::Plane::strain);
  };
  const auto exact = [&](Point p) {
    const double modulus = p.y < 0.5 ? e[0] : e[1], mu = modulus / (2 * (1 + nu));
    const double m = 2 * mu * (1 - nu) / (1 - 2 * nu);
    return Point{tau / mu * (p.y - 0.5), sigma / m * (p.y - 0.5)};
  };
  patch::Solid solid(mesh, law(0), with_fault(element_of(order), fault, mesh));
  solid.model.materials = {law(0), law(1)};
  solid.hold_border(exact);
  if (solid.solve().empty()) throw std::runtime_error(solid.failure);
  std::array<double, 2> error{}, largest{};
  for (Index p = 0; p < mesh.point_count(); ++p) {
    const Point at = mesh.points[static_cast<std::size_t>(p)];
    if (at.y == 0.5) continue;
    const std::size_t layer = at.y < 0.5 ? 0 : 1;
    error[layer] = std::max(error[layer], distance(solid.displacement(p), exact(at)));
    largest[layer] = std::max(largest[layer], norm(exact(at)));
  }
  double stress = 0;
  const auto cells =
      elasticity::cell_stresses(solid.model, elasticity::Layout(solid.model), solid.state.committed(0));
  for (const elasticity::Stress& s : cells.stress)
    stress = std::max({stress, std::abs(s[1] - sigma) / sigma, std::abs(s[2] - tau) / sigma});
  const std::string name = "order " + std::to_string(order);
  outcome.worst(name + " u", std::max(error[0] / largest[0], error[1] / largest[1]), patch_bound(order));
  outcome.worst(name + " σ", stress, 100 * patch_bound(order));
}

Case contrast_row() {
  Case row;
  row.group = "Materials";
  row.name = "stiffness 10⁻⁸ to 10⁸ times the neighbour's";
  row.risk = "small strains of the stiff layer drown in the soft one's round-off";
  row.bound =
      "the patch test's, each layer against its own displacement: scaling rows and columns by √E takes the "
      "contrast out of the matrix, and a Cholesky factor does not depend on scaling";
  row.plants = {Fault::wrong_sign, Fault::lost_unknown};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const double contrast : {1e-8, 1e-4, 1e4, 1e8})
      for (int order = 1; order <= 3; ++order) add_layers(contrast, order, fault, outcome);
    return outcome;
  };
  return row;
}

Case poisson_row() {
  Case row;
  row.group = "Materials";
  row.name = "Poisson's ratio −0.9 to 0.4999999, plane strain";
  row.risk = "λ/μ reaches 5·10⁶; mean stress is λ times a vanishing change of area";
  row.bound =
      "the patch test's, or where that is more 2e-16 λ/μ on displacements: forces round by λ, and modes that "
      "keep their area answer with μ; a hundred times that on stresses";
  row.plants = {Fault::wrong_sign, Fault::dropped_edge};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const double nu : {-0.9, -0.5, 0.0, 0.3, 0.49, 0.4999, 0.499999, 0.4999999}) {
      const double ratio = std::abs(2 * nu / (1 - 2 * nu));
      for (const auto& raw : {testing::distorted_square(6), testing::honeycomb_square(6)})
        add_patch_tests(bare(raw), {{0.3, 0.1}, nu, std::max(1.0, 2e-4 * ratio), 1}, fault, outcome);
    }
    return outcome;
  };
  return row;
}

Case locking_row() {
  Case row;
  row.group = "Materials";
  row.name = "Poisson's ratio 0.49 to 0.4999999, a field that keeps its volume";
  row.risk = "locking: cells that cannot bend without changing their area";
  row.bound =
      "errors in L2 and energy at most 1.5 times those at 0.3: the exact displacement is the same, the best "
      "approximation that keeps its volume is a little worse, locking multiplies by hundreds";
  row.plants = {Fault::stiff_rest};
  row.run = [](Fault fault) {
    Outcome outcome;
    const double mu = 1e9;
    for (const auto& choice :
         {std::pair{"distorted", 1}, {"voronoi", 1}, {"distorted", 2}, {"voronoi", 2}, {"triangles", 2}}) {
      const char* const family = choice.first;
      const int order = choice.second;
      const mesh::Mesh mesh = convergence::family_mesh(family, 10);
      const auto errors = [&](double nu) {
        patch::Solid solid(mesh, std::make_shared<Elastic>(2 * mu * (1 + nu), nu, model::Plane::strain),
                           with_fault(element_of(order), fault, mesh));
        return convergence::solved_norms(solid, convergence::swirl(mu));
      };
      const convergence::Norms soft = errors(0.3);
      for (const double nu : {0.49, 0.4999, 0.4999999}) {
        const convergence::Norms hard = errors(nu);
        outcome.worst(std::string(family) + " " + std::to_string(order),
                      std::max(hard.displacement / soft.displacement, hard.energy / soft.energy), 1.5);
      }
    }
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> law_rows() {
  return {contrast_row(), poisson_row(), locking_row()};
}

}  // namespace ashlar::stability
