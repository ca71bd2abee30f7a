#include "solve/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/place.hpp"

namespace ashlar::solve {

namespace {

using geometry::Point;
using mesh::Index;

constexpr std::size_t most_named = 4;
// Bodies that move less than this share of the fastest are strained by the others, or round-off.
constexpr double still = 1e-3;
// A turn that moves the body's points by less than this share of its slide is not worth a word.
constexpr double hardly_turns = 0.05;

/// Points of one body with their motion.
struct Body {
  Index cell = -1;
  std::vector<Point> at, motion;
  double fastest = 0;
};

std::vector<Body> bodies_of(const model::Model& model, const Mechanism& mechanism) {
  std::vector<double> by_dof(static_cast<std::size_t>(model.dofs.size()));
  std::vector<char> known(by_dof.size());
  for (std::size_t i = 0; i < mechanism.dofs.size(); ++i) {
    by_dof[mechanism.dofs[i]] = mechanism.motion[static_cast<Index>(i)];
    known[mechanism.dofs[i]] = 1;
  }
  Index count = 0;
  const std::vector<Index> body_of = mesh::bodies(model.mesh, count);
  std::vector<Body> bodies(static_cast<std::size_t>(count));
  std::vector<char> seen(model.mesh.points.size());
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (const Index p : model.mesh.cell_points[cell]) {
      const Index dof = model.dofs.of_point(p);
      if (!known[dof] || seen[p]) continue;
      seen[p] = 1;
      Body& body = bodies[body_of[cell]];
      body.cell = cell;
      body.at.push_back(model.mesh.points[p]);
      body.motion.push_back({by_dof[dof], by_dof[dof + 1]});
      body.fastest = std::max(body.fastest, geometry::norm(body.motion.back()));
    }
  return bodies;
}

Point mean(const std::vector<Point>& list) {
  Point sum{};
  for (const Point& each : list) sum = sum + each;
  return (1.0 / static_cast<double>(list.size())) * sum;
}

/// To multiples of a unit, no −0.
double rounded(double value, double unit) {
  return std::round(value / unit) * unit + 0.0;
}

/// To some thousandths of the model's size.
Point rounded(Point at, double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 3);
  return {rounded(at.x, unit), rounded(at.y, unit)};
}

/// "slides along (1.00, 0.00)", "turns about (3 m, 1 m)". The motion is slide + turn × (x − middle) in the
/// least squares.
std::string words_of(const Body& body, double length) {
  const Point middle = mean(body.at), slide = mean(body.motion);
  double across = 0, square = 0;
  for (std::size_t i = 0; i < body.at.size(); ++i) {
    const Point arm = body.at[i] - middle;
    across += geometry::cross(arm, body.motion[i] - slide);
    square += geometry::dot(arm, arm);
  }
  const double turn = square > 0 ? across / square : 0;
  const double radius = std::sqrt(square / static_cast<double>(body.at.size()));
  if (std::abs(turn) * radius > hardly_turns * geometry::norm(slide)) {
    const Point centre{middle.x - slide.y / turn, middle.y + slide.x / turn};
    return "turns about " + model::place_text(rounded(centre, length));
  }
  const double size = geometry::norm(slide);
  char text[60];
  std::snprintf(text, sizeof text, "slides along (%.2f, %.2f)", rounded(slide.x / size, 0.01),
                rounded(slide.y / size, 0.01));
  return text;
}

}  // namespace

std::string moving_bodies(const model::Model& model, const model::Scene& scene, const Mechanism& mechanism) {
  if (mechanism.motion.size() == 0) return {};
  std::vector<Body> bodies = bodies_of(model, mechanism);
  std::ranges::stable_sort(bodies, std::ranges::greater{}, &Body::fastest);
  std::string words;
  std::size_t count = 0;
  for (const Body& body : bodies) {
    if (body.fastest <= still * bodies.front().fastest || ++count > most_named) continue;
    words += (words.empty() ? ": '" : "; '") + scene.regions[model.mesh.cell_region[body.cell]].name + "' " +
             words_of(body, model.length);
  }
  if (count > most_named) words += "; and so " + std::to_string(count - most_named) + " more";
  return words;
}

}  // namespace ashlar::solve
