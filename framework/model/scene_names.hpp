#pragma once
// Words of a scene that name its parts: edges, regions, joints, lips, probes and stages.

#include <map>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "model/scene.hpp"

namespace ashlar::model {

struct Names {
  /// What may be referred to: "edge" → {"rock.bottom", "fault.upper" …}, "region", "joint", "lip", "probe",
  /// "stage".
  std::map<std::string, std::vector<std::string>> known;
  /// Edges of a mesh file show only when the file is read; those of a broken region not at all.
  bool edges_unknown = false;
};

/// Reports `word` if the scene has no such edge, region, …
void check_name(const std::string& word, const std::string& what, const core::Place& place,
                const Names& names, core::Mistakes& mistakes);

/// Reports every word in `settings`, at any depth, that refers to something the scene does not have.
void check_names(const core::Settings& settings, const core::Registry& registry, const Names& names,
                 core::Mistakes& mistakes);

/// The names that regions, joints and stages bring.
Names collect_names(const Scene& scene);

}  // namespace ashlar::model
