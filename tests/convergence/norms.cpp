#include "convergence/norms.hpp"

#include <cmath>
#include <stdexcept>

#include "elasticity/projection.hpp"
#include "elasticity/vem_high.hpp"
#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::convergence {

namespace {

struct Place {
  Point at;
  double weight = 0;  ///< [m²]
};

/// A rule of degree 7 in the triangles of a cell: squares collapsed to triangles.
std::vector<Place> rule(std::span<const Point> corners) {
  const geometry::Rule& line = geometry::gauss_legendre(7);
  std::vector<Place> places;
  for (const auto& [i, j, k] : geometry::triangulate(corners)) {
    const Point a = corners[static_cast<std::size_t>(i)], b = corners[static_cast<std::size_t>(j)] - a,
                c = corners[static_cast<std::size_t>(k)] - a;
    for (std::size_t p = 0; p < line.at.size(); ++p)
      for (std::size_t q = 0; q < line.at.size(); ++q) {
        const double s = line.at[p], t = (1 - s) * line.at[q];
        places.push_back({a + s * b + t * c, line.weight[p] * line.weight[q] * (1 - s) * cross(b, c)});
      }
  }
  return places;
}

/// 1, ξ, η, ξ², ξη, η², … up to a degree.
Eigen::VectorXd powers(Point xi, int degree) {
  Eigen::VectorXd values(elasticity::monomials(degree));
  Eigen::Index m = 0;
  for (int d = 0; d <= degree; ++d)
    for (int q = 0; q <= d; ++q) values[m++] = std::pow(xi.x, d - q) * std::pow(xi.y, q);
  return values;
}

/// One cell of a solid: its dofs, and the polynomials that they and the strains stand for.
class CellView {
 public:
  CellView(const patch::Solid& solid, Index index) : frame(corners_of(solid, index, corners)) {
    const model::Element& element = *solid.model.element;
    order = element.order();
    places = rule(corners);
    const auto n = static_cast<int>(corners.size()), k = order;
    Eigen::MatrixXd values(n * k + elasticity::monomials(k - 2), elasticity::monomials(k));
    for (int i = 0; i < n; ++i) {
      const Point a = corners[static_cast<std::size_t>(i)],
                  b = corners[static_cast<std::size_t>((i + 1) % n)];
      values.row(i) = powers(frame.to_local(a), k);
      for (int e = 0; e < k - 1; ++e) {
        const double t = element.edge_node(e);
        values.row(n + i * (k - 1) + e) = powers(frame.to_local((1 - t) * a + t * b), k);
      }
    }
    for (int c = 0; c < elasticity::monomials(k - 2); ++c) {
      values.row(n * k + c).setZero();
      for (const Place& place : places) {
        const Eigen::VectorXd m = powers(frame.to_local(place.at), k);
        values.row(n * k + c) += place.weight / frame.area * m[c] * m.transpose();
      }
    }
    from_dofs = (values.transpose() * values).ldlt().solve(values.transpose());
  }

  std::vector<Point> corners;
  elasticity::Frame frame;
  int order = 1;
  std::vector<Place> places;
  Eigen::MatrixXd from_dofs;  ///< dofs of one component → coefficients of degree ≤ k

 private:
  static std::span<const Point> corners_of(const patch::Solid& solid, Index index,
                                           std::vector<Point>& corners) {
    return solid.model.mesh.corners(index, corners);
  }
};

/// The element's strain, a polynomial of degree k−1, as coefficients × (xx, yy, xy).
Eigen::MatrixXd strain_of(const patch::Solid& solid, const CellView& view, std::span<const double> u) {
  model::IntegrationPoints points;
  solid.model.element->integrate({view.corners, 1}, points);
  const int degree = view.order - 1;
  Eigen::MatrixXd left(points.size(), elasticity::monomials(degree)), right(points.size(), 3);
  for (int q = 0; q < points.size(); ++q) {
    const auto s = static_cast<std::size_t>(q);
    const double w = std::sqrt(std::max(points.weight[s], 0.0));
    left.row(q) = w * powers(view.frame.to_local(points.at[s]), degree);
    const model::Voigt strain = points.strain(q, u);
    for (int c = 0; c < 3; ++c) right(q, c) = w * strain[static_cast<std::size_t>(c)];
  }
  return left.colPivHouseholderQr().solve(right);
}

}  // namespace

