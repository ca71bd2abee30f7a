#pragma once
// Words of a scene that name its parts: edges, regions, joints, lips, probes and stages.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "model/scene.hpp"

namespace ashlar::model {

struct Names {
  /// What may be referred to: "edge" → {"rock.bottom", "fault.upper" …}, "region", "joint", "lip", "probe",
  /// "stage", "picture".
  std::map<std::string, std::vector<std::string>> known;
  /// Edges of a mesh file show only when the file is read; those of a broken region not at all.
  bool edges_unknown = false;
};

/// A word that names a part of the scene, and where it stands.
struct NameUse {
  std::string word;
  std::string what;  ///< "edge", "region" … as Parameter::refers
  std::string kind;  ///< of the settings that say it: "stage", "water", "support" …
  core::Place place;
};

/// Calls `use` for every such word in `settings`, at any depth.
void visit_names(const core::Settings& settings, const core::Registry& registry,
                 const std::function<void(const NameUse&)>& use);

/// Reports `word` if the scene has no such edge, region, …
void check_name(const std::string& word, const std::string& what, const core::Place& place,
                const Names& names, core::Mistakes& mistakes);

/// Reports every word in `settings`, at any depth, that refers to something the scene does not have.
void check_names(const core::Settings& settings, const core::Registry& registry, const Names& names,
                 core::Mistakes& mistakes);

/// Warns of stages' loads on edges that are fully held: they move nothing.
void warn_of_held_loads(const Scene& scene, const core::Registry& registry);

/// What `outputs.pictures` may name.
std::vector<std::string> picture_words(const core::Registry& registry);

/// The names that regions, joints and stages bring.
Names collect_names(const Scene& scene);

}  // namespace ashlar::model
