#include "elasticity/section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elasticity/cell_access.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::elasticity {

using mesh::LinePiece;
using mesh::LineStation;
using model::Model;
using model::SectionResult;

namespace {

using Row = SectionResult::Row;
using Side = SectionResult::Side;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Places of the values below: in each row.
enum Value { ux, uy, sxx, syy, sxy, normal, shear, s1, s3, values };

const std::vector<SectionResult::Column> columns = {{"ux", "m"},   {"uy", "m"},   {"sxx", "Pa"},
                                                    {"syy", "Pa"}, {"sxy", "Pa"}, {"sn", "Pa"},
                                                    {"tau", "Pa"}, {"s1", "Pa"},  {"s3", "Pa"}};

/// The profile of one line.
class Profile {
 public:
  Profile(const Model& model, std::span<const double> u, const mesh::Adjacency& cells_of_point,
          Recovery& recovery, const mesh::SectionLine& line, SectionResult& result)
      : model_(model),
        u_(u),
        cells_of_point_(cells_of_point),
        recovery_(recovery),
        line_(line),
        result_(result) {}

  void fill() {
    result_.columns = columns;
    std::vector<const LinePiece*> right;
    const LinePiece* before = nullptr;
    for (const LinePiece& piece : line_.pieces) {
      const LinePiece* other = across(piece);
      if (piece.side == LinePiece::Cell::right && other) {
        if (!bonded(piece, *other)) right.push_back(&piece);
        continue;
      }
      const bool both = piece.side == LinePiece::Cell::crossed || (other && bonded(piece, *other));
      add_piece(piece, both ? Side::both : side_of(piece), before);
      integrate(piece);
      before = &piece;
    }
    before = nullptr;
    for (const LinePiece* piece : right) {
      add_piece(*piece, Side::right, before);
      before = piece;
    }
    finish();
  }

 private:
  static Side side_of(const LinePiece& piece) {
    return piece.side == LinePiece::Cell::left ? Side::left : Side::right;
  }

  /// The piece on the other side of a followed edge.
  const LinePiece* across(const LinePiece& piece) const {
    if (piece.side == LinePiece::Cell::crossed) return nullptr;
    const double s = 0.5 * (piece.from.s + piece.to.s);
    for (const LinePiece& other : line_.pieces)
      if (other.side != LinePiece::Cell::crossed && other.side != piece.side && other.from.s < s &&
          s < other.to.s)
        return &other;
    return nullptr;
  }

  bool bonded(const LinePiece& a, const LinePiece& b) const {
    return a.edge == b.edge && same_stiffness(model_.material(a.cell), model_.material(b.cell));
  }

  /// No jump where one piece ends and the next begins.
  bool joins(const LinePiece& a, const LinePiece& b) const {
    const bool same_place =
        (a.to.point >= 0 && a.to.point == b.from.point) || (a.to.edge >= 0 && a.to.edge == b.from.edge);
    return same_place && a.segment == b.segment &&
           same_stiffness(model_.material(a.cell), model_.material(b.cell));
  }

  void add_piece(const LinePiece& piece, Side side, const LinePiece* before) {
    sample(piece);
    const bool goes_on = before && joins(*before, piece) && result_.rows.back().side == side;
    if (!result_.rows.empty() && !goes_on) ++number_;
    for (std::size_t i = goes_on ? 1 : 0; i < samples_.size(); ++i) {
      Row row = samples_[i];
      row.side = side;
      row.piece = number_;
      result_.rows.push_back(std::move(row));
    }
  }

  /// order + 1 rows from end to end of a piece.
  void sample(const LinePiece& piece) {
    samples_.clear();
    const int count = model_.element->order() + 1;
    for (int i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / (count - 1);
      LineStation at = i == 0 ? piece.from : i + 1 == count ? piece.to : LineStation{};
      if (i > 0 && i + 1 < count) {
        at.s = (1 - t) * piece.from.s + t * piece.to.s;
        at.at = (1 - t) * piece.from.at + t * piece.to.at;
        at.edge = piece.edge;
      }
      samples_.push_back(row_at(piece, at));
    }
  }

  Row row_at(const LinePiece& piece, const LineStation& at) {
    Row row{at.s, at.at, Side::both, 0, model_.mesh.regions[model_.mesh.cell_region[piece.cell]], {}};
    row.values.assign(values, unknown);
    displace(at, row.values);
    around(piece, at);
    const Stress stress = recovery_.on_side(at.at, around_, piece.cell);
    for (const double component : stress) largest_ = std::max(largest_, std::abs(component));
    const Point t = line_.direction(piece.segment), n = geometry::left_of(t);
    const Point traction{stress[0] * n.x + stress[2] * n.y, stress[2] * n.x + stress[1] * n.y};
    row.values[sxx] = stress[0];
    row.values[syy] = stress[1];
    row.values[sxy] = stress[2];
    row.values[normal] = geometry::dot(n, traction);
    row.values[shear] = geometry::dot(t, traction);
    const Principal both = principal(stress);
    row.values[s1] = both.s1;
    row.values[s3] = both.s3;
    return row;
  }

