#pragma once
// Places in the script → points of the mesh: one way for probes, point supports and point loads.

#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::model {

using geometry::Point;
using mesh::Index;

/// A place as the script says it.
struct PlaceInScript {
  Point at;
  std::string lip;    ///< "fault.upper", or empty
  core::Place place;  ///< for messages
};

/// The mesh point nearest to a place. A place outside the mesh, or one where a joint has parted the points
/// and no lip is named, is a mistake (-1). A point that is noticeably off the place is said in the log.
Index point_at(const mesh::Mesh& mesh, const PlaceInScript& where, core::Mistakes& mistakes);

/// "(3 m, 1.5 m)".
std::string place_text(Point at);

/// All mesh points at the same place as this one: more than one where joints have parted them.
std::vector<Index> points_together(const mesh::Mesh& mesh, Index point);

}  // namespace ashlar::model
