#include "stability/fault.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::stability {

namespace {

using geometry::Point;
using model::Cell;
using model::Material;

/// Forces and stiffness come from the points and the stabilisation, as the framework makes them.
class FaultyElement final : public model::Element {
 public:
  FaultyElement(std::shared_ptr<const model::Element> sound, Fault fault, std::array<Point, 2> victim)
      : sound_(std::move(sound)), fault_(fault), victim_(victim) {}

  model::NodeCounts nodes() const override { return sound_->nodes(); }
  int order() const override { return sound_->order(); }
  std::string refuses(const Cell& cell) const override { return sound_->refuses(cell); }
  int point_count(std::size_t corners) const override { return sound_->point_count(corners); }
  bool stabilised() const override { return sound_->stabilised(); }
  void edge_shape(double t, std::span<double> values) const override { sound_->edge_shape(t, values); }
  double edge_node(int node) const override { return sound_->edge_node(node); }
  void rigid_values(const Cell& cell, std::span<model::RigidValue> values) const override {
    sound_->rigid_values(cell, values);
  }

  void integrate(const Cell& cell, model::IntegrationPoints& points) const override {
    std::vector<Point> corners;
    sound_->integrate(seen(cell, corners), points);
    if (!hit(cell)) return;
    for (int q = 0; q < points.size(); ++q) {
      if (fault_ == Fault::wrong_sign) points.row(q, 2)[1] = -points.row(q, 2)[1];
      if (fault_ == Fault::lost_unknown)
        for (int r = 0; r < 4; ++r) points.row(q, r)[0] = 0;
      if (fault_ == Fault::dropped_edge) drop_first_edge(cell, points, q);
    }
  }

  void add_stabilisation(const Cell& cell, const Material& law, std::span<double> packed) const override {
    std::vector<double> own(packed.size());
    std::vector<Point> corners;
    sound_->add_stabilisation(seen(cell, corners), law, own);
    const double scale =
        fault_ == Fault::stiff_rest ? law.respond({}, {}, {}).tangent[0] / law.shear_modulus() : 1;
    const int size = dofs(cell.corners.size());
    std::size_t at = 0;
    for (int i = 0; i < size; ++i)
      for (int k = 0; k <= i; ++k, ++at) {
        if (fault_ == Fault::lost_unknown && k == 0 && hit(cell)) continue;
        packed[at] += scale * own[at] + (fault_ == Fault::absolute_number && i == k ? 1 : 0);
      }
  }

  void stiffness(const Cell& cell, const Material& law, std::span<double> packed) const override {
    Element::stiffness(cell, law, packed);
    if (fault_ == Fault::mismatched_tangent && hit(cell)) packed[0] *= 4;
  }

  void add_body_force(const Cell& cell, Point b, std::span<double> force) const override {
    sound_->add_body_force(cell, fault_ == Fault::upward_weight && hit(cell) ? -1 * b : b, force);
  }

 private:
  bool hit(const Cell& cell) const { return cell.corners[0] == victim_[0] && cell.corners[1] == victim_[1]; }

  Cell seen(const Cell& cell, std::vector<Point>& corners) const {
    if (fault_ != Fault::short_coordinates) return cell;
    const auto cut = [](double x) {
      int exponent = 0;
      const double digits = std::frexp(x, &exponent);
      return std::ldexp(std::round(std::ldexp(digits, 33)), exponent - 33);
    };
    for (const Point p : cell.corners) corners.push_back({cut(p.x), cut(p.y)});
    return {corners, cell.thickness};
  }

