#pragma once
// Bodies that are meshed apart: which regions are arranged and meshed together, and what they become as one.

#include "mesh/domain.hpp"
#include "mesh/mesh.hpp"

namespace ashlar::mesh {

/// One domain for each group of regions, ordered by their first region. Regions that share a border are of
/// one group, but where the border is that of both `faces` of a joint; so are those that a joint has
/// `between` them. Without `faces` joints there is one domain, that of make_domain. A group's domain holds
/// its own regions and joints, and every joint that has `faces`. Mistakes besides those of make_domain: the
/// bodies of a `faces` joint hang together elsewhere, one of its edges is not on the border of its body, a
/// joint's path runs through two groups. The two bodies of a `faces` joint may overlap where both faces bound
/// the overlap; how far is for the contact to measure.
std::vector<Domain> make_domains(const std::vector<RegionShape>& regions,
                                 const std::vector<JointLine>& joints, double chord,
                                 core::Mistakes& mistakes);

/// All domains as one, for questions about places: points and segments side by side, not arranged.
Domain together(const std::vector<Domain>& domains);

/// All meshes as one, cells and points in their order; `regions` are the names that cells are numbered by.
Mesh merge(std::vector<Mesh> parts, const std::vector<std::string>& regions);

}  // namespace ashlar::mesh
