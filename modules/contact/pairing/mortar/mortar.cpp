#include "contact/pairing/mortar/mortar.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Cholesky>

#include "contact/pairing/lip.hpp"
#include "geometry/quadrature.hpp"

namespace ashlar::contact {

namespace {

using mesh::LipEdge;

// Edges whose normals differ by more than 30° (as distance of unit vectors) are a corner of the lip.
constexpr double smooth = 0.52;
// A share of an edge that is rounding, not a segment.
constexpr double nothing = 1e-9;

/// A stretch of a slave edge that faces one master edge.
struct Segment {
  double from = 0, to = 0;  ///< on the slave edge
  const LipEdge* master = nullptr;
};

std::vector<Segment> segments(const Lips& lips, const LipEdge& slave) {
  const Point x = lips.at(slave.from), d = lips.at(slave.to) - x;
  const double l2 = geometry::dot(d, d);
  std::vector<double> ends = {0, 1};
  std::vector<const LipEdge*> masters;
  for (const LipEdge* master : lips.opposite_edges(slave)) {
    const double a = geometry::dot(lips.at(master->from) - x, d) / l2,
                 b = geometry::dot(lips.at(master->to) - x, d) / l2;
    if (std::max(a, b) <= nothing || std::min(a, b) >= 1 - nothing) continue;
    masters.push_back(master);
    for (const double t : {a, b})
      if (t > nothing && t < 1 - nothing) ends.push_back(t);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Segment> list;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i + 1] - ends[i] < nothing) continue;
    const Point middle = lips.place(slave, (ends[i] + ends[i + 1]) / 2);
    const LipEdge* nearest = nullptr;
    double least = INFINITY;
    for (const LipEdge* master : masters) {
      const double t = lips.opposite(slave, *master, middle);
      if (t < -nothing || t > 1 + nothing) continue;
      const double away = geometry::distance(lips.place(*master, t), middle);
      if (away < least) nearest = master, least = away;
    }
    if (nearest) list.push_back({ends[i], ends[i + 1], nearest});
  }
  return list;
}

/// Sums over the segments of one slave edge.
struct EdgeSums {
  Eigen::VectorXd length, area, gap;  ///< ∫ φ ds, ∫ φ depth ds, ∫ ψ g ds by slave node
  Eigen::MatrixXd mass;               ///< ∫ φ_i φ_j ds
  std::vector<std::map<Index, std::pair<double, Point>>> master;  ///< ∫ ψ_i N_j ds by master dof
  Eigen::MatrixXd slave;                                          ///< ∫ ψ_i φ_j ds
  Eigen::Matrix2Xd normal;                                        ///< ∫ ψ n ds, n: outward of the master
  double covered = 0, modulus = INFINITY, overlap = 0;
};

/// One integration point of a segment.
struct At {
  double weight = 0, depth = 0, gap = 0;  ///< weight: length [m]
  std::vector<double> slave, master;      ///< shape functions
  const LipEdge* edge = nullptr;          ///< of the master
};

std::vector<At> integration_points(const Lips& lips, const LipEdge& slave, const std::vector<Segment>& list) {
  const geometry::Rule& rule = geometry::gauss_legendre(2 * lips.model().element->order() + 1);
  std::vector<At> points;
  for (const Segment& segment : list)
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
      const double t = segment.from + rule.at[q] * (segment.to - segment.from);
      const Point place = lips.place(slave, t);
      const double on_master = std::clamp(lips.opposite(slave, *segment.master, place), 0.0, 1.0);
      At& at = points.emplace_back();
      at.weight = rule.weight[q] * (segment.to - segment.from) * lips.length(slave);
      at.depth = lips.model().depth(place);
      at.edge = segment.master;
      // g = n·(x_s − x_m), n: outward of the master
      const Point there = lips.place(*segment.master, on_master);
      at.gap = geometry::dot(lips.contact_normal(slave, *segment.master),
                             lips.surface(slave, place) - lips.surface(*segment.master, there));
      lips.shape(slave, t, at.slave);
      lips.shape(*segment.master, on_master, at.master);
    }
  return points;
}

Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& list) {
  return {list.data(), static_cast<Index>(list.size())};
}

