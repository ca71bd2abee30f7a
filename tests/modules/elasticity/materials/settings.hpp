#pragma once
// Settings as a script would give them, without a script.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/schema.hpp"

namespace ashlar::elasticity {

/// Entries whose number is missing were not said; places have the key as their path.
inline core::Settings settings_of(const std::string& law,
                                  const std::vector<std::pair<std::string, std::optional<double>>>& numbers) {
  core::Settings made;
  made.kind = "material";
  made.name = law;
  made.place = {"scene.lua", 2, "material"};
  for (const auto& [key, number] : numbers) {
    core::Settings::Entry entry;
    entry.key = key;
    if (number) entry.value = core::make_value(*number, {"scene.lua", 3, key});
    made.entries.push_back(entry);
  }
  return made;
}

}  // namespace ashlar::elasticity
