#pragma once
// Scene → const Model: domain, mesh, materials, element, numbering.

#include "core/registry.hpp"
#include "model/effect.hpp"
#include "model/model.hpp"
#include "model/scene.hpp"

namespace ashlar::solve {

/// Meshes the scene and builds its model. Mistakes that need geometry (overlapping regions, joints outside …)
/// and those of materials and element go to `mistakes`; the model is of use only if there are none. Effects
/// may shape the mesh.
model::Model build_model(const model::Scene& scene, const model::Effects& effects, core::Registry& registry,
                         core::Mistakes& mistakes);

/// The part of it that needs no mesh: the arranged regions and joints. `check` stops here. Bodies that are
/// meshed apart lie in it side by side.
mesh::Domain build_domain(const model::Scene& scene, core::Mistakes& mistakes);

/// The materials by region, and nothing else: mistakes of laws show without a mesh. Null where the settings
/// are not complete.
std::vector<std::shared_ptr<const model::Material>> build_materials(const model::Scene& scene,
                                                                    core::Registry& registry,
                                                                    core::Mistakes& mistakes);

/// The dofs that a stage holds. Mistakes: an edge or box without mesh points, one dof held at two values.
model::Constraints build_constraints(const model::Model& model, const model::StageData& stage,
                                     core::Mistakes& mistakes);

/// Reports bodies that neither supports nor joints hold, each named with its free motions. A body that a
/// joint touches may be held by contact: only the march can tell.
void check_support(const model::Model& model, const model::Scene& scene, const model::StageData& stage,
                   const model::Constraints& constraints, core::Mistakes& mistakes);

/// ": 'dam' can slide in x; …" for the bodies that joints alone must hold: what a report adds when they do
/// not.
std::string loose_bodies(const model::Model& model, const model::Scene& scene,
                         const model::Constraints& constraints);

/// "(x, y)" of the node that carries a dof of the displacement, for messages.
std::string place_of_dof(const model::Model& model, mesh::Index dof);

}  // namespace ashlar::solve