/// ψ = C φ with ∫ ψ_i φ_j = δ_ij ∫ φ_i. On an edge that faces the other lip in part, these might have no or a
/// negative weight: the linear functions of its ends serve, ψ = 1 − t and t.
Eigen::MatrixXd multipliers(const EdgeSums& sums, const std::vector<TraceNode>& nodes, double length) {
  const auto count = static_cast<Index>(nodes.size());
  if (sums.covered > (1 - nothing) * length)
    return sums.length.asDiagonal() * sums.mass.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  Eigen::MatrixXd psi = Eigen::MatrixXd::Zero(count, count);
  for (Index j = 0; j < count; ++j) {
    psi(0, j) = 1 - nodes[static_cast<std::size_t>(j)].t;
    psi(count - 1, j) = nodes[static_cast<std::size_t>(j)].t;
  }
  return psi;
}

/// A function of a welded tip has no multiplier: its neighbour takes it over, so that all still sum to 1.
void leave_out_tips(const Lips& lips, const std::vector<TraceNode>& nodes, const std::vector<At>& points,
                    Eigen::MatrixXd& psi) {
  const Index last = psi.rows() - 1;
  const auto is_master = [&](Index dof) {
    return std::ranges::any_of(points, [&](const At& at) {
      return lips.model().dofs.of_point(at.edge->from) == dof ||
             lips.model().dofs.of_point(at.edge->to) == dof;
    });
  };
  for (const auto& [tip, next] : {std::pair{Index{0}, Index{1}}, std::pair{last, last - 1}})
    if (is_master(nodes[tip].dof)) {
      psi.row(next) += psi.row(tip);
      psi.row(tip).setZero();
    }
}

EdgeSums integrate(const Lips& lips, const LipEdge& slave) {
  const std::vector<At> points = integration_points(lips, slave, segments(lips, slave));
  const std::vector<TraceNode> nodes = lips.nodes(slave);
  const auto count = static_cast<Index>(nodes.size());
  EdgeSums sums;
  sums.length = sums.area = sums.gap = Eigen::VectorXd::Zero(count);
  sums.mass = sums.slave = Eigen::MatrixXd::Zero(count, count);
  sums.normal = Eigen::Matrix2Xd::Zero(2, count);
  sums.master.resize(nodes.size());
  for (const At& at : points) {
    const auto phi = vector(at.slave);
    sums.covered += at.weight;
    sums.length += at.weight * phi;
    sums.mass += at.weight * phi * phi.transpose();
  }
  if (points.empty() || sums.covered < nothing * lips.length(slave)) return {};
  Eigen::MatrixXd psi = multipliers(sums, nodes, lips.length(slave));
  leave_out_tips(lips, nodes, points, psi);
  sums.length.setZero();
  for (const At& at : points) {
    const Eigen::VectorXd own = at.weight * (psi * vector(at.slave));
    sums.length += own;
    sums.area += at.depth * own;
    const Point n = lips.contact_normal(slave, *at.edge);
    sums.normal += Eigen::Vector2d(n.x, n.y) * own.transpose();
    sums.gap += at.gap * own;
    sums.overlap = std::max(sums.overlap, -at.gap);
    sums.slave += own * vector(at.slave).transpose();
    sums.modulus = std::min({sums.modulus, lips.modulus(slave), lips.modulus(*at.edge)});
    const std::vector<TraceNode> there = lips.nodes(*at.edge);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < there.size(); ++j) {
        auto& [factor, place] = sums.master[i][there[j].dof];
        factor += own[static_cast<Index>(i)] * at.master[j];
        place = there[j].at;
      }
  }
  return sums;
}

/// Sums over all edges of a smooth stretch of the lip, by slave node.
struct Gathered {
  ContactPoint point;
  std::map<Index, ContactPoint::Share> share;  ///< by dof: ∫ ψ (slave − master)
  Point across, along;
  double gap = 0;
};

class Stretch {
 public:
  Stretch(const Lips& lips, int piece) : lips_(lips), piece_(piece) {}

