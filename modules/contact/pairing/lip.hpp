#pragma once
// The lips of a joint as pairings see them: edges with their normals and the nodes of their trace, for
// elements of any order.

#include "contact/pairing/near_edges.hpp"
#include "contact/parts.hpp"

namespace ashlar::contact {

/// Round-off of coordinates relative to an edge: positions nearer than this are the same.
constexpr double same_place = 1e-9;

/// A node of an edge's trace.
struct TraceNode {
  Index dof = -1;  ///< the first of its two
  double t = 0;    ///< place on the edge, from 0 to 1 along the path
  Point at;
};

class Lips {
 public:
  /// Keeps references to both.
  Lips(const model::Model& model, const mesh::JointLips& joint, int slave);

  const model::Model& model() const { return model_; }
  const std::vector<mesh::LipEdge>& slave() const { return slave_; }
  const std::vector<mesh::LipEdge>& master() const { return master_; }
  int slave_number() const { return slave_number_; }
  /// Lips of bodies that were meshed apart.
  bool apart() const { return apart_; }
  Point at(Index point) const { return model_.mesh.points[point]; }
  double length(const mesh::LipEdge& edge) const { return geometry::distance(at(edge.from), at(edge.to)); }
  Point place(const mesh::LipEdge& edge, double t) const {
    return at(edge.from) + t * (at(edge.to) - at(edge.from));
  }
  /// The place on the true surface: on the arc that an edge of a body meshed apart is a chord of.
  Point surface(const mesh::LipEdge& edge, Point place) const {
    return apart_ && edge.arc ? edge.arc->nearest(place) : place;
  }
  /// Outward unit normal: border edges have their body on the left.
  Point normal(const mesh::LipEdge& edge) const;
  /// The direction that pressure acts along where these edges meet, outward of the master: between both
  /// normals, nearer to that of the stiffer body, to which the softer one turns.
  Point contact_normal(const mesh::LipEdge& slave, const mesh::LipEdge& master) const;
  /// Where the line through `place` along that direction meets the master edge: 0 … 1 on it. Forces on both
  /// lips are then on one line.
  double opposite(const mesh::LipEdge& slave, const mesh::LipEdge& master, Point place) const;
  /// Unit vector along which slip is that of the first lip against the second: along the path for a jump of
  /// the first lip against the second, against it for one of the second.
  Point slip_direction(const mesh::LipEdge& edge) const;
  double modulus(const mesh::LipEdge& edge) const { return model_.material(edge.cell).plane_modulus(); }
  /// Nodes along the path.
  std::vector<TraceNode> nodes(const mesh::LipEdge& edge) const;
  /// Their shape functions at t.
  void shape(const mesh::LipEdge& edge, double t, std::vector<double>& values) const;
  /// Lips face each other within 60°; others belong to another leg of the joint.
  bool facing(const mesh::LipEdge& slave, const mesh::LipEdge& master) const;
  /// Master edges that face a slave edge and may stand opposite some place of it.
  std::vector<const mesh::LipEdge*> opposite_edges(const mesh::LipEdge& slave) const;
  /// The master edge nearest to a place on a slave edge; of equally near ones (corners, crossings) the one
  /// nearest to `towards`.
  const mesh::LipEdge* nearest_master(const mesh::LipEdge& slave, Point place, Point towards) const;

 private:
  const model::Model& model_;
  const std::vector<mesh::LipEdge>&slave_, &master_;
  int slave_number_;
  bool apart_;
  NearEdges near_;  ///< of the master
};

/// A node of a slave edge with what it stands for of that edge.
struct SlavePart {
  const mesh::LipEdge* edge = nullptr;
  TraceNode node;
  std::size_t number = 0;  ///< among the edge's nodes, along the path
  double length = 0;       ///< ∫ φ ds
  double area = 0;         ///< ∫ φ depth ds
  int piece = 0;
};
/// The nodes of all slave edges, along the path.
std::vector<SlavePart> slave_parts(const Lips& lips);

/// What a slave part alone gives a contact point: all but its partner.
ContactPoint begin_point(const Lips& lips, const SlavePart& part, const mesh::LipEdge& master);

/// `one` gets the mean jump and gap of both, by their areas.
void merge_shares(ContactPoint& one, const ContactPoint& other);

/// Appends the point of one part: both parts of a node on a straight or curved lip become one contact point;
/// at a corner they stay two.
void append(const Lips& lips, std::vector<ContactPoint>& points, ContactPoint point);

/// Lengths of the slave's edges at its nodes: h is their mean.
void set_sizes(const Lips& lips, std::vector<ContactPoint>& points);

}  // namespace ashlar::contact
