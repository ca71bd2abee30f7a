#pragma once
// outputs.sections → SectionData. Included by model/*.cpp only.

#include "model/scene.hpp"

namespace ashlar::model {

/// Mistakes: fewer than two points, neighbours that coincide, a line that ends where it begins, points and an
/// edge both, or neither.
std::vector<SectionData> read_sections(const core::Settings& outputs, core::Mistakes& mistakes);

}  // namespace ashlar::model
