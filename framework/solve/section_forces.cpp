#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"
#include "model/edge_load.hpp"
#include "solve/sections.hpp"

namespace ashlar::solve {

using geometry::Index;
using geometry::Point;
using mesh::LinePiece;
using Side = LinePiece::Cell;

namespace {

// Forces from outside that are less of the largest one are round-off of a free border.
constexpr double negligible = 1e-9;

/// One force more in a sum about a point.
void add(model::Resultant& sum, Point force, Point arm) {
  sum.x += force.x;
  sum.y += force.y;
  sum.moment += geometry::cross(arm, force);
}

/// Cells touched by a line, one after another.
class CutSum {
 public:
  CutSum(const SectionForcesInput& stage, const mesh::SectionLine& line)
      : model_(stage.model),
        terms_(stage.terms),
        state_(stage.state),
        outside_(stage.outside),
        line_(line),
        middle_(line.middle()),
        body_on_right_(line.body_on_right()),
        load_(static_cast<std::size_t>(model_.dofs.size())) {
    for (const LinePiece& piece : line.pieces)
      if (piece.edge >= 0) followed_.push_back(piece.edge);
    for (const double force : outside_) largest_outside_ = std::max(largest_outside_, std::abs(force));
  }

  model::Resultant sum() {
    for (const mesh::TouchedCell& each : line_.cells) add_cell(each);
    for (const Index edge : held_edges()) spread_outside_forces(edge);
    return sum_;
  }

 private:
  struct Node {
    Point place;
    bool on = false;  ///< the line
  };

  void add_cell(const mesh::TouchedCell& each) {
    if (each.side == Side::right && !body_on_right_) return;
    gather(each.cell);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      // Over all nodes of a cell these forces sum to zero: those on the line stand for those beside it.
      const double share = each.side == Side::crossed ? (line_.side(nodes_[i].place) > 0 ? 1 : 0)
                           : !nodes_[i].on            ? 0
                           : each.side == Side::left  ? -1
                                                      : 1;
      if (share == 0) continue;
      const Point force{share * force_[2 * i], share * force_[2 * i + 1]};
      add(sum_, rigid_[i].translation * force, {});
      sum_.moment += geometry::cross(rigid_[i].place - rigid_[i].translation * middle_, force);
    }
    if (each.side == Side::crossed) add_loads_on_the_left(each.cell);
  }

  /// Nodal forces of the cell without its loads, what rigid motions give its nodes, and where they are.
  void gather(Index cell) {
    dofs_.clear();
    model_.dofs.append_cell(model_.mesh, cell, dofs_);
    force_.assign(dofs_.size(), 0);
    for (const auto& term : terms_.stiffness) term->add_group_force(state_, cell, force_);
    for (const auto& term : terms_.nonlinear) term->add_group_force(state_, cell, force_);
    subtract_loads(cell);
    gather_nodes(cell);
  }

  void subtract_loads(Index cell) {
    model_.mesh.corners(cell, corners_);
    std::vector<double> body(dofs_.size());
    model_.element->add_body_force(model_.cell(corners_), body_force(cell), body);
    for (std::size_t i = 0; i < dofs_.size(); ++i) force_[i] -= body[i];
    each_traction(cell, [&](Index edge, const model::EdgeTraction& traction) {
      model::add_traction(model_, edge, traction, load_);
    });
    for (std::size_t i = 0; i < dofs_.size(); ++i) {
      force_[i] -= load_[dofs_[i]];
      load_[dofs_[i]] = 0;
    }
  }

  void gather_nodes(Index cell) {
    const auto points = model_.mesh.cell_points[cell], edges = model_.mesh.cell_edges[cell];
    rigid_.clear();
    nodes_.clear();
    const auto add_node = [&](Point at, bool on) {
      rigid_.push_back({1, at});
      nodes_.push_back({at, on});
    };
    for (std::size_t i = 0; i < points.size(); ++i) add_node(corners_[i], line_.on_line[points[i]] != 0);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < model_.dofs.field().per_edge; ++k) {
        const double t = model_.element->edge_node(k);
        add_node((1 - t) * corners_[i] + t * corners_[(i + 1) % corners_.size()],
                 std::ranges::count(followed_, edges[i]) > 0);
      }
    std::vector<model::RigidValue> own(static_cast<std::size_t>(model_.dofs.field().per_cell));
    model_.element->rigid_values(model_.cell(corners_), own);
    rigid_.insert(rigid_.end(), own.begin(), own.end());
    // To which side a cell's own nodes count is free: their loads are taken off.
    nodes_.resize(rigid_.size(), {geometry::centroid(corners_), false});
  }

