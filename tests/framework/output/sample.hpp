#pragma once
// A made-up run to write: a dam on a jointed foundation in brick-like cells, with smooth displacements that
// jump at the joint and stresses that peak at its tip. Nothing here is computed by a solver.

#include <filesystem>
#include <string>

#include "output/record.hpp"

namespace ashlar::output {

struct Sample {
  model::Scene scene;
  model::Plan plan;
  model::Model model;
  model::RunResult result;
  mesh::MeshReport report;
  core::Ledger ledger;
  core::Log log;
  RunRecord record() const;
};

/// `fineness` squares a metre; about 525·fineness²·0.55 cells.
Sample make_sample(int fineness);

/// A new empty folder under the system's place for such; the name tells the test.
std::filesystem::path fresh_folder(const std::string& name);

/// A whole file as bytes; empty if there is none.
std::string slurp(const std::filesystem::path& path);

}  // namespace ashlar::output
