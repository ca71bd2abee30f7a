#include "model/place.hpp"

#include <algorithm>

#include "core/log.hpp"
#include "core/units.hpp"

namespace ashlar::model {

namespace {

constexpr core::Dimension metres{1, 0, 0};
// Farther off than this share of the local edge, a value belongs to another place than the one asked for.
constexpr double noticeable = 0.1;

double longest_edge_at(const mesh::Mesh& mesh, Index point) {
  double longest = 0;
  for (const auto& [from, to] : mesh.edge_points)
    if (from == point || to == point)
      longest = std::max(longest, geometry::distance(mesh.points[from], mesh.points[to]));
  return longest;
}

/// "fault.upper, fault.lower": the lips that one of these points lies on.
std::string lips_at(const mesh::Mesh& mesh, const std::vector<Index>& points) {
  std::string names;
  for (const mesh::JointLips& joint : mesh.joints)
    for (int side = 0; side < 2; ++side) {
      const bool here = std::ranges::any_of(joint.lips[side], [&](const mesh::LipEdge& edge) {
        return std::ranges::count(points, edge.from) + std::ranges::count(points, edge.to) > 0;
      });
      if (here) names += (names.empty() ? "" : ", ") + joint.name + "." + joint.sides[side];
    }
  return names;
}

}  // namespace

std::string place_text(Point at) {
  return "(" + core::format_quantity(at.x, metres) + ", " + core::format_quantity(at.y, metres) + ")";
}

std::vector<Index> points_together(const mesh::Mesh& mesh, Index point) {
  std::vector<Index> together;
  for (Index p = 0; p < mesh.point_count(); ++p)
    if (mesh.points[p] == mesh.points[point]) together.push_back(p);
  return together;
}

Index point_at(const mesh::Mesh& mesh, const PlaceInScript& where, core::Mistakes& mistakes) {
  const Index point = mesh::nearest_point(mesh, where.at, where.lip);
  if (point < 0) {
    mistakes.add(where.place, "the mesh has no lip '" + where.lip + "'",
                 core::did_you_mean(where.lip, mesh::edge_group_names(mesh)));
    return -1;
  }
  const double away = geometry::distance(where.at, mesh.points[point]);
  const double edge = longest_edge_at(mesh, point);
  if (away > edge) {
    mistakes.add(where.place, place_text(where.at) + " lies outside the mesh: its nearest point " +
                                  place_text(mesh.points[point]) + " is " +
                                  core::format_quantity(away, metres) + " away");
    return -1;
  }
  if (away > noticeable * edge)
    core::log().warning(core::to_string(where.place) + ": the mesh point " + place_text(mesh.points[point]) +
                        " is taken, " + core::format_quantity(away, metres) +
                        " from the place that was asked for");
  if (const auto together = points_together(mesh, point); where.lip.empty() && together.size() > 1) {
    mistakes.add(where.place, place_text(where.at) + " lies on a joint, whose sides move apart",
                 "say which side: lip = one of " + lips_at(mesh, together));
    return -1;
  }
  return point;
}

}  // namespace ashlar::model
