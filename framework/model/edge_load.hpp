#pragma once
// Loads that are known before the solution: tractions integrated over border edges, and the force vector that
// they and other loads become.

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/term.hpp"

namespace ashlar::model {

/// A traction along border edges [Pa].
struct EdgeTraction {
  /// The traction at a point; `outward` is the body's outward unit normal there.
  std::function<Point(Point at, Point outward)> at;
  int degree = 1;             ///< of the polynomial that it is along an edge, between the kinks
  std::vector<double> kinks;  ///< heights y where that polynomial changes [m]
};

/// What a load's forces come from.
struct LoadOrigin {
  std::function<Point(Index cell)> body_force;  ///< constant in a cell [N/m³]; empty: none
  std::vector<std::pair<std::vector<Index>, EdgeTraction>> tractions;  ///< on these border edges
};

/// force += thickness ∫ t·φ ds over one edge, by dof [N]. The body of the edge's first cell lies on the left
/// of its sense. The edge is cut at the kinks; on each piece Gauss–Legendre is exact for the traction's
/// degree times the element's shape functions, so that force and moment are exact to round-off.
void add_traction(const Model& model, Index edge, const EdgeTraction& traction, std::span<double> force);

/// Force and moment about `about` of the traction on the part from..to, in [0, 1], of an edge.
Resultant traction_resultant(const Model& model, Index edge, const EdgeTraction& traction,
                             std::array<double, 2> part, Point about);

/// The edges of a group that bound the body on one side only: those that can carry a load. Edges between two
/// cells are left out, which the log says (the ground under a dam). Mistakes at `place`: no such group, an
/// empty group, a group that has no border edge.
std::vector<Index> border_edges(const mesh::Mesh& mesh, const std::string& group, const core::Place& place,
                                core::Mistakes& mistakes);

/// A load as its force vector, kept by its entries other than zero.
class ForceVector final : public Load {
 public:
  /// `force` by dof [N].
  ForceVector(std::string effect, std::span<const double> force, LoadOrigin origin = {});
  void add_force(std::span<double> force) const override;
  const LoadOrigin* origin() const override { return &origin_; }
  std::size_t bytes() const override;

 private:
  std::vector<Index> dof_;
  std::vector<double> value_;
  LoadOrigin origin_;
};

}  // namespace ashlar::model
