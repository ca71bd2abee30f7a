#include "elasticity/vem.hpp"

#include <gtest/gtest.h>

#include "modules/elasticity/cells.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;
using testing::NamedCell;

/// Every cell with every stabilisation, for steel-like, near-incompressible and auxetic laws.
template <class Check>
void on_all(Check&& check) {
  for (const auto& [choice, stabilisation] : testing::stabilisations())
    for (const double nu : {0.3, 0.4999, -0.5})
      for (const Plane plane : {Plane::strain, Plane::stress})
        for (const NamedCell& cell : testing::cells()) {
          SCOPED_TRACE(choice + ", nu " + std::to_string(nu) + ", " + cell.name);
          check(VemElement(stabilisation), Elastic(2.5e9, nu, plane), cell.corners);
        }
}

TEST(vem, has_three_free_motions_and_is_otherwise_positive_definite) {
  on_all([](const VemElement& element, const Elastic& material, const std::vector<Point>& corners) {
    const Eigen::MatrixXd k = testing::stiffness(element, corners, material);
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
    const double greatest = values[values.size() - 1];
    EXPECT_LT(values.head(3).cwiseAbs().maxCoeff(), 1e-13 * greatest);
    // Bending of the flat cell against its change of volume at nu = 0.4999: about 1e-7.
    EXPECT_GT(values[3], 1e-8 * greatest);
    Eigen::Matrix2d turn;
    turn << 0, -1, 1, 0;
    EXPECT_LT((k * testing::linear(corners, {1, -2}, turn)).cwiseAbs().maxCoeff(), 1e-12 * greatest);
  });
}

TEST(vem, linear_displacements_give_their_exact_energy_and_strain) {
  Eigen::Matrix2d g;
  g << 3e-4, -1e-4, 7e-4, 2e-4;
  on_all([&](const VemElement& element, const Elastic& material, const std::vector<Point>& corners) {
    const Eigen::VectorXd u = testing::linear(corners, {0.1, 0.2}, g);
    const model::Voigt exact = {g(0, 0), g(1, 1), g(0, 1) + g(1, 0), 0};
    model::IntegrationPoints points;
    element.integrate({corners, 2}, points);
    const model::Voigt strain = points.strain(0, testing::span(u));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(strain[i], exact[i], 1e-12 * 7e-4);
    const model::Voigt stress = material.respond(exact, {}, {}).stress;
    const double energy = 2 * geometry::signed_area(corners) *
                          (stress[0] * exact[0] + stress[1] * exact[1] + stress[2] * exact[2]);
    const Eigen::MatrixXd k = testing::stiffness(element, corners, material, 2);
    EXPECT_NEAR(u.dot(k * u), energy, 1e-11 * std::abs(energy) + 1e-14 * k.norm() * u.squaredNorm());
  });
}

TEST(vem, internal_force_is_stiffness_times_displacement) {
  on_all([](const VemElement& element, const Elastic& material, const std::vector<Point>& corners) {
    const Eigen::MatrixXd k = testing::stiffness(element, corners, material, 0.7);
    Eigen::VectorXd u(k.rows()), force = Eigen::VectorXd::Constant(k.rows(), 5.0);
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = 1e-3 * std::sin(1.0 + 2.1 * static_cast<double>(i));
    element.add_internal_force({corners, 0.7}, material, testing::span(u), testing::span(force));
    const Eigen::VectorXd expected = k * u + Eigen::VectorXd::Constant(k.rows(), 5.0);
    EXPECT_LT((force - expected).norm(), 1e-13 * k.norm() * u.norm());
  });
}

TEST(vem, body_force_has_exact_resultant_and_moment) {
  const VemElement element(std::make_shared<BendingStabilisation>());
  const Point b = {3, -24};
  for (const NamedCell& cell : testing::cells()) {
    SCOPED_TRACE(cell.name);
    const double area = geometry::signed_area(cell.corners);
    const Point c = geometry::centroid(cell.corners);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * cell.corners.size()));
    element.add_body_force({cell.corners, 2}, b, testing::span(force));
    double x = 0, y = 0, moment = 0;
    for (std::size_t i = 0; i < cell.corners.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(2 * i);
      x += force[at];
      y += force[at + 1];
      moment += cell.corners[i].x * force[at + 1] - cell.corners[i].y * force[at];
    }
    EXPECT_NEAR(x, 2 * area * b.x, 1e-13 * 50 * area);
    EXPECT_NEAR(y, 2 * area * b.y, 1e-13 * 50 * area);
    EXPECT_NEAR(moment, 2 * area * cross(c, b), 1e-13 * 50 * area * (1 + norm(c)));
  }
}

// The same cell turned by an odd angle and moved far away must have the turned stiffness.
TEST(vem, turns_with_the_cell_and_does_not_care_where_it_is) {
  const double angle = 0.7;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  on_all([&](const VemElement& element, const Elastic& material, const std::vector<Point>& corners) {
    if (geometry::diameter(corners) > 20) return;
    std::vector<Point> moved;
    for (const Point p : corners) {
      const Eigen::Vector2d q = turn * Eigen::Vector2d(p.x, p.y);
      moved.push_back({q[0] + 64, q[1] - 128});
    }
    const Eigen::MatrixXd k = testing::stiffness(element, corners, material);
    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(k.rows(), k.cols());
    for (Eigen::Index i = 0; i < k.rows(); i += 2) r.block<2, 2>(i, i) = turn;
    // Corners at 128 carry round-off of 1e-14: so does every coordinate difference.
    const Eigen::MatrixXd turned = testing::stiffness(element, moved, material);
    EXPECT_LT((turned - r * k * r.transpose()).norm(), 1e-12 * k.norm());
  });
}

// Bending under uniform moment: on a rectangle a × b the mode u_x = xy has the energy E' b³a/24.
TEST(vem, rectangles_bend_exactly_with_the_bending_stabilisation) {
  const VemElement element(std::make_shared<BendingStabilisation>());
  for (const Plane plane : {Plane::strain, Plane::stress})
    for (const double a : {0.2, 1.0, 5.0, 40.0}) {
      const double b = 1;
      const Elastic material(100, 0.3, plane);
      const auto energy = [&](const std::vector<Point>& corners) {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * corners.size()));
        for (std::size_t i = 0; i < corners.size(); ++i)
          u[static_cast<Eigen::Index>(2 * i)] = corners[i].x * corners[i].y;
        return 0.5 * u.dot(testing::stiffness(element, corners, material) * u);
      };
      const double exact = material.plane_modulus() * b * b * b * a / 24;
      EXPECT_NEAR(energy({{-a / 2, -b / 2}, {a / 2, -b / 2}, {a / 2, b / 2}, {-a / 2, b / 2}}) / exact, 1,
                  1e-12);
    }
}

TEST(vem, edges_are_linear) {
  const VemElement element(std::make_shared<BendingStabilisation>());
  double values[2];
  element.edge_shape(0.25, values);
  EXPECT_EQ(values[0], 0.75);
  EXPECT_EQ(values[1], 0.25);
  EXPECT_EQ(element.order(), 1);
  EXPECT_EQ(element.dofs(5), 10);
}

}  // namespace
}  // namespace ashlar::elasticity
