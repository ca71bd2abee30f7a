#pragma once
// Small meshes, elements and materials made by hand, so that modules are tested without each other.

#include <map>

#include "geometry/polygon.hpp"
#include "model/term.hpp"

namespace ashlar::test {

using mesh::Index;
using mesh::Point;

/// A mesh from points and cells (counter-clockwise); one region "body"; edges numbered as they come.
inline mesh::Mesh hand_mesh(std::vector<Point> points, const std::vector<std::vector<Index>>& cells) {
  mesh::Mesh mesh;
  mesh.points = std::move(points);
  mesh.regions = {"body"};
  std::map<std::pair<Index, Index>, Index> known;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::vector<Index> edges;
    for (std::size_t i = 0; i < cells[cell].size(); ++i) {
      const Index a = cells[cell][i], b = cells[cell][(i + 1) % cells[cell].size()];
      const auto [found, fresh] = known.try_emplace({std::min(a, b), std::max(a, b)}, mesh.edge_count());
      if (fresh) {
        mesh.edge_points.push_back({a, b});
        mesh.edge_cells.push_back({static_cast<Index>(cell), -1});
      } else {
        mesh.edge_cells[found->second][1] = static_cast<Index>(cell);
      }
      edges.push_back(found->second);
    }
    mesh.cell_points.append(cells[cell]);
    mesh.cell_edges.append(edges);
    mesh.cell_region.push_back(0);
  }
  return mesh;
}

/// The edge that joins two points, either way; -1 if there is none.
inline Index edge_between(const mesh::Mesh& mesh, Index a, Index b) {
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto [from, to] = mesh.edge_points[edge];
    if ((from == a && to == b) || (from == b && to == a)) return edge;
  }
  return -1;
}

/// A linear material given by E' and a unit weight or density.
class PlainMaterial : public model::Material {
 public:
  double modulus = 1, weight = -1, density = -1;
  bool linear() const override { return true; }
  model::Response respond(const model::Voigt&, std::span<const double>, std::span<double>) const override {
    return {};
  }
  double unit_weight(double g) const override { return density >= 0 ? density * g : weight; }
  double shear_modulus() const override { return modulus / 2; }
  double plane_modulus() const override { return modulus; }
};

/// Shape functions on edges of order 1 or 2; weight shared evenly by the corners; no stiffness.
class PlainElement : public model::Element {
 public:
  explicit PlainElement(int order) : order_(order) {}
  model::NodeCounts nodes() const override { return {1, order_ - 1, 0}; }
  void stiffness(const model::Cell&, const model::Material&, std::span<double>) const override {}
  void add_internal_force(const model::Cell&, const model::Material&, std::span<const double>,
                          std::span<double>) const override {}
  void add_body_force(const model::Cell& cell, Point b, std::span<double> force) const override {
    const double share = geometry::signed_area(cell.corners) * cell.thickness / cell.corners.size();
    for (std::size_t i = 0; i < cell.corners.size(); ++i) {
      force[2 * i] += share * b.x;
      force[2 * i + 1] += share * b.y;
    }
  }
  int point_count(std::size_t) const override { return 1; }
  void integrate(const model::Cell& cell, model::IntegrationPoints& points) const override {
    points.resize(1, dofs(cell.corners.size()));
  }
  int order() const override { return order_; }
  void edge_shape(double t, std::span<double> values) const override {
    if (order_ == 1) {
      values[0] = 1 - t;
      values[1] = t;
    } else {
      values[0] = (1 - t) * (1 - 2 * t);
      values[1] = t * (2 * t - 1);
      values[2] = 4 * t * (1 - t);
    }
  }

 private:
  int order_;
};

inline model::Model plain_model(mesh::Mesh mesh, int order = 1, double thickness = 1) {
  model::Model model;
  model.mesh = std::move(mesh);
  model.thickness = thickness;
  model.element = std::make_shared<PlainElement>(order);
  model.dofs = fields::DofMap(model.mesh, {"displacement", "m", 2, 1, order - 1, 0});
  model.materials.assign(model.mesh.regions.size(), std::make_shared<PlainMaterial>());
  return model;
}

/// Forces and moment about the origin of a force vector; edge nodes lie at mid-edge.
inline model::Resultant resultant(const model::Model& model, std::span<const double> force) {
  model::Resultant sum;
  const auto add = [&](Index dof, Point at) {
    sum.x += force[dof];
    sum.y += force[dof + 1];
    sum.moment += at.x * force[dof + 1] - at.y * force[dof];
  };
  for (Index point = 0; point < model.mesh.point_count(); ++point)
    add(model.dofs.of_point(point), model.mesh.points[point]);
  for (Index edge = 0; edge < model.mesh.edge_count() && model.dofs.field().per_edge > 0; ++edge) {
    const auto [from, to] = model.mesh.edge_points[edge];
    add(model.dofs.of_edge(edge), 0.5 * (model.mesh.points[from] + model.mesh.points[to]));
  }
  return sum;
}

}  // namespace ashlar::test
