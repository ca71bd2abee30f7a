#pragma once
// What a study asks: one scene, many settings of its parameters, and what is measured in each run.

#include <filesystem>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "model/scene.hpp"

namespace ashlar::study {

/// One parameter of the scene in one case.
struct Setting {
  std::string key;
  core::Value value;    ///< number with its unit, text or boolean; knows its place in the study
  bool differs = true;  ///< false: the same in all cases, which labels do not repeat
};

struct Case {
  std::vector<Setting> settings;
  std::string without;  ///< the effect that is left out to see what it costs; "" in all other cases
  core::Place place;
};

/// One number of a run, and what it is compared with.
struct Measure {
  std::string name;
  std::string title;  ///< "settlement of the crest"; its name by default
  std::string stage;
  std::string probe, minus;  ///< a probe, less another one
  std::string joint;
  std::string quantity;   ///< "uy", "max_slip"
  std::string cost;       ///< "iterations", "cpu" or "wall", instead of all that
  std::string effect;     ///< whose time it is; "" the whole run's
  std::string at;         ///< a path into the results for machines, instead of all that
  core::Value reference;  ///< a number, a function of the case, or the word "richardson", "finest" or "none"
  core::Settings settings;

  bool compared_with(const std::string& word) const { return reference.text() && *reference.text() == word; }
};

struct Study {
  std::string title;
  std::filesystem::path scene;
  std::vector<Case> cases;
  std::vector<Measure> measures;
  std::string refine;  ///< the parameter along which runs get finer; "" if there is none
  std::vector<std::string>
      problem;  ///< parameters that change what is asked: each value has its own reference
  int repeats = 1;
  int threads = 1;     ///< of one run
  bool files = false;  ///< runs write their pictures, tables and fields too
  core::Settings root;
};

/// The kinds "study" and "measure".
void register_study_kinds(core::Registry& registry);

/// Checks the table of `return Study { … }`; the scene's path is taken from the study's folder. All mistakes
/// that show without the scene go to `mistakes`.
Study read_study(const core::Value& value, const core::Registry& registry, core::Mistakes& mistakes);

/// What measures may name in the scene of one case.
struct Facts {
  std::vector<std::string> stages, joints;
  std::vector<model::ProbeData> probes;
  std::string inputs;  ///< everything else that the run depends on, as text: scripts, files, program
};
Facts facts_of(const model::Scene& scene);

/// Reports every measure that the case with these facts lacks.
void check_measures(const Study& study, const Facts& facts, core::Mistakes& mistakes);

/// SI unit of a measure's values: "m", "Pa", "N", "s"; "" where none is known.
std::string unit_of(const Measure& measure);

}  // namespace ashlar::study