  /// False if the edge faces nothing.
  bool add(const LipEdge& edge) {
    const EdgeSums sums = integrate(lips_, edge);
    const std::vector<TraceNode> nodes = lips_.nodes(edge);
    if (sums.master.empty()) return false;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto row = static_cast<Index>(i);
      if (sums.length[row] == 0) continue;
      Gathered& own = at(edge, nodes[i]);
      own.point.length += sums.length[row];
      own.point.area += sums.area[row];
      own.gap += sums.gap[row];
      own.across = own.across + Point{sums.normal(0, row), sums.normal(1, row)};
      own.along = own.along + sums.length[row] * lips_.slip_direction(edge);
      own.point.modulus = std::min(own.point.modulus, sums.modulus);
      own.point.overlap = std::max(own.point.overlap, sums.overlap);
      for (std::size_t j = 0; j < nodes.size(); ++j)
        add_share(own, {nodes[j].dof, sums.slave(row, static_cast<Index>(j)), nodes[j].at, true});
      for (const auto& [dof, part] : sums.master[i]) add_share(own, {dof, -part.first, part.second, false});
    }
    return true;
  }

  void finish(std::vector<ContactPoint>& points) {
    for (Gathered& own : list_) {
      ContactPoint& point = own.point;
      point.gap = own.gap / point.length;
      if (std::abs(point.gap) < same_place * point.length) point.gap = 0;
      if (point.overlap < same_place * point.length) point.overlap = 0;
      const Index slave = node_[static_cast<std::size_t>(&own - list_.data())];
      // The node itself comes first.
      for (const bool first : {true, false})
        for (const auto& [dof, part] : own.share)
          if ((dof == slave) == first && std::abs(part.factor) > 1e-14 * point.length)
            point.shares.push_back({dof, part.factor / point.length, part.at, part.slave});
      point.normal = (1 / geometry::norm(own.across)) * own.across;
      const Point across = geometry::left_of(point.normal);
      point.tangent = (geometry::dot(across, own.along) < 0 ? -1 : 1) * across;
      points.push_back(std::move(point));
    }
  }

 private:
  static void add_share(Gathered& own, const ContactPoint::Share& part) {
    own.share.try_emplace(part.dof, ContactPoint::Share{part.dof, 0, part.at, part.slave})
        .first->second.factor += part.factor;
  }

  Gathered& at(const LipEdge& edge, const TraceNode& node) {
    const auto found = std::ranges::find(node_, node.dof);
    if (found != node_.end()) return list_[static_cast<std::size_t>(found - node_.begin())];
    node_.push_back(node.dof);
    Gathered& own = list_.emplace_back();
    own.point.slave = lips_.slave_number();
    own.point.modulus = INFINITY;
    own.point.at = node.at;
    own.point.s = edge.s_from + node.t * (edge.s_to - edge.s_from);
    own.point.piece = piece_;
    return own;
  }

  const Lips& lips_;
  int piece_;
  std::vector<Index> node_;
  std::vector<Gathered> list_;
};

}  // namespace

std::vector<ContactPoint> Mortar::pair(const model::Model& model, const mesh::JointLips& joint, int slave,
                                       std::vector<std::string>* remarks) const {
  const Lips lips(model, joint, slave);
  std::vector<ContactPoint> points;
  std::size_t beyond = 0;
  int piece = 0;
  std::optional<Stretch> stretch;
  for (std::size_t i = 0; i < lips.slave().size(); ++i) {
    const LipEdge& edge = lips.slave()[i];
    const bool follows = i > 0 && lips.slave()[i - 1].to == edge.from;
    if (i > 0 && !follows) ++piece;
    const bool corner =
        follows && geometry::distance(lips.normal(edge), lips.normal(lips.slave()[i - 1])) > smooth;
    if (stretch && (!follows || corner)) {
      stretch->finish(points);
      stretch.reset();
    }
    if (!stretch) stretch.emplace(lips, piece);
    if (!stretch->add(edge)) ++beyond;
  }
  if (stretch) stretch->finish(points);
  set_sizes(lips, points);
  if (beyond > 0 && remarks)
    remarks->push_back(std::to_string(beyond) +
                       " edges of the slave lip face no edge of the other lip and carry no contact");
  return points;
}

}  // namespace ashlar::contact
