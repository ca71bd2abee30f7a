// The same problem said otherwise: turned, moved, renumbered, in other units. The answer must not change.

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "meshing_voronoi/voronoi.hpp"
#include "stability/hard_meshes.hpp"
#include "stability/patch_run.hpp"
#include "stability/scene_file.hpp"
#include "testing/meshes.hpp"

namespace ashlar::stability {

namespace {

/// x ↦ R x + shift.
struct Motion {
  double angle = 0;
  Point shift;
  Point turn(Point p) const {
    // Quarter turns without round-off.
    const double quarters = angle / 90;
    if (quarters == std::round(quarters)) {
      for (int i = 0; i < static_cast<int>(quarters) % 4; ++i) p = geometry::left_of(p);
      return p;
    }
    const double c = std::cos(angle * M_PI / 180), s = std::sin(angle * M_PI / 180);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
  }
  Point operator()(Point p) const { return turn(p) + shift; }
};

/// Points on a grid of 2⁻²⁰: shifts by 2²⁰ keep every digit of them.
mesh::RawMesh dyadic(mesh::RawMesh raw) {
  return mapped(std::move(raw), [](Point p) {
    return Point{std::ldexp(std::round(std::ldexp(p.x, 20)), -20),
                 std::ldexp(std::round(std::ldexp(p.y, 20)), -20)};
  });
}

/// Displacements of the points of a body that is bent by its border and weighed, copied by a motion.
std::vector<Point> solved(const mesh::RawMesh& raw, const Motion& motion, int order, Fault fault) {
  const mesh::Mesh mesh = bare(mapped(raw, motion));
  const double mu = 1e9, nu = 0.3;
  const auto law = std::make_shared<elasticity::Elastic>(2 * mu * (1 + nu), nu, model::Plane::strain);
  patch::Solid solid(mesh, law, with_fault(element_of(order), fault, mesh));
  // Nodes on edges are found in the unmoved body, where their places keep their digits.
  const auto hold = [&](Index dof, Point p) {
    const Point u = motion.turn({std::sin(3 * p.x + p.y), std::cos(2 * p.x - 3 * p.y)});
    solid.hold_dof(dof, u.x);
    solid.hold_dof(dof + 1, u.y);
  };
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto e = static_cast<std::size_t>(edge);
    if (mesh.edge_cells[e][1] >= 0) continue;
    const auto [from, to] = mesh.edge_points[e];
    const Point a = raw.points[static_cast<std::size_t>(from)], b = raw.points[static_cast<std::size_t>(to)];
    hold(solid.model.dofs.of_point(from), a);
    hold(solid.model.dofs.of_point(to), b);
    for (int k = 0; k < order - 1; ++k) {
      const double t = solid.model.element->edge_node(k);
      hold(solid.model.dofs.of_edge(edge, k), (1 - t) * a + t * b);
    }
  }
  solid.weigh(motion.turn({1e10, -2e10}));
  if (solid.solve().empty()) throw std::runtime_error(solid.failure);
  std::vector<Point> u;
  for (Index p = 0; p < mesh.point_count(); ++p)
    u.push_back(Motion{360 - motion.angle, {}}.turn(solid.displacement(p)));
  return u;
}

double difference(const std::vector<Point>& a, const std::vector<Point>& b) {
  double most = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, distance(a[i], b[i]));
    scale = std::max(scale, norm(a[i]));
  }
  return most / scale;
}

std::vector<mesh::RawMesh> bodies() {
  return {dyadic(testing::distorted_square(8)), dyadic(testing::honeycomb_square(8)), dyadic(c_shaped(3))};
}