Smooth waves(double lambda, double mu) {
  const auto p = [](Point x) { return 2 * x.x + x.y + 0.3; };
  const auto q = [](Point x) { return x.x - 2 * x.y; };
  Smooth field;
  field.displacement = [=](Point x) { return Point{std::sin(p(x)), std::cos(q(x))}; };
  field.strain = [=](Point x) {
    return model::Voigt{2 * std::cos(p(x)), 2 * std::sin(q(x)), std::cos(p(x)) - std::sin(q(x)), 0};
  };
  // −(λ+μ) grad div u − μ Δu with div u = 2 cos p + 2 sin q.
  field.body_force = [=](Point x) {
    const double s = std::sin(p(x)), c = std::cos(q(x));
    return Point{-(lambda + mu) * (-4 * s + 2 * c) + 5 * mu * s,
                 -(lambda + mu) * (-2 * s - 4 * c) + 5 * mu * c};
  };
  return field;
}

Smooth swirl(double mu) {
  Smooth field;
  const auto s = [](Point x) { return 2 * x.x + 0.3; };
  const auto t = [](Point x) { return 3 * x.y - 0.2; };
  field.displacement = [=](Point x) {
    return Point{-3 * std::sin(s(x)) * std::sin(t(x)), -2 * std::cos(s(x)) * std::cos(t(x))};
  };
  field.strain = [=](Point x) {
    const double xx = -6 * std::cos(s(x)) * std::sin(t(x));
    return model::Voigt{xx, -xx, (-9 + 4) * std::sin(s(x)) * std::cos(t(x)), 0};
  };
  // div u = 0 leaves −μ Δu, and Δu = −(4 + 9) u.
  field.body_force = [=, u = field.displacement](Point x) { return 13 * mu * u(x); };
  return field;
}

namespace {

/// Adds a body force that varies. Its projection onto the moments among the dofs (order 1: its mean) meets
/// the exact test function, the rest of it the polynomial that the dofs stand for.
void weigh(patch::Solid& solid, const std::function<Point(Point)>& body_force) {
  const elasticity::Layout layout(solid.model);
  std::vector<double> force;
  for (Index cell = 0; cell < solid.model.mesh.cell_count(); ++cell) {
    const CellView view(solid, cell);
    const int moments = std::max(1, elasticity::monomials(view.order - 2));
    // 1, ξ, η are orthonormal.
    std::vector<Point> share(static_cast<std::size_t>(moments));
    for (const Place& place : view.places) {
      const Eigen::VectorXd m = powers(view.frame.to_local(place.at), view.order);
      for (int c = 0; c < moments; ++c)
        share[static_cast<std::size_t>(c)] = share[static_cast<std::size_t>(c)] +
                                             (m[c] * place.weight / view.frame.area) * body_force(place.at);
    }
    const auto dofs = layout.dofs[cell];
    force.assign(dofs.size(), 0.0);
    solid.model.element->add_body_force({view.corners, 1}, share[0], force);
    for (int c = 1; c < moments; ++c) {
      const std::size_t dof = dofs.size() - 2 * static_cast<std::size_t>(moments - c);
      force[dof] += view.frame.area * share[static_cast<std::size_t>(c)].x;
      force[dof + 1] += view.frame.area * share[static_cast<std::size_t>(c)].y;
    }
    for (const Place& place : view.places) {
      const Eigen::VectorXd m = powers(view.frame.to_local(place.at), view.order);
      Point rest = body_force(place.at);
      for (int c = 0; c < moments; ++c) rest = rest - m[c] * share[static_cast<std::size_t>(c)];
      const Eigen::VectorXd by_dof = place.weight * view.from_dofs.transpose() * m;
      for (Eigen::Index i = 0; i < by_dof.size(); ++i) {
        force[static_cast<std::size_t>(2 * i)] += by_dof[i] * rest.x;
        force[static_cast<std::size_t>(2 * i + 1)] += by_dof[i] * rest.y;
      }
    }
    for (std::size_t i = 0; i < dofs.size(); ++i) solid.load[static_cast<std::size_t>(dofs[i])] += force[i];
  }
}

}  // namespace

std::shared_ptr<const model::Element> vem(int order, std::shared_ptr<const elasticity::Stabilisation> rest) {
  if (order == 1) return std::make_shared<elasticity::VemElement>(std::move(rest));
  return std::make_shared<elasticity::VemHigh>(order, std::move(rest));
}

