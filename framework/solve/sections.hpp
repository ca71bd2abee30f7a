#pragma once
// Sections: their lines through the mesh, and the forces over them. README.md beside this file has the
// equations.

#include "model/results.hpp"
#include "model/scene.hpp"

namespace ashlar::solve {

/// The scene's sections as lines through the mesh. Mistakes: a line outside the body, an edge group that is
/// no open line.
std::vector<mesh::SectionLine> section_lines(const model::Scene& scene, const model::Model& model,
                                             core::Mistakes& mistakes);

/// Names and places of the model's sections, for terms to fill in.
std::vector<model::SectionResult> begin_sections(const model::Model& model);

/// A committed stage.
struct SectionForcesInput {
  const model::Model& model;
  const model::Terms& terms;
  const fields::State& state;
  /// By dof: what supports and joints exert on the bodies [N].
  std::span<const double> outside;
};

/// The force that the left of a line exerts on the right, in equilibrium with the nodal forces, loads and
/// reactions on either side; about the line's middle.
model::SectionForces section_forces(const SectionForcesInput& stage, const mesh::SectionLine& line);

/// Fills in the forces of all sections, and how far their profiles are off; not in bodies of revolution.
void finish_sections(const SectionForcesInput& stage, std::vector<model::SectionResult>& sections);

}  // namespace ashlar::solve