  /// Takes ∫ v n over the first edge out of the mean strain.
  void drop_first_edge(const Cell& cell, model::IntegrationPoints& points, int q) const {
    const Point edge = cell.corners[1] - cell.corners[0];
    const double area = geometry::signed_area(cell.corners);
    const auto own = static_cast<std::size_t>(nodes().per_edge);
    std::vector<double> shape(own + 2);
    const geometry::Rule& rule = geometry::gauss_legendre(5);
    for (std::size_t g = 0; g < rule.at.size(); ++g) {
      edge_shape(rule.at[g], shape);
      for (std::size_t m = 0; m < shape.size(); ++m) {
        const std::size_t node = m < 2 ? m : cell.corners.size() + m - 2;
        const double x = rule.weight[g] * shape[m] * edge.y / area,
                     y = -rule.weight[g] * shape[m] * edge.x / area;
        points.row(q, 0)[2 * node] -= x;
        points.row(q, 1)[2 * node + 1] -= y;
        points.row(q, 2)[2 * node] -= y;
        points.row(q, 2)[2 * node + 1] -= x;
      }
    }
  }

  std::shared_ptr<const model::Element> sound_;
  Fault fault_;
  std::array<Point, 2> victim_;
};

/// A law whose internal variables are always those of the beginning.
class Forgetful final : public Material {
 public:
  explicit Forgetful(std::shared_ptr<const Material> sound) : sound_(std::move(sound)) {}
  bool linear() const override { return sound_->linear(); }
  bool symmetric() const override { return sound_->symmetric(); }
  int internal_variables() const override { return sound_->internal_variables(); }
  model::Response respond(const model::Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const override {
    return sound_->respond(strain, std::vector<double>(committed.size()), trial);
  }
  double unit_weight(double gravity) const override { return sound_->unit_weight(gravity); }
  double shear_modulus() const override { return sound_->shear_modulus(); }
  double plane_modulus() const override { return sound_->plane_modulus(); }

 private:
  std::shared_ptr<const Material> sound_;
};

}  // namespace

std::string words(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::wrong_sign:
      return "a wrong sign in one cell";
    case Fault::lost_unknown:
      return "a lost unknown in one cell";
    case Fault::dropped_edge:
      return "a dropped edge in one cell";
    case Fault::upward_weight:
      return "one cell's weight upwards";
    case Fault::absolute_number:
      return "a number without unit";
    case Fault::short_coordinates:
      return "coordinates of ten digits";
    case Fault::mismatched_tangent:
      return "a stiffness unlike its forces";
    case Fault::stiff_rest:
      return "stabilisation with λ in it";
    case Fault::lost_history:
      return "history lost";
    case Fault::cured:
      return "nothing that should stop it";
    case Fault::stronger:
      return "2 % more strength";
    case Fault::reversed_gap:
      return "one contact point's gap with the wrong sign";
    case Fault::scaled_traction:
      return "joints that hold 1 % more than they say";
    case Fault::frozen_status:
      return "joints that keep their status";
  }
  return {};
}

std::shared_ptr<const model::Element> with_fault(std::shared_ptr<const model::Element> element, Fault fault,
                                                 const mesh::Mesh& mesh) {
  if (fault == Fault::none || fault >= Fault::lost_history) return element;
  // The cell with the most inner points: what it does wrong is not hidden by held borders.
  std::vector<char> outer(mesh.points.size());
  for (mesh::Index e = 0; e < mesh.edge_count(); ++e)
    if (mesh.edge_cells[static_cast<std::size_t>(e)][1] < 0)
      for (const mesh::Index p : mesh.edge_points[static_cast<std::size_t>(e)])
        outer[static_cast<std::size_t>(p)] = 1;
  mesh::Index chosen = 0;
  std::ptrdiff_t most = -1;
  for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto points = mesh.cell_points[cell];
    const auto inner =
        std::ranges::count_if(points, [&](mesh::Index p) { return !outer[static_cast<std::size_t>(p)]; });
    if (inner > most) most = inner, chosen = cell;
  }
  const auto corners = mesh.cell_points[chosen];
  return std::make_shared<FaultyElement>(
      std::move(element), fault,
      std::array<Point, 2>{mesh.points[static_cast<std::size_t>(corners[0])],
                           mesh.points[static_cast<std::size_t>(corners[1])]});
}

std::shared_ptr<const Material> with_fault(std::shared_ptr<const Material> law, Fault fault) {
  if (fault != Fault::lost_history) return law;
  return std::make_shared<Forgetful>(std::move(law));
}

}  // namespace ashlar::stability
