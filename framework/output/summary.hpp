#pragma once
// What a run says at its end, for people: at most 96 columns, aligned, engineering units. Each function
// builds one paragraph (empty if it has nothing to say).

#include <filesystem>
#include <string>
#include <vector>

#include "output/record.hpp"

namespace ashlar::output {

/// All paragraphs in order.
std::string summary(const RunRecord& record, const std::vector<std::filesystem::path>& files);

/// Which effects each stage had, which stages did not end or were not run, and what was left out and when
/// that matters.
std::string simulated_text(const model::Plan& plan, const model::RunResult& result);
std::string mesh_text(const mesh::MeshReport& report, const model::Model& model);
/// Loads against reactions, one block a stage.
std::string balance_text(const model::RunResult& result, model::Plane plane);
/// Least and greatest values of the last stage that converged with their places.
std::string extremes_text(const model::RunResult& result);
/// Displacements and principal stresses at the probes, all stages.
std::string probes_text(const model::RunResult& result);
/// N, V and M over the sections, in balance and by integration, all stages.
std::string sections_text(const model::RunResult& result);
std::string joints_text(const model::RunResult& result);
/// Distances from solutions that the scene knows.
std::string norms_text(const model::RunResult& result);
std::string iterations_text(const model::RunResult& result);
/// Of the stage that did not converge: why, what to try, its last iterations.
std::string failure_text(const model::RunResult& result);
/// Time by phase and effect, memory at its peak.
std::string costs_text(const core::Ledger& ledger);
std::string files_text(const std::vector<std::filesystem::path>& files);

}  // namespace ashlar::output
