#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/Dense>

#include "solve/build.hpp"

namespace ashlar::solve {

using geometry::Point;
using mesh::Index;

namespace {

/// One body's rigid motions a + θ × (x − c), scaled so that all three components are lengths.
struct Body {
  Eigen::Matrix3d held =
      Eigen::Matrix3d::Zero();  ///< Σ row rowᵀ over held dofs: null vectors are free motions
  Point center;
  Index first_cell = -1;
  bool jointed = false;
};

/// "slide along x", "slide along (0.707, 0.707)" or "turn about (3.2, 1)".
std::string motion_name(Eigen::Vector3d motion, Point center, double length) {
  motion.normalize();
  char text[80];
  if (std::abs(motion[2]) < 1e-6) {
    if (std::abs(motion[1]) < 1e-6) return "slide along x";
    if (std::abs(motion[0]) < 1e-6) return "slide along y";
    const double sign = motion[0] < 0 ? -1 : 1;
    std::snprintf(text, sizeof text, "slide along (%.3g, %.3g)", sign * motion[0], sign * motion[1]);
    return text;
  }
  // u = (a − θ (y−c_y), b + θ (x−c_x)) vanishes at c + (−b, a)/θ.
  const double turn = motion[2] / length;
  std::snprintf(text, sizeof text, "turn about (%.3g, %.3g)", center.x - motion[1] / turn,
                center.y + motion[0] / turn);
  return text;
}

/// The free motions in words: slides along x and y first, so that the rest is one turn or one oblique slide.
std::string free_motions(const Body& body, double length) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(body.held);
  Eigen::Matrix3d free = Eigen::Matrix3d::Zero();  // projector on the free motions
  for (int m = 0; m < 3; ++m)
    if (modes.eigenvalues()[m] <= 1e-12 * std::max(1.0, modes.eigenvalues()[2]))
      free += modes.eigenvectors().col(m) * modes.eigenvectors().col(m).transpose();
  std::string words;
  const auto take = [&](const Eigen::Vector3d& motion) {
    words += (words.empty() ? "" : ", ") + motion_name(motion, body.center, length);
    free -= motion * motion.transpose();
  };
  for (int c = 0; c < 2; ++c)
    if (free(c, c) > 1 - 1e-9) take(Eigen::Vector3d::Unit(c));
  while (free.trace() > 0.5) {
    Index column = 0;
    free.diagonal().maxCoeff(&column);
    take(free.col(column).normalized());
  }
  return words;
}

std::vector<Body> find_bodies(const model::Model& model, const model::Constraints& constraints) {
  const mesh::Mesh& mesh = model.mesh;
  Index count = 0;
  const std::vector<Index> body_of = mesh::bodies(mesh, count);
  std::vector<Body> bodies(count);
  for (const auto& joint : mesh.joints)
    for (const auto& lip : joint.lips)
      for (const auto& edge : lip) bodies[body_of[edge.cell]].jointed = true;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Body& body = bodies[body_of[cell]];
    if (body.first_cell < 0) {
      body.first_cell = cell;
      body.center = mesh.points[mesh.cell_points[cell][0]];
    }
    for (const Index p : mesh.cell_points[cell])
      for (int c = 0; c < 2; ++c) {
        if (!constraints.held[model.dofs.of_point(p) + c]) continue;
        const Point r = (1 / model.length) * (mesh.points[p] - body.center);
        const Eigen::Vector3d row = c == 0 ? Eigen::Vector3d(1, 0, -r.y) : Eigen::Vector3d(0, 1, r.x);
        body.held += row * row.transpose();
      }
  }
  return bodies;
}

}  // namespace

void check_support(const model::Model& model, const model::Scene& scene, const model::StageData& stage,
                   const model::Constraints& constraints, core::Mistakes& mistakes) {
  for (const Body& body : find_bodies(model, constraints)) {
    if (body.jointed) continue;
    const std::string motions = free_motions(body, model.length);
    if (motions.empty()) continue;
    const std::string& region = scene.regions[model.mesh.cell_region[body.first_cell]].name;
    mistakes.add(
        stage.place,
        "stage '" + stage.name + "': nothing holds the body of region '" + region + "'; it can " + motions,
        "hold one of its edges: supports = { [\"" + region + ".…\"] = \"xy\" }");
  }
}

std::string loose_bodies(const model::Model& model, const model::Scene& scene,
                         const model::Constraints& constraints) {
  std::string words;
  for (const Body& body : find_bodies(model, constraints)) {
    const std::string motions = free_motions(body, model.length);
    if (motions.empty()) continue;
    words += (words.empty() ? ": without them '" : "; '") +
             scene.regions[model.mesh.cell_region[body.first_cell]].name + "' can " + motions;
  }
  return words;
}

}  // namespace ashlar::solve
