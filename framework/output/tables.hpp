#pragma once
// Results as CSV: one header row, comma, point as decimal sign, SI units in the header, numbers that read
// back exactly. What a stage does not have stays empty.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/results.hpp"

namespace ashlar::output {

/// One row per stage and probe: stage, probe, place, then the quantities.
std::string probes_csv(const model::RunResult& result);

/// A joint's rows and its welded tips, ascending in s. At a tip opening and slip are 0 and the pressure is
/// NaN: no contact point stands there.
std::vector<model::JointResult::Row> rows_and_tips(const model::JointResult& joint);

/// One row per stage and point of the joint, long format; welded tips have no pressure. Empty if no stage has
/// this joint.
std::string joint_csv(const model::RunResult& result, const std::string& joint);

/// One row per stage and place of the section's profile; what is not known there stays empty. Empty if no
/// stage has this section.
std::string section_csv(const model::RunResult& result, const std::string& section);
/// One row per stage and section: its ends, N, V and M in balance, by integration, and how far they are
/// apart.
std::string sections_csv(const model::RunResult& result);
/// "left", "right"; "both" where there is no jump.
std::string side_name(model::SectionResult::Side side);

/// One row per stage, step and iteration: residual and the facts that the terms gave.
std::string iterations_csv(const model::RunResult& result);

/// Names of all facts in the stages' iterations, in the order of their first appearance.
std::vector<std::string> fact_names(std::span<const model::StageResult> stages);
/// Nothing if the iteration has no such fact.
std::optional<double> fact_of(const model::Iteration& iteration, const std::string& name);

/// Names of all joints in the results, in the order of their first appearance.
std::vector<std::string> joint_names(const model::RunResult& result);

/// Names of all sections, likewise.
std::vector<std::string> section_names(const model::RunResult& result);

/// SI unit of a probed quantity or an iteration's fact: "m" for "ux", "Pa" for "sxx"; "" if unknown.
std::string quantity_unit(const std::string& quantity);

/// A text as one CSV field, quoted if it must be.
std::string csv_field(const std::string& text);

}  // namespace ashlar::output