  Point body_force(Index cell) const {
    Point sum;
    for (const auto& load : terms_.loads)
      if (const model::LoadOrigin* origin = load->origin(); origin && origin->body_force)
        sum = sum + origin->body_force(cell);
    return sum;
  }

  /// Tractions on the cell's edges; those on edges that the line follows act on the cut itself.
  template <class Use>
  void each_traction(Index cell, Use&& use) const {
    for (const Index edge : model_.mesh.cell_edges[cell]) {
      if (model_.mesh.edge_cells[edge][1] >= 0 || std::ranges::count(followed_, edge) > 0) continue;
      for (const auto& load : terms_.loads) {
        if (!load->origin()) continue;
        for (const auto& [edges, traction] : load->origin()->tractions)
          if (std::ranges::count(edges, edge) > 0) use(edge, traction);
      }
    }
  }

  std::array<Point, 2> ends_of(Index edge) const {
    const auto [from, to] = model_.mesh.edge_points[edge];
    return {model_.mesh.points[from], model_.mesh.points[to]};
  }

  /// Where the line crosses an edge of this cell, and the edge's ends: positions in [0, 1], ascending.
  std::vector<double> cuts_of(Index cell, Index edge) const {
    const auto [from, to] = model_.mesh.edge_points[edge];
    const Point a = model_.mesh.points[from], along = model_.mesh.points[to] - a;
    std::vector<double> cuts{0, 1};
    for (const LinePiece& piece : line_.pieces)
      for (const mesh::LineStation* end : {&piece.from, &piece.to})
        if (piece.cell == cell && end->edge == edge)
          cuts.push_back(geometry::dot(end->at - a, along) / geometry::dot(along, along));
    std::ranges::sort(cuts);
    return cuts;
  }

  // Body force times the area of the cell's left part, by Green's theorem along its border; tractions on the
  // left parts of its edges.
  void add_loads_on_the_left(Index cell) {
    double area = 0;
    Point moment;  // ∫ (x − middle)
    const auto along = [&](Point a, Point b) {
      const double twice = geometry::cross(a - middle_, b - middle_);
      area += twice / 2;
      moment = moment + (twice / 6) * ((a - middle_) + (b - middle_));
    };
    for (const LinePiece& piece : line_.pieces)
      if (piece.cell == cell && piece.side != Side::right) along(piece.from.at, piece.to.at);
    each_left_part(cell, [&](Index edge, std::array<double, 2> part, bool forward) {
      const auto [from, to] = ends_of(edge);
      const Point start = (1 - part[0]) * from + part[0] * to, end = (1 - part[1]) * from + part[1] * to;
      forward ? along(start, end) : along(end, start);
    });
    const Point weight = model_.thickness * body_force(cell);
    add(sum_, area * weight, {});
    sum_.moment += geometry::cross(moment, weight);
    each_traction(cell, [&](Index loaded, const model::EdgeTraction& traction) {
      each_left_part(cell, [&](Index edge, std::array<double, 2> part, bool) {
        if (edge != loaded) return;
        const model::Resultant r = model::traction_resultant(model_, edge, traction, part, middle_);
        sum_.x += r.x;
        sum_.y += r.y;
        sum_.moment += r.moment;
      });
    });
  }

