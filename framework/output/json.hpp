#pragma once
// The run for machines: stages[] with probes, joints, balance and iterations; then mesh, timings, memory and
// effects. Valid JSON (what is no number becomes null), numbers that read back exactly.

#include <string>

#include "output/record.hpp"

namespace ashlar::output {

std::string results_json(const RunRecord& record);

}  // namespace ashlar::output
