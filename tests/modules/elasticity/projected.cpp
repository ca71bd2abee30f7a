#include "elasticity/vem_projected.hpp"

#include <gtest/gtest.h>

#include "elasticity/polynomials.hpp"
#include "elasticity/vem_high.hpp"
#include "modules/elasticity/cells.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;
using testing::NamedCell;

Eigen::MatrixXd stiffness_of(const model::Element& element, const model::Cell& cell,
                             const model::Material& law) {
  const auto n = static_cast<Eigen::Index>(element.dofs(cell.corners.size()));
  std::vector<double> packed(static_cast<std::size_t>(n * (n + 1) / 2));
  element.stiffness(cell, law, packed);
  Eigen::MatrixXd k(n, n);
  std::size_t at = 0;
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = 0; c <= r; ++c) k(r, c) = k(c, r) = packed[at++];
  return k;
}

/// Least eigenvalue beyond `free` ones of the projected stiffness, measured by the stabilised one: how much
/// of every deformation is seen.
double least_seen(const model::Element& element, const model::Element& measure, const model::Cell& cell,
                  const model::Material& law, int free) {
  const Eigen::MatrixXd k = stiffness_of(element, cell, law), m = stiffness_of(measure, cell, law);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(m);
  const Eigen::Index own = m.rows() - free;
  const Eigen::MatrixXd q = modes.eigenvectors().rightCols(own) *
                            modes.eigenvalues().tail(own).cwiseSqrt().cwiseInverse().asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(q.transpose() * k * q).eigenvalues()[0];
}

TEST(vem_projected, without_stabilisation_sees_every_deformation) {
  const auto bending = std::make_shared<BendingStabilisation>();
  for (int order = 1; order <= 3; ++order)
    for (const NamedCell& cell : testing::cells()) {
      const VemProjected element(order, false, nullptr);
      const model::Cell one{cell.corners};
      if (!element.refuses(one).empty()) {
        std::printf("order %d, %s: refused\n", order, cell.name.c_str());
        EXPECT_TRUE(cell.name == "forty corners" || (order > 1 && cell.name.ends_with("short edges")) ||
                    (order > 2 && cell.name == "short edge"))
            << cell.name;
        continue;
      }
      const Elastic law(2.6, 0.3, Plane::strain);
      const double seen = order == 1 ? least_seen(element, VemElement(bending), one, law, 3)
                                     : least_seen(element, VemHigh(order, bending), one, law, 3);
      std::printf("order %d, %s: %.3g\n", order, cell.name.c_str(), seen);
      EXPECT_GT(seen, 1e-4) << order << cell.name;
    }
}

TEST(vem_projected, free_motions_cost_nothing) {
  for (int order = 1; order <= 3; ++order)
    for (const NamedCell& cell : testing::cells()) {
      const VemProjected element(order, false, nullptr);
      const model::Cell one{cell.corners};
      if (!element.refuses(one).empty()) continue;
      const Eigen::MatrixXd k = stiffness_of(element, one, Elastic(2.6, 0.3, Plane::strain));
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
      EXPECT_LT(std::abs(values[2]), 1e-10 * values[values.size() - 1]) << order << cell.name;
      EXPECT_GT(values[3], 1e-10 * values[values.size() - 1]) << order << cell.name;
    }
}

// A cube of an element turned about its axis: the volume is that of the ring, and only the slide along the
// axis is free.
TEST(vem_projected, around_an_axis_only_the_slide_along_it_is_free) {
  const auto bending = std::make_shared<BendingStabilisation>();
  const auto plane = std::make_shared<VemElement>(bending);
  for (const auto& rest :
       {std::shared_ptr<const model::Element>(plane), std::shared_ptr<const model::Element>()})
    for (const NamedCell& named : testing::cells()) {
      if (!rest && named.name == "forty corners") continue;
      std::vector<Point> ring = named.corners;
      for (Point& corner : ring) corner.x += 5;
      const VemProjected element(1, true, rest);
      const model::Cell cell{ring, 1, true};
      const Eigen::MatrixXd k = stiffness_of(element, cell, Elastic(2.6, 0.3, Plane::strain));
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
      EXPECT_LT(std::abs(values[0]), 1e-11 * values[values.size() - 1]) << named.name;
      // Tilting about its own middle costs a cell nothing where the way around is taken at one point.
      EXPECT_GT(values[2], 1e-8 * values[values.size() - 1]) << named.name;

      std::vector<double> force(2 * ring.size());
      element.add_body_force(cell, {0, -3}, force);
      double sum = 0;
      for (std::size_t i = 0; i < ring.size(); ++i) sum += force[2 * i + 1];
      const double volume = 2 * std::numbers::pi * geometry::centroid(ring).x * geometry::signed_area(ring);
      EXPECT_NEAR(sum, -3 * volume, 1e-10 * volume) << named.name;
    }
}

/// Condition of the mean products of all monomials up to a degree, in given coordinates of the corners.
double condition(const std::vector<Point>& ring, int degree) {
  const std::vector<double> integral = geometry::monomial_integrals(ring, {}, 2 * degree);
  const int size = monomials(degree);
  Eigen::MatrixXd mass(size, size);
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b)
      mass(a, b) = integral[static_cast<std::size_t>(
                       number_of(powers_of(a).p + powers_of(b).p, powers_of(a).q + powers_of(b).q))] /
                   integral[0];
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mass).eigenvalues();
  return values[size - 1] / std::max(values[0], 1e-300);
}

// Why there is one basis for all orders and shapes: scaled monomials lose the square of the aspect with each
// degree, those in ξ nothing.
TEST(polynomials, in_the_cells_own_coordinates_no_aspect_spoils_them) {
  for (const double aspect : {1.0, 10.0, 100.0, 1e4}) {
    std::vector<Point> ring, scaled, local;
    for (const Point p : {Point{-aspect, -1}, {aspect, -1}, {aspect, 1}, {-aspect, 1}})
      ring.push_back({0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y});
    const Frame frame(ring);
    const double size = geometry::diameter(ring);
    for (const Point p : ring) {
      scaled.push_back((2 / size) * (p - frame.centre));
      local.push_back(frame.to_local(p));
    }
    for (const int degree : {1, 2, 3}) {
      const double plain = condition(scaled, degree), own = condition(local, degree);
      std::printf("aspect %.0e, degree %d: scaled %.1e, own %.1e\n", aspect, degree, plain, own);
      EXPECT_LT(own, 200);
      if (aspect >= 100) {
        EXPECT_GT(plain, 1e3 * own);
      }
    }
  }
}

}  // namespace
}  // namespace ashlar::elasticity
