#include <algorithm>

#include "geometry/polygon.hpp"
#include "model/edge_load.hpp"
#include "solve/stage_results.hpp"

namespace ashlar::solve {

using geometry::Point;
using mesh::Index;

namespace {

Point outward(const mesh::Mesh& mesh, Index edge) {
  const auto [a, b] = mesh.edge_points[edge];
  const Point d = mesh.points[b] - mesh.points[a];
  return (-1 / geometry::norm(d)) * geometry::left_of(d);
}

/// The lip's edges that a load presses, with the edge of the profile's place among them.
void add_pressure(const model::Model& model, const mesh::JointLips& joint, const std::vector<Index>& edges,
                  const model::EdgeTraction& traction, model::JointResult& result) {
  const mesh::Mesh& mesh = model.mesh;
  // Water presses on both lips alike: the first one speaks for both.
  std::vector<mesh::LipEdge> wet;
  for (const mesh::LipEdge& edge : joint.lips[0])
    if (std::ranges::binary_search(edges, edge.edge)) wet.push_back(edge);
  for (const mesh::LipEdge& edge : wet) {
    const Point n = outward(mesh, edge.edge);
    const model::Resultant force = model::traction_resultant(model, edge.edge, traction, {0, 1}, {});
    result.water_force -= force.x * n.x + force.y * n.y;
  }
  for (model::JointResult::Row& row : result.rows) {
    const auto here = std::ranges::find_if(
        wet, [&](const mesh::LipEdge& edge) { return edge.s_from <= row.s && row.s <= edge.s_to; });
    if (here == wet.end()) continue;
    const Point n = outward(mesh, here->edge);
    row.water -= geometry::dot(traction.at(row.at, n), n);
  }
}

}  // namespace

void add_lip_pressures(const model::Model& model, const model::Terms& terms, model::StageResult& result) {
  for (model::JointResult& found : result.joints) {
    const auto joint = std::ranges::find(model.mesh.joints, found.name, &mesh::JointLips::name);
    if (joint == model.mesh.joints.end()) continue;
    for (const auto& load : terms.loads)
      if (load->origin())
        for (const auto& [edges, traction] : load->origin()->tractions)
          add_pressure(model, *joint, edges, traction, found);
  }
}

}  // namespace ashlar::solve
