#include "model/free_motions.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

#include "core/units.hpp"

namespace ashlar::model {

namespace {

// Squared distances over the squared length: points a millionth of the length apart count as one.
constexpr double tolerance = 1e-12;

std::string enumeration(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace

void FreeMotions::hold(geometry::Point at, int component) {
  const geometry::Point r = (1 / length_) * (at - origin_);
  const Eigen::Vector3d row = component == 0 ? Eigen::Vector3d(1, 0, -r.y) : Eigen::Vector3d(0, 1, r.x);
  held_ += row * row.transpose();
}

std::string FreeMotions::words() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(held_);
  Eigen::Matrix3d free = Eigen::Matrix3d::Zero();  // projector on the free motions
  int count = 0;
  for (int m = 0; m < 3; ++m) {
    if (modes.eigenvalues()[m] > tolerance * std::max(1.0, modes.eigenvalues()[2])) continue;
    free += modes.eigenvectors().col(m) * modes.eigenvectors().col(m).transpose();
    ++count;
  }
  // Slides in x and y first: what is left is one rotation or one oblique slide.
  std::vector<std::string> motions;
  const auto take = [&](const Eigen::Vector3d& motion) {
    motions.push_back(name(motion, count == 1));
    free -= motion * motion.transpose();
  };
  for (int c = 0; c < 2; ++c)
    if (free(c, c) > 1 - 1e-9) take(Eigen::Vector3d::Unit(c));
  while (free.trace() > 0.5) {
    int column = 0;
    free.diagonal().maxCoeff(&column);
    take(free.col(column).normalized());
  }
  return enumeration(motions);
}

// u = (a − θ (y − y₀), b + θ (x − x₀)) vanishes at the origin + (−b, a)/θ.
std::string FreeMotions::name(const Eigen::Vector3d& motion, bool only) const {
  char text[80];
  if (std::abs(motion[2]) < 1e-6) {
    if (std::abs(motion[1]) < 1e-6) return "slide in x";
    if (std::abs(motion[0]) < 1e-6) return "slide in y";
    const double sign = motion[0] < 0 ? -1 : 1;
    std::snprintf(text, sizeof text, "slide along (%.3g, %.3g)", sign * motion[0], sign * motion[1]);
    return text;
  }
  if (!only) return "rotate";
  const auto coordinate = [&](double x) {
    return core::format_quantity(std::abs(x) < 1e-9 * length_ ? 0 : x, {});
  };
  const double turn = motion[2] / length_;
  return "rotate about (" + coordinate(origin_.x - motion[1] / turn) + ", " +
         coordinate(origin_.y + motion[0] / turn) + ")";
}

void add_unheld(const UnheldBody& body, const core::Place& place, core::Mistakes& mistakes) {
  mistakes.add(
      place, "nothing holds " + body.regions + " in stage '" + body.stage + "': it can " + body.motions,
      body.edge.empty() ? "name one of its edges and hold it: supports = { [\"region.edge\"] = \"xy\" }"
                        : "add to supports, for example [\"" + body.edge + "\"] = \"xy\"");
}

}  // namespace ashlar::model
