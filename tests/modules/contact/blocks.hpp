#pragma once
// Two elastic blocks, one on the other, with a joint between them: bilinear quadrilaterals in plane strain,
// assembled densely. Small enough to be read at a glance, independent of the elasticity module.

#include <Eigen/Dense>

#include "contact/contact_term.hpp"
#include "contact/cycle_rules/cycle_rules.hpp"
#include "contact/enforcement/penalty/penalty.hpp"
#include "contact/friction/none/none.hpp"
#include "contact/normal_laws/unilateral/unilateral.hpp"
#include "contact/pairing/node_to_segment/node_to_segment.hpp"
#include "modules/support/hand_mesh.hpp"
#include "solve/local.hpp"

namespace ashlar::test {

using contact::ContactPoint;
using contact::ContactTerm;
using contact::JointContact;
using contact::NodeToSegment;
using Weight = contact::NodeToSegment::Weight;

constexpr double young = 1e9, poisson = 0.3;
constexpr double plane_modulus = young / (1 - poisson * poisson);

struct Blocks {
  model::Model model;
  Eigen::MatrixXd stiffness;
  std::vector<Index> bottom, top;  ///< points
};

/// Rows of points over [0, width], then the cells between them.
inline void add_block(double width, double y0, double y1, int columns, int rows, std::vector<Point>& points,
                      std::vector<std::vector<Index>>& cells) {
  const Index first = static_cast<Index>(points.size());
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) points.push_back({width * i / columns, y0 + (y1 - y0) * j / rows});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Index a = first + j * (columns + 1) + i;
      cells.push_back({a, a + 1, a + columns + 2, a + columns + 1});
    }
}

/// A lip from its points in the sense of the path.
inline std::vector<mesh::LipEdge> lip(const mesh::Mesh& mesh, const std::vector<Index>& points) {
  std::vector<mesh::LipEdge> edges;
  double s = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Index edge = edge_between(mesh, points[i], points[i + 1]);
    const double end = s + geometry::distance(mesh.points[points[i]], mesh.points[points[i + 1]]);
    edges.push_back({edge, mesh.edge_cells[edge][0], points[i], points[i + 1], s, end});
    s = end;
  }
  return edges;
}

/// ∫ Bᵀ D B over one bilinear quadrilateral, 2 × 2 points.
inline Eigen::Matrix<double, 8, 8> bilinear_stiffness(const std::array<Point, 4>& x) {
  const double f = young / ((1 + poisson) * (1 - 2 * poisson));
  Eigen::Matrix3d d;
  d << f * (1 - poisson), f * poisson, 0, f * poisson, f * (1 - poisson), 0, 0, 0, f * (0.5 - poisson);
  Eigen::Matrix<double, 8, 8> k = Eigen::Matrix<double, 8, 8>::Zero();
  const double g = 1 / std::sqrt(3.0);
  const double sx[] = {-1, 1, 1, -1}, sy[] = {-1, -1, 1, 1};
  for (const double a : {-g, g})
    for (const double b : {-g, g}) {
      Eigen::Matrix<double, 2, 4> slope;
      Eigen::Matrix<double, 4, 2> place;
      for (int i = 0; i < 4; ++i) {
        slope.col(i) << sx[i] * (1 + sy[i] * b) / 4, sy[i] * (1 + sx[i] * a) / 4;
        place.row(i) << x[i].x, x[i].y;
      }
      const Eigen::Matrix2d jacobian = slope * place;
      const Eigen::Matrix<double, 2, 4> grad = jacobian.inverse() * slope;
      Eigen::Matrix<double, 3, 8> strain = Eigen::Matrix<double, 3, 8>::Zero();
      for (int i = 0; i < 4; ++i) {
        strain(0, 2 * i) = strain(2, 2 * i + 1) = grad(0, i);
        strain(1, 2 * i + 1) = strain(2, 2 * i) = grad(1, i);
      }
      k += strain.transpose() * d * strain * jacobian.determinant();
    }
  return k;
}

inline Eigen::MatrixXd assemble(const model::Model& model) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(model.dofs.size(), model.dofs.size());
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    std::array<Point, 4> x;
    std::vector<Index> dofs;
    for (int i = 0; i < 4; ++i) x[i] = model.mesh.points[model.mesh.cell_points[cell][i]];
    model.dofs.append_cell(model.mesh, cell, dofs);
    const Eigen::Matrix<double, 8, 8> k = model.thickness * bilinear_stiffness(x);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) all(dofs[i], dofs[j]) += k(i, j);
  }
  return all;
}

/// Blocks of 2 m × 1 m each, turned by `angle` about the origin; the joint's first lip is the upper block's.
inline Blocks two_blocks(int lower, int upper, double thickness = 1, double angle = 0) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> cells;
  add_block(2, 0, 1, lower, 2, points, cells);
  const Index first = static_cast<Index>(points.size());
  add_block(2, 1, 2, upper, 2, points, cells);
  Blocks blocks;
  std::vector<Index> below, above;
  for (Index i = 0; i <= lower; ++i) {
    blocks.bottom.push_back(i);
    below.push_back(2 * (lower + 1) + i);
  }
  for (Index i = 0; i <= upper; ++i) {
    above.push_back(first + i);
    blocks.top.push_back(first + 2 * (upper + 1) + i);
  }
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point& p : points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  mesh::Mesh mesh = hand_mesh(std::move(points), cells);
  mesh.joints.push_back({"bed", {"upper", "lower"}, {lip(mesh, above), lip(mesh, below)}});
  blocks.model = plain_model(std::move(mesh), 1, thickness);
  auto material = std::make_shared<PlainMaterial>();
  material->modulus = plane_modulus;
  blocks.model.materials = {material};
  blocks.stiffness = assemble(blocks.model);
  return blocks;
}

