#pragma once
// Two elastic blocks, one on the other, with a joint between them: bilinear quadrilaterals in plane strain,
// assembled densely. Small enough to be read at a glance, independent of the elasticity module.

#include <Eigen/Dense>

#include "contact/contact_term.hpp"
#include "contact/enforcement/penalty/penalty.hpp"
#include "contact/friction/none/none.hpp"
#include "contact/normal_laws/unilateral/unilateral.hpp"
#include "contact/pairing/node_to_segment/node_to_segment.hpp"
#include "modules/support/hand_mesh.hpp"

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

/// The paper's contact on every joint of a model.
inline ContactTerm paper_contact(const model::Model& model, double factor, int slave = 0,
                                 Weight weight = Weight::tributary) {
  std::vector<JointContact> joints;
  for (const mesh::JointLips& lips : model.mesh.joints)
    joints.push_back({lips.name, slave, std::make_shared<contact::Unilateral>(),
                      std::make_shared<contact::Penalty>(factor, 0),
                      std::make_shared<contact::Frictionless>(),
                      NodeToSegment(weight).pair(model, lips, slave)});
  return ContactTerm(model, std::move(joints));
}

/// A state with the displacement and the term's own arrays.
inline fields::State state_for(const model::Model& model, const ContactTerm& term) {
  fields::State state;
  state.add("displacement", model.dofs.size());
  term.add_state(state);
  return state;
}

inline std::vector<double> touched(const ContactTerm& term, std::span<const double> u) {
  std::vector<double> values;
  for (const Index dof : term.touched()) values.push_back(u[dof]);
  return values;
}

/// c and K_c over all dofs at u.
struct Local {
  Eigen::VectorXd force;
  Eigen::MatrixXd tangent;
};
inline Local local_at(const model::Model& model, const ContactTerm& term, const fields::State& state,
                      std::span<const double> u) {
  const auto size = static_cast<Index>(term.touched().size());
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
  Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(size, size);
  term.add_local(state, touched(term, u), force, tangent);
  Local all{Eigen::VectorXd::Zero(model.dofs.size()),
            Eigen::MatrixXd::Zero(model.dofs.size(), model.dofs.size())};
  for (Index i = 0; i < size; ++i) {
    all.force[term.touched()[i]] = force[i];
    for (Index j = 0; j < size; ++j) all.tangent(term.touched()[i], term.touched()[j]) = tangent(i, j);
  }
  return all;
}

/// Iterates on the status with linear solves; the bottom is held in y, its first point in x, and the dof
/// `hold`. Leaves the result committed; returns the number of statuses, or -1 if it does not settle in 20.
inline int solve(const Blocks& blocks, const ContactTerm& term, const Eigen::VectorXd& load, Index hold,
                 fields::State& state) {
  Eigen::VectorXd free = Eigen::VectorXd::Ones(load.size());
  for (const Index point : blocks.bottom) free[2 * point + 1] = 0;
  free[2 * blocks.bottom[0]] = free[hold] = 0;
  const std::span<double> u = state.trial(0);
  const std::vector<double> zero(u.size());
  term.update_status(state, touched(term, u));
  for (int number = 1; number <= 20; ++number) {
    Eigen::MatrixXd k = blocks.stiffness + local_at(blocks.model, term, state, zero).tangent;
    k = free.asDiagonal() * k * free.asDiagonal();
    k.diagonal() += Eigen::VectorXd::Ones(free.size()) - free;
    const Eigen::VectorXd solution = k.llt().solve(free.cwiseProduct(load));
    std::copy(solution.begin(), solution.end(), u.begin());
    if (term.update_status(state, touched(term, u)) > 0) continue;
    state.commit();
    return number;
  }
  return -1;
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
