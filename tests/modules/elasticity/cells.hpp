#pragma once
// Polygons that elements must bear, and small helpers for one cell.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/vem.hpp"
#include "geometry/polygon.hpp"

namespace ashlar::elasticity::testing {

struct NamedCell {
  std::string name;
  std::vector<Point> corners;
};

inline std::vector<Point> regular(int corners, double radius) {
  std::vector<Point> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

inline std::vector<NamedCell> cells() {
  return {
      {"triangle", {{0, 0}, {2, 0.3}, {0.4, 1.7}}},
      {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      {"distorted", {{0, 0}, {2.3, -0.4}, {1.9, 1.2}, {0.2, 0.9}}},
      {"flat", {{0, 0}, {30, 0}, {30, 1}, {0, 1}}},
      {"hexagon", regular(6, 1.3)},
      {"non-convex", {{0, 0}, {3, 0}, {3, 2}, {1.6, 0.5}, {0, 2}}},
      {"star", {{2, 0}, {0.5, 0.4}, {0, 2}, {-0.5, 0.4}, {-2, 0}, {-0.5, -0.4}, {0, -2}, {0.5, -0.4}}},
      {"hanging nodes", {{0, 0}, {0.4, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0, 1}}},
      {"short edge", {{0, 0}, {1, 0}, {1, 0.5}, {1, 0.5 + 1e-8}, {1, 1}, {0, 1}}},
      {"two short edges", {{0, 0}, {1, 0}, {1, 1}, {1 - 1e-8, 1 + 1e-8}, {1 - 3e-8, 1 + 1e-8}, {0, 1}}},
      {"forty corners", regular(40, 0.7)},
  };
}

inline std::vector<std::pair<std::string, std::shared_ptr<const Stabilisation>>> stabilisations() {
  return {{"bending", std::make_shared<BendingStabilisation>()},
          {"shear", std::make_shared<ShearStabilisation>(0.5)},
          {"diagonal", std::make_shared<DiagonalStabilisation>()}};
}

inline Eigen::MatrixXd stiffness(const model::Element& element, std::span<const Point> corners,
                                 const model::Material& material, double thickness = 1) {
  const auto n = static_cast<Eigen::Index>(2 * corners.size());
  std::vector<double> packed(static_cast<std::size_t>(n * (n + 1) / 2));
  element.stiffness({corners, thickness}, material, packed);
  Eigen::MatrixXd k(n, n);
  std::size_t at = 0;
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = 0; c <= r; ++c) k(r, c) = k(c, r) = packed[at++];
  return k;
}

/// Displacements of the corners under x ↦ a + G x.
inline Eigen::VectorXd linear(std::span<const Point> corners, Point a, const Eigen::Matrix2d& g) {
  Eigen::VectorXd u(static_cast<Eigen::Index>(2 * corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d v = Eigen::Vector2d(a.x, a.y) + g * Eigen::Vector2d(corners[i].x, corners[i].y);
    u.segment<2>(static_cast<Eigen::Index>(2 * i)) = v;
  }
  return u;
}

inline std::span<const double> span(const Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}
inline std::span<double> span(Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

}  // namespace ashlar::elasticity::testing
