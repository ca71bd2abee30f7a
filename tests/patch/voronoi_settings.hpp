#pragma once
// Settings of mesh.voronoi as its schema would give them, for tests that call the generator themselves.

#include <optional>

#include "core/schema.hpp"

namespace ashlar::patch {

struct VoronoiRequest {
  int cells = 100, seed = 1, iterations = 3;
  double collapse = 0;
};

inline core::Settings voronoi_settings(const VoronoiRequest& asked) {
  core::Settings settings;
  settings.kind = "mesh";
  settings.name = "voronoi";
  const auto add = [&](const char* key, std::optional<double> number) {
    core::Settings::Entry entry;
    entry.key = key;
    if (number) entry.value = core::make_value(*number);
    settings.entries.push_back(std::move(entry));
  };
  add("size", {});
  add("refine", {});
  add("cells", asked.cells);
  add("seed", asked.seed);
  add("iterations", asked.iterations);
  add("grading", 0.3);
  add("collapse", asked.collapse);
  return settings;
}

}  // namespace ashlar::patch
