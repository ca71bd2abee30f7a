#pragma once
// Everything that is known of a run when it is written: references to what the straight line made.

#include <string>
#include <utility>
#include <vector>

#include "core/ledger.hpp"
#include "core/log.hpp"
#include "mesh/mesh.hpp"
#include "model/model.hpp"
#include "model/plan.hpp"
#include "model/results.hpp"
#include "model/scene.hpp"

namespace ashlar::output {

/// One file of the scenario, as it was read.
struct Source {
  std::string name;
  std::string text;
};

/// A `param` of the scenario, with the value used.
struct ParameterValue {
  std::string name;
  std::string value;
  bool set = false;  ///< by --set; otherwise the scenario's default
};

struct RunRecord {
  const model::Scene& scene;
  const model::Plan& plan;
  const model::Model& model;
  const model::RunResult& result;
  const mesh::MeshReport& mesh_report;
  const core::Ledger& ledger;
  const core::Log& log;
  std::vector<Source> sources;
  std::vector<ParameterValue> parameters;
  std::vector<std::pair<std::string, std::string>> versions;  ///< program first, then libraries
  std::vector<std::string> modules;                           ///< whose libraries were opened
  std::string command_line;
  int threads = 1;
};

}  // namespace ashlar::output