  /// Calls use(edge, part, whether the edge runs in the cell's sense) for what of the cell's edges is left.
  template <class Use>
  void each_left_part(Index cell, Use&& use) const {
    const auto points = model_.mesh.cell_points[cell], edges = model_.mesh.cell_edges[cell];
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto [from, to] = model_.mesh.edge_points[edges[i]];
      const std::vector<double> cuts = cuts_of(cell, edges[i]);
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double t = 0.5 * (cuts[k] + cuts[k + 1]);
        if (line_.side((1 - t) * model_.mesh.points[from] + t * model_.mesh.points[to]) > 0)
          use(edges[i], {cuts[k], cuts[k + 1]}, from == points[i]);
      }
    }
  }

  /// Border edges that the line crosses, and those on its left that end on it.
  std::vector<Index> held_edges() const {
    std::vector<Index> edges;
    for (const mesh::TouchedCell& each : line_.cells)
      for (const Index edge : model_.mesh.cell_edges[each.cell]) {
        if (model_.mesh.edge_cells[edge][1] >= 0 || std::ranges::count(followed_, edge) > 0) continue;
        const auto [a, b] = model_.mesh.edge_points[edge];
        const bool ends_on_it = (line_.on_line[a] != 0) != (line_.on_line[b] != 0) &&
                                line_.side(model_.mesh.points[line_.on_line[a] ? b : a]) > 0;
        if (ends_on_it || cuts_of(each.cell, edge).size() > 2) edges.push_back(edge);
      }
    return edges;
  }

  Point outside_at(Index dof) const { return {outside_[dof], outside_[dof + 1]}; }

  bool is_held(Index point) const {
    return geometry::norm(outside_at(model_.dofs.of_point(point))) > negligible * largest_outside_;
  }

  // Reactions and contact forces come by nodes, and those near the line stand for both sides of it. As a
  // traction that is even along the crossed edge, they act on the part of it that lies on the left.
  void spread_outside_forces(Index edge) {
    const auto [a, b] = model_.mesh.edge_points[edge];
    if (!is_held(a) || !is_held(b)) return;
    const Point from = model_.mesh.points[a], to = model_.mesh.points[b];
    const double length = geometry::distance(from, to), corner = corner_weight();
    Point force = outside_at(model_.dofs.of_point(a)) + outside_at(model_.dofs.of_point(b));
    for (int k = 0; k < model_.dofs.field().per_edge; ++k)
      force = force + outside_at(model_.dofs.of_edge(edge, k));
    const double carries = length + corner * (held_length_beside(a, edge) + held_length_beside(b, edge));
    const Point traction = (1 / carries) * force;
    const auto at = [&](double t) { return (1 - t) * from + t * to - middle_; };
    const auto give = [&](double share, double t) {
      const Point part = share * length * traction;
      add(sum_, part, at(t));
    };
    each_left_part(model_.mesh.edge_cells[edge][0], [&](Index each, std::array<double, 2> part, bool) {
      if (each == edge) give(part[1] - part[0], 0.5 * (part[0] + part[1]));
    });
    // What the nodes on the left were taken to carry of this edge.
    const auto take = [&](double share, double t) {
      if (line_.side(at(t) + middle_) > 0) give(-share, t);
    };
    take(corner, 0);
    take(corner, 1);
    for (int k = 0; k < model_.dofs.field().per_edge; ++k)
      take((1 - 2 * corner) / model_.dofs.field().per_edge, model_.element->edge_node(k));
  }

  /// Length of the held border that goes on beyond one end of an edge.
  double held_length_beside(Index point, Index edge) const {
    double length = 0;
    for (Index other = 0; other < model_.mesh.edge_count(); ++other) {
      if (other == edge || model_.mesh.edge_cells[other][1] >= 0) continue;
      const auto [a, b] = model_.mesh.edge_points[other];
      if ((a == point && is_held(b)) || (b == point && is_held(a)))
        length += geometry::distance(model_.mesh.points[a], model_.mesh.points[b]);
    }
    return length;
  }

  /// Mean of an end's shape function along an edge; those of its inner nodes, at most two, are alike.
  double corner_weight() const {
    std::vector<double> shape(static_cast<std::size_t>(model_.element->order()) + 1);
    const geometry::Rule& rule = geometry::gauss_legendre(model_.element->order());
    double mean = 0;
    for (std::size_t g = 0; g < rule.at.size(); ++g) {
      model_.element->edge_shape(rule.at[g], shape);
      mean += rule.weight[g] * shape[0];
    }
    return mean;
  }

  const model::Model& model_;
  const model::Terms& terms_;
  const fields::State& state_;
  std::span<const double> outside_;
  double largest_outside_ = 0;
  const mesh::SectionLine& line_;
  Point middle_;
  bool body_on_right_;
  std::vector<Index> followed_;
  model::Resultant sum_;
  // Of one cell.
  std::vector<Index> dofs_;
  std::vector<double> force_, load_;  ///< load_: by dof of the whole, zero between cells
  std::vector<Point> corners_;
  std::vector<model::RigidValue> rigid_;
  std::vector<Node> nodes_;
};

}  // namespace

model::SectionForces section_forces(const SectionForcesInput& stage, const mesh::SectionLine& line) {
  const model::Resultant sum = CutSum(stage, line).sum();
  const Point t = line.along(), force{sum.x, sum.y};
  return {geometry::dot(force, geometry::left_of(t)), geometry::dot(force, t), sum.moment};
}

}  // namespace ashlar::solve
