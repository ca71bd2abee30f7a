#pragma once
// The stages of a checked scene, with what they inherit.

#include "model/scene_names.hpp"

namespace ashlar::model {

/// A stage that says `key = false` ends what it would inherit, also where `key` takes no boolean. Takes these
/// entries out of a scene's table, so that it can be checked against its schema.
core::Value without_ends(const core::Value& scene, const core::Registry& registry);

/// Supports by their names; words that name no edge are reported.
std::vector<SupportData> read_supports(const core::Settings& owner, const Names& names,
                                       core::Mistakes& mistakes);

/// The stages by name and place only: what others may refer to.
std::vector<StageData> read_stage_names(const core::Settings& root, core::Mistakes& mistakes);

/// Fills in parents, settings and supports. `said` is the scene's table before `without_ends`.
void read_stages(const core::Value& said, const core::Settings& root, const Names& names,
                 std::vector<StageData>& stages, core::Mistakes& mistakes);

}  // namespace ashlar::model