void hold(patch::Solid& solid, Index edge, const std::function<Point(Point)>& field) {
  const auto node = [&](Index dof, Point at) {
    const Point u = field(at);
    solid.hold_dof(dof, u.x);
    solid.hold_dof(dof + 1, u.y);
  };
  const mesh::Mesh& mesh = solid.model.mesh;
  for (const Index point : mesh.edge_points[static_cast<std::size_t>(edge)])
    node(solid.model.dofs.of_point(point), mesh.points[static_cast<std::size_t>(point)]);
  for (int k = 0; k < solid.model.dofs.field().per_edge; ++k)
    node(solid.model.dofs.of_edge(edge, k), solid.edge_node(edge, k));
}

void pull(patch::Solid& solid, Index edge, const std::function<Point(Point)>& traction) {
  const mesh::Mesh& mesh = solid.model.mesh;
  const auto [from, to] = mesh.edge_points[static_cast<std::size_t>(edge)];
  const Point a = mesh.points[static_cast<std::size_t>(from)], b = mesh.points[static_cast<std::size_t>(to)];
  std::vector<double> shape(static_cast<std::size_t>(solid.model.element->order()) + 1);
  const geometry::Rule& line = geometry::gauss_legendre(9);
  for (std::size_t g = 0; g < line.at.size(); ++g) {
    const Point t = line.weight[g] * distance(a, b) * traction((1 - line.at[g]) * a + line.at[g] * b);
    solid.model.element->edge_shape(line.at[g], shape);
    for (std::size_t m = 0; m < shape.size(); ++m) {
      const Index dof = m == 0   ? solid.model.dofs.of_point(from)
                        : m == 1 ? solid.model.dofs.of_point(to)
                                 : solid.model.dofs.of_edge(edge, static_cast<int>(m) - 2);
      solid.load[static_cast<std::size_t>(dof)] += shape[m] * t.x;
      solid.load[static_cast<std::size_t>(dof) + 1] += shape[m] * t.y;
    }
  }
}

Norms error_norms(const patch::Solid& solid, const Smooth& exact) {
  const elasticity::Layout layout(solid.model);
  const std::span<const double> u = solid.state.committed(0);
  const model::Tangent d = solid.model.material(0).respond({}, {}, {}).tangent;
  Norms sum;
  std::vector<double> local;
  for (Index cell = 0; cell < solid.model.mesh.cell_count(); ++cell) {
    const CellView view(solid, cell);
    const auto dofs = layout.dofs[cell];
    local.clear();
    for (const Index dof : dofs) local.push_back(u[static_cast<std::size_t>(dof)]);
    using Strided = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>;
    const auto scalars = static_cast<Eigen::Index>(local.size() / 2);
    const Eigen::VectorXd ux = view.from_dofs * Strided(local.data(), scalars),
                          uy = view.from_dofs * Strided(local.data() + 1, scalars);
    const Eigen::MatrixXd strain = strain_of(solid, view, local);
    for (const Place& place : view.places) {
      const Point xi = view.frame.to_local(place.at), expected = exact.displacement(place.at);
      const Eigen::VectorXd m = powers(xi, view.order);
      sum.displacement +=
          place.weight * (std::pow(m.dot(ux) - expected.x, 2) + std::pow(m.dot(uy) - expected.y, 2));
      const Eigen::VectorXd found = strain.transpose() * powers(xi, view.order - 1);
      const model::Voigt right = exact.strain(place.at);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          sum.energy += place.weight * (found[static_cast<Eigen::Index>(i)] - right[i]) * d[4 * i + j] *
                        (found[static_cast<Eigen::Index>(j)] - right[j]);
    }
  }
  return {std::sqrt(sum.displacement), std::sqrt(sum.energy)};
}

Norms solved_norms(patch::Solid& solid, const Smooth& exact) {
  const mesh::Mesh& mesh = solid.model.mesh;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto e = static_cast<std::size_t>(edge);
    if (mesh.edge_cells[e][1] >= 0) continue;
    const auto [from, to] = mesh.edge_points[e];
    const bool top = mesh.points[static_cast<std::size_t>(from)].y == 1 &&
                     mesh.points[static_cast<std::size_t>(to)].y == 1;
    if (!top) {
      hold(solid, edge, exact.displacement);
      continue;
    }
    pull(solid, edge, [&](Point at) {
      const model::Voigt s = solid.model.material(0).respond(exact.strain(at), {}, {}).stress;
      return Point{s[2], s[1]};
    });
  }
  weigh(solid, exact.body_force);
  if (solid.solve().empty()) throw std::runtime_error(solid.failure);
  return error_norms(solid, exact);
}

}  // namespace ashlar::convergence