  /// The displacement is known at points and on edges.
  void displace(const LineStation& at, std::vector<double>& row) const {
    if (at.point >= 0) {
      const Index dof = model_.dofs.of_point(at.point);
      row[ux] = u_[dof];
      row[uy] = u_[dof + 1];
    } else if (at.edge >= 0) {
      const auto [from, to] = model_.mesh.edge_points[at.edge];
      const Point a = model_.mesh.points[from], along = model_.mesh.points[to] - a;
      std::vector<double> shape(static_cast<std::size_t>(model_.element->order()) + 1);
      model_.element->edge_shape(geometry::dot(at.at - a, along) / geometry::dot(along, along), shape);
      row[ux] = row[uy] = 0;
      for (std::size_t k = 0; k < shape.size(); ++k) {
        const Index dof = k < 2 ? model_.dofs.of_point(k == 0 ? from : to)
                                : model_.dofs.of_edge(at.edge, static_cast<int>(k) - 2);
        row[ux] += shape[k] * u_[dof];
        row[uy] += shape[k] * u_[dof + 1];
      }
    }
  }

  /// The cells around the point, the edge's ends, or the cell's corners.
  void around(const LinePiece& piece, const LineStation& at) {
    around_.clear();
    const auto take = [&](Index point) {
      const auto cells = cells_of_point_[point];
      around_.insert(around_.end(), cells.begin(), cells.end());
    };
    if (at.point >= 0)
      take(at.point);
    else if (at.edge >= 0)
      for (const Index p : model_.mesh.edge_points[at.edge]) take(p);
    else
      for (const Index p : model_.mesh.cell_points[piece.cell]) take(p);
    std::ranges::sort(around_);
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
  }

  /// Tractions as the polynomial through the samples of the piece, integrated exactly with their moment.
  void integrate(const LinePiece& piece) {
    const Point t = line_.direction(piece.segment), n = geometry::left_of(t);
    const double length = piece.to.s - piece.from.s;
    const geometry::Rule& rule = geometry::gauss_legendre(model_.element->order() + 1);
    for (std::size_t g = 0; g < rule.at.size(); ++g) {
      const double weight = rule.weight[g] * length * model_.thickness;
      const Point traction = through_samples(rule.at[g], normal) * n + through_samples(rule.at[g], shear) * t;
      const Point at = (1 - rule.at[g]) * piece.from.at + rule.at[g] * piece.to.at;
      force_ = force_ + weight * traction;
      moment_ += weight * geometry::cross(at - line_.middle(), traction);
      result_.absolute += weight * geometry::norm(traction);
    }
  }

  /// Lagrange's polynomial.
  double through_samples(double t, Value value) const {
    double sum = 0;
    const auto last = static_cast<double>(samples_.size() - 1);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      double basis = 1;
      for (std::size_t k = 0; k < samples_.size(); ++k)
        if (k != i)
          basis *= (t * last - static_cast<double>(k)) / (static_cast<double>(i) - static_cast<double>(k));
      sum += basis * samples_[i].values[value];
    }
    return sum;
  }

  void finish() {
    if (model_.axisymmetric()) return;  // what does not act in one plane has no resultant there
    const Point t = line_.along();
    result_.integral = {geometry::dot(force_, geometry::left_of(t)), geometry::dot(force_, t), moment_};
    result_.integrated = true;
    result_.size = largest_ * geometry::distance(line_.first(), line_.last()) * model_.thickness;
  }

  const Model& model_;
  std::span<const double> u_;
  const mesh::Adjacency& cells_of_point_;
  Recovery& recovery_;
  const mesh::SectionLine& line_;
  SectionResult& result_;
  int number_ = 0;
  Point force_;
  double moment_ = 0, largest_ = 0;
  std::vector<Row> samples_;  ///< of one piece
  std::vector<Index> around_;
};

}  // namespace

void add_section_profiles(const Model& model, const CellStresses& cells, std::span<const double> u,
                          model::StageResult& result) {
  const mesh::Adjacency cells_of_point = model.mesh.cell_points.transposed(model.mesh.point_count());
  Recovery recovery(model, cells, cells_of_point);
  for (std::size_t i = 0; i < model.sections.size(); ++i)
    Profile(model, u, cells_of_point, recovery, model.sections[i], result.sections[i]).fill();
}

void add_cell_force(const Model& model, const Layout& layout, Index cell, std::span<const double> u,
                    std::span<const double> history, std::span<double> force) {
  const Scratch<double, 64> local = gather(layout.dofs[cell], u);
  const model::Material& law = model.material(cell);
  with_cell(model, cell, [&](const model::Cell& shape) {
    if (law.linear()) return model.element->add_internal_force(shape, law, local, force);
    model::IntegrationPoints points;
    model.element->integrate(shape, points);
    const auto own = static_cast<std::size_t>(law.internal_variables());
    const auto committed = layout.of(cell, history);
    std::vector<double> trial(own), stabilisation(force.size() * (force.size() + 1) / 2);
    for (int q = 0; q < points.size(); ++q)
      model::add_stress(points, q,
                        law.respond(points.strain(q, local),
                                    committed.subspan(static_cast<std::size_t>(q) * own, own), trial)
                            .stress,
                        force);
    model.element->add_stabilisation(shape, law, stabilisation);
    model::add_packed_product(stabilisation, local, force);
  });
}

}  // namespace ashlar::elasticity