/// The paper's contact on every joint of a model; other parts where said.
struct Parts {
  std::shared_ptr<const contact::Pairing> pairing = std::make_shared<NodeToSegment>(Weight::tributary);
  std::shared_ptr<const contact::Enforcement> enforcement = std::make_shared<contact::Penalty>(100, 0);
  contact::JointLaw law = {std::make_shared<contact::Unilateral>(),
                           std::make_shared<contact::Frictionless>()};
  int slave = 0;
};

inline ContactTerm contact_with(const model::Model& model, const Parts& parts) {
  std::vector<JointContact> joints;
  for (const mesh::JointLips& lips : model.mesh.joints)
    joints.push_back(
        {lips.name, parts.law, parts.enforcement, parts.pairing->pair(model, lips, parts.slave), {}});
  return ContactTerm(model, std::move(joints), std::make_shared<contact::WorstPoint>());
}

inline ContactTerm paper_contact(const model::Model& model, double factor, int slave = 0,
                                 Weight weight = Weight::tributary) {
  return contact_with(model, {.pairing = std::make_shared<NodeToSegment>(weight),
                              .enforcement = std::make_shared<contact::Penalty>(factor, 0),
                              .slave = slave});
}

/// A state with the displacement and the term's own arrays.
inline fields::State state_for(const model::Model& model, ContactTerm& term) {
  fields::State state;
  state.add("displacement", model.dofs.size());
  term.add_state(state);
  return state;
}

/// The jumps of the term's points at u.
inline std::vector<double> jumps_at(const ContactTerm& term, std::span<const double> u) {
  std::vector<double> jump = term.jumps().initial;
  for (Index i = 0; i < term.jumps().size(); ++i)
    for (const auto& part : term.jumps().parts[i]) jump[i] += part.factor * u[term.touched()[part.place]];
  return jump;
}

/// Bᵀ A q over all dofs for the trial state's tractions.
inline Eigen::VectorXd force_of(const model::Model& model, const ContactTerm& term,
                                const fields::State& state) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(model.dofs.size());
  ashlar::solve::add_force(term, state, {force.data(), static_cast<std::size_t>(force.size())});
  return force;
}

/// Eliminates all free dofs that the term does not touch and iterates on its jumps; the bottom is held in y,
/// its first point in x, and the dof `hold`. Leaves the result committed; returns the number of statuses, or
/// -1 if it does not settle.
inline int settle(const Blocks& blocks, const std::shared_ptr<ContactTerm>& term, const Eigen::VectorXd& load,
                  Index hold, fields::State& state) {
  model::Constraints constraints;
  constraints.held.assign(load.size(), 0);
  for (const Index point : blocks.bottom) constraints.held[2 * point + 1] = 1;
  constraints.held[2 * blocks.bottom[0]] = constraints.held[hold] = 1;
  const ashlar::solve::LocalTerms terms({term}, constraints);
  std::vector<Index> inner, kept;
  for (Index dof = 0; dof < load.size(); ++dof)
    if (!constraints.held[dof])
      (std::ranges::binary_search(terms.touched(), dof) ? kept : inner).push_back(dof);
  const Eigen::LLT<Eigen::MatrixXd> inside(blocks.stiffness(inner, inner));
  const Eigen::MatrixXd across = blocks.stiffness(kept, inner);
  const Eigen::MatrixXd schur = blocks.stiffness(kept, kept) - across * inside.solve(across.transpose());
  const Eigen::VectorXd right = load(kept) - across * inside.solve(load(inner));
  const ashlar::solve::Condensed bulk({terms.free_jumps(), terms.area(), terms.ground()}, schur, true,
                                      ashlar::algebra::eigen_dense());
  Eigen::VectorXd u(static_cast<Index>(terms.touched().size()));
  const std::span<double> all = state.trial(0);
  for (Index i = 0; i < u.size(); ++i) u[i] = all[terms.touched()[i]];
  std::vector<model::Iteration> rows;
  if (!ashlar::solve::iterate(terms, bulk, right, state, u, rows).converged) return -1;
  const Eigen::VectorXd rest = inside.solve(load(inner) - across.transpose() * u(terms.free()));
  for (std::size_t i = 0; i < inner.size(); ++i) all[inner[i]] = rest[static_cast<Index>(i)];
  for (const Index i : terms.free()) all[terms.touched()[i]] = u[i];
  state.commit();
  return static_cast<int>(rows.size());
}

/// Nodal forces of a uniform pressure on the top of level blocks.
inline Eigen::VectorXd pressure_on_top(const Blocks& blocks, double p) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(blocks.model.dofs.size());
  for (std::size_t i = 0; i + 1 < blocks.top.size(); ++i) {
    const double half = geometry::distance(blocks.model.mesh.points[blocks.top[i]],
                                           blocks.model.mesh.points[blocks.top[i + 1]]) /
                        2;
    for (const Index point : {blocks.top[i], blocks.top[i + 1]})
      load[2 * point + 1] -= p * half * blocks.model.thickness;
  }
  return load;
}

}  // namespace ashlar::test
