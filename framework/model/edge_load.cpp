#include "model/edge_load.hpp"

#include <algorithm>

#include "core/log.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::model {

namespace {

/// Parameters in [0, 1] between which the traction is one polynomial, ascending.
std::vector<double> pieces(Point start, Point end, const std::vector<double>& kinks) {
  std::vector<double> cuts{0.0, 1.0};
  for (const double y : kinks) {
    const bool crosses = (start.y < y && y < end.y) || (end.y < y && y < start.y);
    if (crosses) cuts.push_back(std::clamp((y - start.y) / (end.y - start.y), 0.0, 1.0));
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// First dof of each node along an edge, in the order of Element::edge_shape.
std::vector<Index> edge_dofs(const Model& model, Index edge) {
  const auto [from, to] = model.mesh.edge_points[edge];
  std::vector<Index> dofs{model.dofs.of_point(from), model.dofs.of_point(to)};
  for (int node = 0; node < model.dofs.field().per_edge; ++node)
    dofs.push_back(model.dofs.of_edge(edge, node));
  return dofs;
}

std::vector<std::string> group_names(const mesh::Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, edges] : mesh.edge_groups) names.push_back(name);
  return names;
}

}  // namespace

namespace {

/// Calls use(t, force) for every Gauss point t of the edge's part; exact for `degree` more than the
/// traction's.
template <class Use>
void integrate(const Model& model, Index edge, const EdgeTraction& traction, std::array<double, 2> part,
               int degree, Use&& use) {
  const auto [from, to] = model.mesh.edge_points[edge];
  const Point start = model.mesh.points[from], end = model.mesh.points[to];
  const double length = geometry::distance(start, end);
  const Point outward = (-1 / length) * geometry::left_of(end - start);
  const geometry::Rule& rule =
      geometry::gauss_legendre(traction.degree + degree + (model.axisymmetric() ? 1 : 0));
  std::vector<double> cuts = pieces(start, end, traction.kinks);
  for (double& cut : cuts) cut = std::clamp(cut, part[0], part[1]);
  for (std::size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
    const double width = cuts[piece + 1] - cuts[piece];
    for (std::size_t g = 0; g < rule.at.size(); ++g) {
      const double t = cuts[piece] + width * rule.at[g];
      const Point at = (1 - t) * start + t * end;
      use(t, rule.weight[g] * width * length * model.depth(at) * traction.at(at, outward));
    }
  }
}

}  // namespace

void add_traction(const Model& model, Index edge, const EdgeTraction& traction, std::span<double> force) {
  const std::vector<Index> dofs = edge_dofs(model, edge);
  std::vector<double> shape(dofs.size());
  integrate(model, edge, traction, {0, 1}, model.element->order(), [&](double t, Point value) {
    model.element->edge_shape(t, shape);
    for (std::size_t node = 0; node < dofs.size(); ++node) {
      force[dofs[node]] += shape[node] * value.x;
      force[dofs[node] + 1] += shape[node] * value.y;
    }
  });
}

Resultant traction_resultant(const Model& model, Index edge, const EdgeTraction& traction,
                             std::array<double, 2> part, Point about) {
  const Point start = model.mesh.points[model.mesh.edge_points[edge][0]];
  const Point end = model.mesh.points[model.mesh.edge_points[edge][1]];
  Resultant sum;
  integrate(model, edge, traction, part, 1, [&](double t, Point value) {
    sum.x += value.x;
    sum.y += value.y;
    sum.moment += geometry::cross((1 - t) * start + t * end - about, value);
  });
  return sum;
}

std::vector<Index> border_edges(const mesh::Mesh& mesh, const std::string& group, const core::Place& place,
                                core::Mistakes& mistakes) {
  const auto found = mesh.edge_groups.find(group);
  if (found == mesh.edge_groups.end()) {
    mistakes.add(place, "there is no edge '" + group + "'", core::did_you_mean(group, group_names(mesh)));
    return {};
  }
  std::vector<Index> border;
  double inner = 0;
  for (const Index edge : found->second) {
    if (mesh.edge_cells[edge][1] < 0)
      border.push_back(edge);
    else
      inner +=
          geometry::distance(mesh.points[mesh.edge_points[edge][0]], mesh.points[mesh.edge_points[edge][1]]);
  }
  if (found->second.empty())
    mistakes.add(place, "edge '" + group + "' has no edges in the mesh");
  else if (border.empty())
    mistakes.add(place,
                 "edge '" + group + "' lies inside the body, between two regions: nothing can act on it",
                 "name an edge on the outside, or a joint's lip");
  else if (inner > 0)
    core::log().info(core::to_string(place) + ": " + core::format_quantity(inner, {1, 0, 0}) + " of edge '" +
                     group + "' lie between two regions and carry no load");
  return border;
}

ForceVector::ForceVector(std::string effect, std::span<const double> force, LoadOrigin origin)
    : Load(std::move(effect)), origin_(std::move(origin)) {
  for (std::size_t dof = 0; dof < force.size(); ++dof) {
    if (force[dof] == 0) continue;
    dof_.push_back(static_cast<Index>(dof));
    value_.push_back(force[dof]);
  }
}

void ForceVector::add_force(std::span<double> force) const {
  for (std::size_t i = 0; i < dof_.size(); ++i) force[dof_[i]] += value_[i];
}

std::size_t ForceVector::bytes() const {
  return dof_.capacity() * sizeof(Index) + value_.capacity() * sizeof(double);
}

}  // namespace ashlar::model