Case motion_row(std::string name, std::string risk, std::vector<Motion> motions, std::vector<Fault> plants) {
  Case row;
  row.group = "Copies";
  row.name = std::move(name);
  row.risk = std::move(risk);
  row.bound =
      "the patch test's: some hundred unknowns solved twice; orders 2 and 3 keep moments about a centre that "
      "rounds";
  row.plants = std::move(plants);
  row.run = [motions = std::move(motions)](Fault fault) {
    Outcome outcome;
    for (const mesh::RawMesh& raw : bodies())
      for (int order = 1; order <= 3; ++order) {
        const std::vector<Point> here = solved(raw, {}, order, Fault::none);
        for (const Motion& motion : motions)
          outcome.worst("order " + std::to_string(order), difference(here, solved(raw, motion, order, fault)),
                        patch_bound(order));
      }
    return outcome;
  };
  return row;
}

Case renumbered_row() {
  Case row;
  row.group = "Copies";
  row.name = "renumbered";
  row.risk = "an answer that hangs on the order of points, cells or corners";
  row.bound = "the patch test's: sums in another order";
  row.plants = {Fault::wrong_sign, Fault::lost_unknown};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const mesh::RawMesh& raw : bodies())
      for (int order = 1; order <= 3; ++order) {
        const std::vector<Point> here = solved(raw, {}, order, Fault::none);
        std::map<std::pair<double, double>, Point> by_place;
        for (std::size_t p = 0; p < here.size(); ++p) by_place[{raw.points[p].x, raw.points[p].y}] = here[p];
        for (const unsigned seed : {1U, 2U}) {
          const mesh::RawMesh other = renumbered(raw, seed);
          std::vector<Point> expected;
          for (const Point p : other.points) expected.push_back(by_place.at({p.x, p.y}));
          outcome.worst("order " + std::to_string(order),
                        difference(expected, solved(other, {}, order, fault)), patch_bound(order));
        }
      }
    return outcome;
  };
  return row;
}

Case units_row() {
  Case row;
  row.group = "Copies";
  row.name = "Pa to GPa, m to mm: yielding (orders 1 to 3) and contact";
  row.risk = "a tolerance, a penalty or a scaling that has a hidden unit";
  row.bound =
      "the same steps and iterates: to the bit with powers of two (2⁻³⁰, 2¹⁰), which no rounding sees; to "
      "1e-8 with "
      "10⁻⁹ and 10³: Newton's end (1e-10), a hundred times over";
  row.plants = {Fault::absolute_number};
  row.run = [](Fault fault) {
    Outcome outcome;
    const auto run = [&](const char* scene, int order, const char* pa, const char* m) {
      test::ParameterValues set{{"pa", pa}, {"m", m}};
      if (order > 0) set.emplace_back("order", std::to_string(order));
      return run_scene(scene, set, fault);
    };
    for (const auto& [scene, order] :
         {std::pair{"pushed_soil", 1}, {"pushed_soil", 2}, {"pushed_soil", 3}, {"jointed_block", 0}}) {
      const std::string name = order == 0 ? "contact" : "order " + std::to_string(order);
      const auto si = run(scene, order, "1", "1");
      compare_units(si, run(scene, order, "2^-30", "2^10"), 1024, 0, name + " binary", outcome);
      compare_units(si, run(scene, order, "1e-9", "1e3"), 1e3, 1e-8, name, outcome);
    }
    return outcome;
  };
  return row;
}

}  // namespace

std::vector<Case> copy_rows() {
  const double far = std::ldexp(1.0, 20);
  return {
      renumbered_row(),
      motion_row("turned by 30, 45, 90 and 200 degrees", "a direction that counts more than others",
                 {{30, {}}, {45, {}}, {90, {}}, {200, {}}}, {Fault::wrong_sign, Fault::lost_unknown}),
      motion_row("10⁶ sizes away from the origin (2²⁰, so that coordinates keep their digits)",
                 "areas and moments as differences of large numbers", {{0, {far, -far}}, {90, {-far, far}}},
                 {Fault::short_coordinates, Fault::wrong_sign}),
      units_row(),
  };
}

}  // namespace ashlar::stability
