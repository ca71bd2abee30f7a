#include <algorithm>
#include <limits>

#include "geometry/polygon.hpp"
#include "model/free_motions.hpp"
#include "model/place.hpp"
#include "solve/build.hpp"

namespace ashlar::solve {

using mesh::Index;

namespace {

/// One body of the mesh. Joints separate bodies.
struct Body {
  model::FreeMotions motions;
  Index first_cell;
  std::string edge;  ///< its lowest named edge
  bool jointed = false;
};

std::vector<Body> find_bodies(const model::Model& model, const model::Constraints& constraints) {
  const mesh::Mesh& mesh = model.mesh;
  Index count = 0;
  const std::vector<Index> body_of = mesh::bodies(mesh, count);
  std::vector<Index> first(count, -1);
  for (Index cell = mesh.cell_count(); cell-- > 0;) first[body_of[cell]] = cell;
  std::vector<Body> bodies;
  for (const Index cell : first)
    bodies.push_back({{mesh.points[mesh.cell_points[cell][0]], model.length, model.plane}, cell, {}, false});
  for (const auto& joint : mesh.joints)
    for (const auto& lip : joint.lips)
      for (const auto& edge : lip) bodies[body_of[edge.cell]].jointed = true;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const Index p : mesh.cell_points[cell])
      for (int c = 0; c < 2; ++c)
        if (constraints.held[model.dofs.of_point(p) + c])
          bodies[body_of[cell]].motions.hold(mesh.points[p], c);
  std::vector<double> lowest(bodies.size(), std::numeric_limits<double>::infinity());
  for (const auto& [name, edges] : mesh.edge_groups)
    for (const Index edge : edges) {
      const Index body = body_of[mesh.edge_cells[edge][0]];
      const auto [from, to] = mesh.edge_points[edge];
      const double height = mesh.points[from].y + mesh.points[to].y;
      if (height < lowest[body]) bodies[body].edge = name;
      lowest[body] = std::min(lowest[body], height);
    }
  return bodies;
}

}  // namespace

void check_support(const model::Model& model, const model::Scene& scene, const model::StageData& stage,
                   const model::Constraints& constraints, core::Mistakes& mistakes) {
  for (const Body& body : find_bodies(model, constraints)) {
    const std::string motions = body.jointed ? "" : body.motions.words();
    if (motions.empty()) continue;
    const std::string& region = scene.regions[model.mesh.cell_region[body.first_cell]].name;
    model::add_unheld({"'" + region + "'", stage.name, motions, body.edge}, stage.place, mistakes);
  }
}

std::string loose_bodies(const model::Model& model, const model::Scene& scene,
                         const model::Constraints& constraints) {
  constexpr int most = 3;
  std::string words;
  int count = 0;
  for (const Body& body : find_bodies(model, constraints)) {
    const std::string motions = body.motions.words();
    if (motions.empty() || ++count > most) continue;
    words += (words.empty() ? ": without them '" : "; '") +
             scene.regions[model.mesh.cell_region[body.first_cell]].name + "' can " + motions;
  }
  if (count > most) words += "; and so " + std::to_string(count - most) + " more";
  return words;
}

std::string place_of_dof(const model::Model& model, Index dof) {
  const mesh::Mesh& mesh = model.mesh;
  const fields::Field& field = model.dofs.field();
  geometry::Point at;
  if (dof < model.dofs.of_edge(0)) {
    at = mesh.points[dof / field.width];
  } else if (dof < model.dofs.of_cell(0)) {
    const Index edge = (dof - model.dofs.of_edge(0)) / (field.width * field.per_edge);
    const auto [from, to] = mesh.edge_points[edge];
    at = 0.5 * (mesh.points[from] + mesh.points[to]);
  } else {
    std::vector<geometry::Point> corners;
    mesh.corners((dof - model.dofs.of_cell(0)) / (field.width * field.per_cell), corners);
    at = geometry::centroid(corners);
  }
  return model::place_text(at);
}

}  // namespace ashlar::solve
