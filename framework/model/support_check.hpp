#pragma once
// Checks on the drawn geometry, before any mesh: places lie in the body, and supports hold it.

#include "mesh/domain.hpp"
#include "model/scene.hpp"

namespace ashlar::model {

/// Reports probes and point supports that lie outside every region. Scenes from mesh files are left alone.
void check_places(const Scene& scene, const mesh::Domain& domain, core::Mistakes& mistakes);

/// Reports bodies that no stage's supports hold against sliding and rotating, each with its free motions.
/// Regions that touch count as one body, also across joints: what contact must hold only the march can tell.
void check_support(const Scene& scene, const mesh::Domain& domain, core::Mistakes& mistakes);

}  // namespace ashlar::model
